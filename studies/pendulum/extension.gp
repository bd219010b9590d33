# The studies of extension.cpp: theta against the time in periods, the error below; one column per energy, three at
# most.
load scripts.'/style.gp'
figure = stem
table = data.'/'.stem.'.csv'
numerical = data.'/'.stem.'_numerical.csv'
exact = data.'/'.stem.'_exact.csv'
eval energy_names(table)
eval first_cell('method', table, 'method', '1')
below_text = 'T is the period; vertical lines at the multiples of T*, a quarter or half of it'
title_text = 'The '.(method eq 'resummed' ? 'resummation' : 'series from the top').', extended periodically: ' \
    .(stem eq 'libration_series' ? 'libration' : stem eq 'rotation_series' ? 'rotation' : 'near the separatrix')
panel_by = 'energy'; most_panels = 3; rows_down = 2
hue_by = 'order'; hue_name(N) = 'N = '.N
eval seen('hues', table, 'order', '1')
n = words(hues)
array dashes[6] = ['_', '-', '.', '_.', '-.', '_..']
dash(h) = method eq 'resummed' || n > 6 ? 1 : dashes[h]
x = 'periods'; x_name = 'time t / T'
# T* is a quarter of a period below E = 2, half of it above.
multiples = "marks = substr(gap_of(this), 1, 1) eq '-' ? 2 : 4; do for [q=ceil(x_low * marks):floor(x_high * marks)] { set arrow from q / (1.0 * marks), graph 0 to q / (1.0 * marks), graph 1 nohead back lw 0.8 lc rgb (q % marks ? '#dddddd' : '#999999') }"
x_axis = "set xrange [x_low:x_high > x_low ? x_high : x_low + 1]; if (row == 1) { eval upper_panel } else { eval lower_panel }"
y_axis = "if (row == 1) { eval extent('y', exact, 'theta', of_panel('1')); eval rising_in_pi } else { eval extent('y', table, 'log10_error', of_panel('1')); set yrange [larger(y_low - 0.5, -20):larger(y_high, -12) + 0.5] }"
prepare = "eval extent('x', exact, 'periods', of_panel('1')); eval multiples; panel_title = row == 1 ? 'E = '.named_energy(this) : ''; y_name = row == 1 ? 'angle θ / rad' : error_axis; layers = row == 1 ? angles : errors"
finish = "set ytics autofreq; set format y '%g'"
broken(file, y, where, style) = broken_rows(file, x, y, where).' with '.style.' notitle'
by_order(y) = 'for [h=1:n] '.broken(table, y, of_hue('1'), 'lines lw 2.3 dt dash(h) lc rgb colour(h, n)')
march = "points pt 6 ps 0.8 lw 1.2 lc rgb '#000000'"
angles = broken(exact, 'theta', of_panel('1'), "lines lw 1 lc rgb '#888888'").', '.by_order('theta').', '.broken(numerical, 'theta', of_panel('1'), march)
errors = by_order('log10_error').', '.broken(numerical, 'log10_error', of_panel('1'), march)
key = key_of_hues('lines lw 2.3 dt dash(h) lc rgb colour(h, n)').', '.key_entry("lines lw 1 lc rgb '#888888'", "'exact'") \
    .', '.key_entry(march, "'Runge-Kutta (RK4)'")
entries = shown_in_key(n) + 2
load scripts.'/shared/panels.gp'
