# period_effect: theta against the time, extended with the T* of each rule, and the error below; one column per energy,
# three at most. If there are several orders N, the first is drawn.
load scripts.'/style.gp'
figure = 'period_effect'
table = data.'/period_effect.csv'
numerical = data.'/period_effect_numerical.csv'
eval energy_names(table)
eval first_cell('order', table, 'order', '1')
title_text = 'The resummation (N = '.order.') extended with an inexact T*'
below_text = 'the key names the sum from which T* is computed'
panel_by = 'energy'; most_panels = 3; rows_down = 2
hue_by = 'period_by'; hue_name(r) = rule_name(r)
eval seen('hues', table, 'period_by', '1')
n = words(hues)
# Long dashes for (Kold); for (Knew) the last rule solid and those before it dashed; the exact T* a thin grey line.
last_resummed = 0
do for [i=1:n] { if (word(hues, i)[1:1] eq 'r') { last_resummed = i } }
array dashes[4] = ['-', '.', '-.', '-..']
dash(i) = word(hues, i)[1:1] eq 's' ? '_' : (word(hues, i)[1:1] eq 'a' || i == last_resummed) ? 1 : dashes[(i-1)%4+1]
hue(i) = word(hues, i) eq 'agm' ? '#888888' : n > 6 ? colour(i, n) : shade[(7-i)%6+1]
line = "lines lw (word(hues, h) eq 'agm' ? 1.2 : 2.3) dt dash(h) lc rgb hue(h)"
march = "points pt 7 ps 0.6 lc rgb '#000000'"
x = 'periods'; x_name = 'time t / T, T exact'
x_axis = "eval extent('x', table, 'periods', of_panel('1')); set xrange [x_low:x_high > x_low ? x_high : x_low + 1]; if (row == 1) { eval upper_panel } else { eval lower_panel }"
y_axis = "eval extent('y', table, row == 1 ? 'theta' : 'log10_error', of_panel('1')); if (row == 1) { eval rising_in_pi } else { set yrange [larger(y_low, -14) - 0.5:larger(y_high, larger(y_low, -14) + 1) + 0.5] }"
prepare = "panel_title = row == 1 ? 'E = '.named_energy(this) : ''; y_name = row == 1 ? 'angle θ / rad' : error_axis; layers = row == 1 ? angles : errors"
finish = "set ytics autofreq; set format y '%g'"
both_of(y) = 'for [h=1:n] '.broken_rows(table, x, y, of_hue("is('order', order)")).' with '.line.' notitle, '.broken_rows(numerical, x, y, of_panel('1')).' with '.march.' notitle'
angles = both_of('theta')
errors = both_of('log10_error')
key = key_of_hues(line).', '.key_entry(march, "'Runge-Kutta (RK4)'")
entries = shown_in_key(n) + 1; letters = 20
load scripts.'/shared/panels.gp'
