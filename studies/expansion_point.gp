# expansion_point: radius of convergence and rate against the energy, and the rate against the expansion point.
#
# For any equation: the radius about each time, the distance of the nearest singularity from the real axis, and the rate
# on the whole interval, one column of three panels per unknown, one curve per combination of the parameters (of the
# largest order).
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('time')
    eval extent('orders', main, 'order', '1')
    always = "at('order') == orders_high"
    title_text = 'Where to expand '.called
    below_text = sprintf('from %.0f powers about each time', orders_high)
    rows_down = 3; height = 360
    x = 'time'; x_name = 'expansion point / unit of the variable'
    y_axis = 'set yrange [0:*]'
    prepare = "set offsets; if (row == 1) { panel_title = this.': radius'; y_name = 'radius R / unit of the variable'; layers = radii } else { if (row == 2) { panel_title = this.': nearest singularity'; y_name = '|Im t| / unit of the variable'; layers = distances } else { panel_title = this.': rate on the whole interval'; y_name = 'reach/R'; layers = rates } }"
    curve_style = 'linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)'
    radii = by_hue('radius', '1', curve_style)
    distances = by_hue("abs(at('position_im'))", "has('position_im')", curve_style)
    rates = "1 with lines lc rgb '#888888', ".by_hue('rate', '1', curve_style)
    key = hue_by eq '' ? '' : key_of_hues(curve_style)
    entries = shown_in_key(cases); letters = 20
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
table = data.'/expansion_point.csv'
eval seen('energies', table, 'energy', '1')
eval energy_names(table)
eval count_of('measured', table, "has('measured_rate')")
eval extent('gap', table, 'gap', '1')
rate_drawn = measured ? 'measured_rate' : 'rate'
point_name(p) = p eq '0' ? '0 (top)' : p eq '1' ? '1 (bottom)' : p
if (words(energies) > 1) {
    figure = 'expansion_point'
    title_text = 'One expansion for the whole way from the top to the bottom: its radius and its rate'
    below_text = 'x is the expansion point as a fraction of T*'
    panels = 'radius rate'; y_name_everywhere = 1; height = 480
    hue_by = 'point'
    eval seen('hues', table, 'point', '1')
    hue_name(p) = 'x = '.point_name(p)
    # Against the distance from E = 2 if all energies are near it.
    near = gap_high < 0.2 && gap_low > 0
    x = near ? "log10(at('gap'))" : 'energy'; x_name = near ? gap_axis : e_axis
    x_axis = near ? falling('x', log10(gap_low), log10(gap_high)) : 'eval energies_on_x(x_low, x_high); eval separatrix_on_x(x_low, x_high)'
    hue(h) = colour(h, words(hues))
    prepare = "set offsets; panel_title = ''; set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1; set label 3 (p == 1 ? 'R = T*' : 'diverges on a part of the way') at graph 0.98, first 1 right offset 0, p == 1 ? -0.7 : 0.7 textcolor rgb soft; y_name = p == 1 ? 'radius of convergence R/T*' : 'factor of the error on [0, T*] a power'; layers = p == 1 ? radii : rates"
    y_axis = 'set yrange [0:*]'
    finish = 'unset label 3; if (p == 2) { eval energies_done }'
    radii = by_hue("at('radius') / at('tstar')", '1', 'linespoints lw 2 pt mark_of(h) ps 0.5 lc rgb hue(h)')
    rates = by_hue('rate', '1', 'lines lw 2 lc rgb hue(h)').', '.by_hue(rate_drawn, '1', 'points pt mark_of(h) ps (measured ? 0.9 : 0.4) lw 1.3 lc rgb hue(h)')
    key = key_of_hues('linespoints lw 2 pt mark_of(h) ps 0.8 lc rgb hue(h)').', '.key_entry('lines lw 2 lc rgb soft', "'max(x, 1−x) T*/R'") \
        .', '.key_entry('points pt 4 ps 0.9 lw 1.3 lc rgb soft', "measured ? 'measured' : ''")
    entries = shown_in_key(words(hues)) + 2
    load scripts.'/shared/panels.gp'
}

# Against the expansion point, for at most six of the energies; a single energy has this figure alone.
figure = words(energies) > 1 ? 'expansion_point_rate' : 'expansion_point'
n = smaller(words(energies), 6)
hues = ''
do for [h=1:n] { hues = hues.' '.pick(energies, n, h) }
array K[n]
do for [h=1:n] {
    eval first_cell('tstar', table, 'tstar', "is('energy', word(hues, h))")
    eval first_cell('height_over', table, 'height', "is('energy', word(hues, h))")
    K[h] = number(height_over) / number(tstar)
}
rate(x, k) = (x > 0.5 ? x : 1 - x) / sqrt((1 - x)**2 + k**2)
hue_by = 'energy'; hue_name(E) = 'E = '.named_energy(E)
title_text = 'The expansion point that covers [0, T*] at the best rate is T*/2'
below_text = 'above 1 the expansion diverges at an end of the way'
x = 'point'; x_name = 'expansion point, fraction x of T* (0 the top, 1 the bottom)'; x_axis = 'set xrange [0:1]; set samples 401'
y_name = 'factor of the error on [0, T*] a power'; y_axis = 'set yrange [0:*<2]'
prepare = "set offsets; set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888'; set arrow from 0.5, graph 0 to 0.5, graph 1 nohead lc rgb '#888888' dt 3"
layers = 'for [h=1:n] rate(x, K[h]) with lines lw 2 dt h lc rgb shade[h]' \
    .', '.by_hue(rate_drawn, '1', 'points pt mark[h] ps 1.2 lw 1.5 lc rgb shade[h]')
key = key_of_hues('linespoints lw 2 dt h pt mark[h] lc rgb shade[h]').', '.key_entry('lines lw 2 lc rgb soft', "'max(x, 1−x) T*/R'") \
    .', '.key_entry('points pt 4 ps 1.2 lw 1.5 lc rgb soft', "measured ? 'measured' : ''")
entries = n + 2
load scripts.'/shared/panels.gp'
