# problems: small panels, one per problem of the catalogue: its solution, the size of its coefficients, and its nearest
# singularities around the initial point.
load scripts.'/style.gp'
nearest = data.'/problems_singularities.csv'
eval seen('names', data.'/problems.csv', 'problem', '1')
# The rows of a table are read once for all panels: the first and the last of each problem, which are next to each other.
array first_row[words(names)]
array last_row[words(names)]
found(name, row) = (k_ = sum [i=1:words(names)] (word(names, i) eq name ? i : 0), k_ ? (last_row[k_] = row, row < first_row[k_] ? (first_row[k_] = row) : 0) : 0)
find_rows(file) = "do for [i=1:words(names)] { first_row[i] = 1e9; last_row[i] = -1 }; ".every_row(file, "found(strcol('problem'), int(column(0)))")
rows_here = "row_range = sprintf('every ::%d::%d', first_row[p], last_row[p]); eval extent('x', table, x, '1'); eval extent('y', table, y, '1')"
small = "row_range = ''; set lmargin 6; set rmargin 1.5; set tmargin 1.8; set bmargin 2; set xtics font ',9'; set ytics font ',9'; eval seen('unknowns', nearest, 'unknown', of_panel('1')); shown = smaller(words(unknowns), 6); panel_title = problem_name(this); set title font ',11'; "
by_unknown = "layers = 'for [i=1:shown] '.rows(table, x, y, \"is('unknown', word(unknowns, i))\").' with '.style.' notitle'; row_range = ''"
settings = "panel_by = 'problem'; panels = names; most_panels = words(names); most_across = 6; width = words(names) < 3 ? 420 : 250; height = words(names) < 3 ? 300 : 190"

eval settings
figure = 'problems'
table = data.'/problems.csv'
eval find_rows(table)
title_text = 'Solutions of the catalogue'
below_text = 'each unknown from the start on, over its variable; six at most'
x = 'time'; y = 'value'; style = 'lines lw 1.5 lc rgb shade[i]'
prepare = small.rows_here."; set xtics (x_low, x_high) format '%.3g'; set ytics format '%.2g'; ".by_unknown
x_axis = "eval rising('x', x_low, x_high); eval rising('y', y_low, y_high)"
load scripts.'/shared/panels.gp'

eval settings
figure = 'problems_coefficients'
table = data.'/problems_coefficients.csv'
eval find_rows(table)
title_text = 'Coefficients of the catalogue'
below_text = 'log_{10} |a_n| over n, about the start'
x = 'n'; y = 'log10_abs'; style = 'points pt 7 ps 0.25 lc rgb shade[i]'
prepare = small.rows_here.'; '.by_unknown
x_axis = "eval rising('x', 0, x_high); eval rising('y', y_low, y_high)"
load scripts.'/shared/panels.gp'

eval settings
figure = 'problems_singularities'
table = nearest
title_text = 'Nearest singularities of the catalogue'
below_text = 'in the complex plane of the distance from the start, by radius tests (heuristic); the circle is that of convergence'
x = 'position_re'
around = "set size ratio -1; set parametric; set trange [0:2 * pi]; far = 1.25 * larger(r_low, smaller(3 * r_low, r_high)); set xtics (0); set xtics add (sprintf('%.3g', r_low) r_low); set ytics (0); layers = circle"
nothing = "r_low = 0; far = 1; set xtics (0); set ytics (0); set label 7 'no radius seen' at 0, 0.3 center textcolor rgb soft font ',10'; layers = 'NaN'"
prepare = small."eval count_of('radii', table, of_panel(\"has('radius')\")); eval extent('r', table, 'radius', of_panel('1')); if (radii) { eval around } else { eval nothing }"
x_axis = 'set xrange [-far:far]; set yrange [-far:far]'
finish = 'unset label 7; unset parametric; set size noratio'
circle = "r_low * cos(t), r_low * sin(t) with lines lw 1 lc rgb '#999999'"
do for [side in '1 -1'] { circle = circle.', for [i=1:shown] '.rows(nearest, 'position_re', side." * at('position_im')", of_panel("is('unknown', word(unknowns, i)) && has('position_im')")).' with points pt mark[i] ps 0.8 lw 1.2 lc rgb shade[i]' }
load scripts.'/shared/panels.gp'
