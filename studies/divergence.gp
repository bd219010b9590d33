# divergence: partial sums about the bottom against the exact angle (above) and their error (below), one column per
# energy.
#
# For any equation: the solution and its partial sums against time, one panel per unknown, for the first combination of
# the parameters; dotted lines at the radius of convergence on either side of the initial point.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    radii = table_of('_radius')
    eval first_case('order')
    title_text = 'Partial sums of '.called
    below_text = 'about the start'.in_first
    hue_by = 'order'; hue_name(N) = 'N = '.N
    x = 'time'; x_name = 'time / unit of the variable'
    y_axis = "eval extent('y', table, 'solution', of_panel('1')); set yrange [y_low - larger(0.4 * (y_high - y_low), 1e-9):y_high + larger(0.4 * (y_high - y_low), 1e-9)]"
    prepare = "y_name = this; eval first_cell('r', radii, 'radius', of_panel('1')); if (strlen(r)) { do for [sign in '-1 1'] { R = sign * number(r); if (R >= x_low && R <= x_high) { set arrow from R, graph 0 to R, graph 1 nohead lc rgb '#888888' dt 3 lw 1.5 } } }"
    tone(h) = words(hues) <= 5 ? shade[h] : colour(h, words(hues))
    layers = once('solution', "is('order', word(hues, 1))", "lines lw 3 lc rgb '#000000'").', '.by_hue('value', '1', 'lines lw 1.8 lc rgb tone(h)')
    key = key_entry("lines lw 3 lc rgb '#000000'", "'solution'").', '.key_entry("lines dt 3 lw 1.5 lc rgb '#888888'", "'radius'") \
        .', '.key_of_hues('lines lw 1.8 lc rgb tone(h)')
    eval seen('hues', table, 'order', always)
    entries = shown_in_key(words(hues)) + 2; letters = 12
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
figure = 'divergence'
table = data.'/divergence.csv'
radii = data.'/divergence_radius.csv'
title_text = 'Taylor series about the bottom: it diverges at R'
below_text = 'R is the radius of convergence, T* the time from the bottom to the top'
eval energy_names(radii)
panel_by = 'energy'; most_panels = 3; rows_down = 2
hue_by = 'order'; hue_name(N) = 'N = '.N
eval seen('hues', table, 'order', '1')
n = words(hues)
tone(h) = n <= 6 ? shade[word('4 6 2 3 5 1', h) + 0] : colour(h, n)     # neighbours far apart
dash(h) = n <= 6 ? h + 1 : 1
x = 'time'; x_name = 'time t / (ℓ/g)^{1/2}, t = 0 at the bottom'
x_axis = "eval extent('x', table, 'time', of_panel('1')); set xrange [x_low:x_high]"
eval extent('errors', table, 'log10_error', '1')
mark_at(t, name, style) = sprintf("set arrow from %.9g, graph 0 to %.9g, graph 1 nohead lc rgb '#555555' lw 1.2 %s; set label '%s' at %.9g, graph 0.03 left offset 0.5, 0", t, t, style, name, t)
prepare = "eval first_cell('T', radii, 'tstar', \"is('energy', this)\"); eval first_cell('R', radii, 'radius', \"is('energy', this)\"); eval first_cell('gap', radii, 'gap', \"is('energy', this)\"); panel_title = 'E = '.energy_name(this, gap).(gap[1:1] eq '-' ? ' (rotation)' : ' (libration)'); if (row == 1) { set format x ''; unset xlabel; set bmargin 1; eval upper } else { set format x '%g'; panel_title = ''; eval lower }"
finish = 'unset label'
upper = "y_name = 'angle θ / rad'; eval extent('y', table, 'theta_exact', of_panel('1')); y_axis = sprintf('set yrange [%g:%g]', y_low - 0.35 * larger(y_high - y_low, 1), y_high + 0.35 * larger(y_high - y_low, 1)); eval mark_at(number(T), '', 'dt 2'); eval mark_at(number(R), '', ''); layers = above"
lower = "y_name = error_axis; y_axis = sprintf('set yrange [%g:%g]', larger(errors_low, -20), smaller(errors_high, 8)); eval mark_at(number(T), 'T*', 'dt 2'); eval mark_at(number(R), 'R', ''); layers = below"
# Angles beyond 100 are out of sight, also those beyond the range of double.
tame = "at('log10_abs_theta') > 2 ? (substr(strcol('theta'), 1, 1) eq '-' ? -100 : 100) : at('theta')"
above = by_hue(tame, '1', 'lines lw 2.2 dt dash(h) lc rgb tone(h)') \
    .', '.once('theta_exact', "is('order', word(hues, 1))", "lines lw 1.5 lc rgb '#888888'")
below = by_hue('log10_error', '1', 'lines lw 2.2 dt dash(h) lc rgb tone(h)')
key = key_of_hues('lines lw 2 dt dash(h) lc rgb tone(h)').', '.key_entry("lines lw 1.5 lc rgb '#888888'", "'exact'")
entries = shown_in_key(n) + 1; letters = 12
load scripts.'/shared/panels.gp'
