# series_against_laws: stated uncertainty and true error of the verdict on each list, a panel for each number of coefficients.
load scripts.'/style.gp'
figure = 'series_against_laws'
table = data.'/series_against_laws.csv'
title_text = 'The verdict on coefficients against proved laws'
below_text = 'relative error of the radius against the proved one, and the stated uncertainty'
panel_by = 'order'; most_panels = 3
eval seen('names', table, 'problem', '1')
n = words(names)
place_of(name) = (place_ = 0, sum [i_=1:n] (word(names, i_) eq name ? (place_ = i_) : 0), place_)
width = 430; height = 130 + 20 * n
floor_of(y) = log10(larger(y, 1e-31))
x = "floor_of(at('relative_uncertainty'))"; x_name = 'log_{10} of the relative error'
x_axis = "set xrange [-31.5:1]; set yrange [n + 0.5:0.5]; set ytics scale 0 noenhanced; set xtics 10"
prepare = "set lmargin 17; panel_title = 'N = '.this; set ytics ('' 0); do for [i=1:n] { set ytics add (word(names, i) i) }"
finish = 'set ytics autofreq scale 1 enhanced; set xtics autofreq'
row_of_problem = "place_of(strcol('problem'))"
layers = rows(table, x, row_of_problem, of_panel("has('relative_uncertainty')")).' with points pt 6 ps 1 lw 1.6 lc rgb shade[5] notitle' \
    .', '.rows(table, "floor_of(at('relative_error'))", row_of_problem, of_panel("has('relative_error')")).' with points pt 7 ps 0.8 lc rgb shade[2] notitle' \
    .', '.rows(table, '(0.3)', row_of_problem, of_panel("!has('relative_error')")).' with points pt 2 ps 0.8 lc rgb "#888888" notitle'
key = key_entry('points pt 6 ps 1 lw 1.6 lc rgb shade[5]', "'stated uncertainty'").', '.key_entry('points pt 7 ps 0.8 lc rgb shade[2]', "'true error'") \
    .', '.key_entry("points pt 2 ps 0.8 lc rgb '#888888'", "'no radius stated'")
entries = 3; letters = 26
load scripts.'/shared/panels.gp'
