# radius_tournament: correct digits by method, order and scalar, ranked; and the fraction of errors that are within the
# uncertainties.
#
# For any equation: the distance of each test from the proved radius, or from the verdict for a longer list, against the
# order; one panel per unknown, for the first combination of the parameters.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval first_case('order')
    title_text = 'Radius tests on '.called
    below_text = '|R of the test/R − 1| over the order'.in_first
    hue_by = 'method'
    eval seen('hues', main, 'method', '1')
    hue_name(m) = test_name(m)
    tone(h) = h == 1 ? '#000000' : colour(h, larger(words(hues), 7))
    prepare = "eval first_cell('truth', main, 'truth', of_panel('1')); panel_title = this.': against R '.(truth eq 'verdict' ? 'of a longer list' : truth)"
    x = 'order'; x_name = 'order N'; y_name = 'log_{10} |R of the test/R − 1|'; y_together = 'log10_difference'
    layers = by_hue('log10_difference', '1', 'linespoints lw h == 1 ? 2.6 : 1.2 pt mark_of(h) ps 0.6 lc rgb tone(h)')
    key = 'for [h=1:words(hues)] '.key_entry('linespoints lw h == 1 ? 2.6 : 1.2 pt mark_of(h) ps 0.7 lc rgb tone(h)', 'hue_name(word(hues, h))')
    entries = words(hues); letters = 26
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
ranking = data.'/radius_tournament_ranking.csv'
coverage = data.'/radius_tournament_coverage.csv'
eval seen('scalars', ranking, 'scalar', '1')
eval seen('orders', ranking, 'order', '1')
last_scalar = word(scalars, words(scalars))
last_order = word(orders, words(orders))
# The methods as ranked by the last scalar and the largest order, the best at the top.
eval seen('methods', ranking, 'method', "is('scalar', last_scalar) && is('order', last_order)")
count = words(methods)
place(m) = sum [i=1:count] (word(methods, i) eq m ? count + 1 - i : 0)
eval extent('digits', ranking, 'mean_digits', '1')
array mark[6] = [4, 8, 6, 12, 10, 2]
panels = words(scalars) + 1
# Three strips: heading, key of the orders, and key of the right panel with the axis.
left = 0.2
wide_of_panel = (0.985 - left) / panels
middle = wide_of_panel * words(scalars) + left
ranked = rows(ranking, "at('mean_digits')", "place(strcol('method'))", "is('scalar', s) && is('order', word(orders, k))")
covered = "is('half', 'judged') && !is('method', 'all')"
near(x) = x < 0.825 ? 0.825 : x
within = rows(coverage, "near(at('covered'))", "place(strcol('method'))", covered." && is('scalar', word(scalars, p))")
medians = rows(coverage, '(0.8)', "place(strcol('method'))", covered." && is('scalar', last_scalar)").":(sprintf('%.3g', at('median_uncertainty_over_error')))"
method_tics = "unset ytics; do for [i=1:count] { set ytics add (p == 1 ? test_name(word(methods, i)) : '' count + 1 - i) scale 0 }"

do for [kind in terminals] {
    eval use_terminal(kind, target.'/radius_tournament', 1280, 90 + 38 * count + 130)
    set multiplot
    set label 1 'Radius of convergence from coefficients alone: a tournament of tests' at screen 0.5, 0.97 center font ',16'
    set yrange [0.4:count + 0.6]
    set border 1 lc rgb '#444444'
    set grid noxtics ytics lc rgb '#eeeeee' lw 1
    set tmargin at screen 0.87
    set bmargin at screen 0.21
    set xrange [0:digits_high * 1.06 + 0.5]
    set xlabel 'correct digits, mean'
    do for [p=1:words(scalars)] {
        s = word(scalars, p)
        set lmargin at screen left + (p - 1) * wide_of_panel
        set rmargin at screen left + p * wide_of_panel - 0.02
        eval method_tics
        set label 4 (p == 1 ? 'in ' : '').arithmetic_name(s) at graph 0, 1.03 left textcolor rgb '#222222'
        if (p == 1) { set key at screen left + wide_of_panel, 0.055 center horizontal samplen 1 width 1 font ',14' } else { unset key }
        eval 'plot for [k=1:words(orders)] '.ranked." with points pt mark_of(k) ps 1.1 lw 1.8 lc rgb colour(k, words(orders)) title in_key(k, words(orders)) ? 'N = '.word(orders, k) : ''"
        unset label 1
    }
    p = panels
    set lmargin at screen middle
    set rmargin at screen 0.985
    eval method_tics
    set xrange [0.78:1.01]
    set xtics 0.8, 0.05, 1
    set xlabel 'errors within the uncertainty'
    set arrow 1 from 0.95, graph 0 to 0.95, graph 1 nohead lc rgb '#888888' dt 3
    set label 2 'required: 0.95' at 1.01, graph 1.03 right textcolor rgb '#555555' font ',13'
    set label 3 "median of\nuncertainty/error" at 0.785, graph 1.055 left textcolor rgb '#555555' font ',13'
    unset label 4
    set key at screen (middle + 0.985) / 2, 0.055 center horizontal samplen 1 width 1 font ',14'
    last = words(scalars)
    eval 'plot for [p=1:last] '.within.' with points pt (p == last ? 7 : 6) ps (p == last ? 1.1 : 1.6) lw 1.5 lc rgb shade[p == last ? 5 : 4] title arithmetic_name(word(scalars, p)), '.medians." with labels font ',13' textcolor rgb '#333333' notitle"
    eval figure_done
}
