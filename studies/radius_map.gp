# radius_map: estimated and exact radius against the expansion point, and the relative error of the verdicts.
#
# For any equation: against one parameter the radius and its relative uncertainty, one column of panels per unknown and
# one curve per order (and combination of the other parameters); against two or more parameters the plane of the first
# two of them, coloured by the radius of the largest order.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('order')
    eval longest_axis('order')
    title_text = 'Radius of convergence of '.called
    if (words(axes) >= 2 && values[1] > 2 && values[2] > 2) {
        hue_by = ''; hues = '-'
        eval extent('orders', main, 'order', '1')
        eval extent('a', main, '1', '1')
        eval extent('b', main, '2', '1')
        below_text = sprintf('from %.0f powers about the start', orders_high)
        always = "at('order') == orders_high"
        half_a = 0.5 * (a_high - a_low) / (values[1] - 1); half_b = 0.5 * (b_high - b_low) / (values[2] - 1)
        x = '1'; x_name = word(axes, 1); y_name = word(axes, 2)
        x_axis = "set xrange [a_low - half_a:a_high + half_a]; set yrange [b_low - half_b:b_high + half_b]; eval quarters('x', a_low, a_high); eval quarters('y', b_low, b_high)"
        prepare = "panel_title = 'R of '.this; set rmargin 12; set style fill solid noborder; set palette defined (0 '#440154', 0.25 '#31688e', 0.5 '#218f8d', 0.75 '#35b779', 1 '#fde725')"
        layers = rows(table, x, '2', of_panel("has('radius')")).":(half_a):(half_b):(at('radius')) with boxxyerror lc palette"
    } else {
        below_text = 'from coefficients about the start'
        eval other_axes('order', 'N')
        rows_down = 2; height = 380
        x = along; x_name = along_name; x_axis = "eval rising('x', x_low, x_high); eval quarters('x', x_low, x_high)"
        # From 0 on, unless the radii differ by less than a fifth of themselves.
        axis_of(low, high) = high > low && high - low < 0.2 * high ? sprintf('set yrange [%.12g:%.12g]', low - 0.1 * (high - low), high + 0.1 * (high - low)) : 'set yrange [0:*]'
        prepare = "set offsets; if (row == 1) { y_name = 'radius R'; eval extent('r', main, 'radius', of_panel(\"has('radius')\")); y_axis = axis_of(r_low, r_high); layers = radius } else { y_name = 'log_{10} (uncertainty/R)'; panel_title = this.': how certain'; y_axis = ''; layers = certainty }"
        radius = by_hue('radius', '1', 'linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)')
        certainty = by_hue('log10_relative_uncertainty', '1', 'linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)')
        key = key_of_hues('linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)')
        entries = shown_in_key(words(hues)); letters = 20
    }
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
figure = 'radius_map'
table = data.'/radius_map.csv'
title_text = 'Radius of convergence about each point of the way from the top to the bottom'
below_text = 'exactly (lines) and from coefficients alone (marks)'
panel_by = 'order'; most_panels = 3; rows_down = 3; height = 350
hue_by = 'energy'
eval seen('hues', table, 'energy', '1')
eval energy_names(table)
hue_name(E) = 'E = '.named_energy(E)
n = words(hues)
# The height of the singularities over T*, of which radius and rate are functions of the expansion point.
array K[n]
do for [h=1:n] {
    eval first_cell('tstar', table, 'tstar', "is('energy', word(hues, h))")
    eval first_cell('height_over', table, 'height', "is('energy', word(hues, h))")
    K[h] = number(height_over) / number(tstar)
}
radius(x, k) = sqrt((1 - x)**2 + k**2)
rate(x, k) = (x > 0.5 ? x : 1 - x) / radius(x, k)
eval extent('errors', table, 'log10_relative_error', '1')
lowest = int(smaller(-4, errors_low)) - 2
x = 'point'; x_name = 'expansion point, fraction x of T*'; x_axis = 'set xrange [-0.02:1.02]; set samples 201'
marks = 'points pt mark_of(h) ps 0.8 lw 1.3 lc rgb colour(h, n)'
line = ' with lines lw 1.8 dt line_of(h) lc rgb colour(h, n)'
radii = 'for [h=1:n] [0:1] radius(x, K[h])'.line.', '.by_hue("at('radius') / at('tstar')", '1', marks)
rates = 'for [h=1:n] [0:1] rate(x, K[h])'.line.', '.by_hue('rate', '1', marks)
errors = by_hue("is('log10_relative_error', '-inf') ? lowest : at('log10_relative_error')", "has('log10_relative_error')", marks)
prepare = "set offsets; eval word_of_row"
word_of_row = "if (row == 1) { panel_title = 'N = '.this.': radius'; y_name = 'R/T*'; y_axis = 'set yrange [0:*]'; layers = radii } else { if (row == 2) { panel_title = 'N = '.this.': rate on [0, T*]'; y_name = 'max(x, 1 − x) T*/R'; layers = rates; set arrow from 0.5, graph 0 to 0.5, graph 1 nohead lc rgb '#888888' dt 3; set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888'; set label 2 'above 1: diverges at an end' at graph 0.03, graph 0.95 textcolor rgb soft } else { panel_title = 'N = '.this.': relative error of R'; y_name = 'log_{10} |R estimated/R − 1|'; y_axis = 'set yrange [lowest:1]'; layers = errors } }"
finish = 'unset label 2'
key = key_of_hues('linespoints lw 1.8 dt line_of(h) pt mark_of(h) ps 0.8 lc rgb colour(h, n)')
entries = shown_in_key(n); letters = 12
load scripts.'/shared/panels.gp'
