# The part of error_norm.gp for many energies: the norms against the energy and towards E = 2 on either side, and the same
# in each arithmetic.
# The Runge-Kutta solution in double with the smallest step, if that table exists.
baseline = ''
march = "eval last_cell('baseline', in_scalar('baseline'), 'log10_norm', \"is('scalar', 'double')\"); eval last_cell('step', in_scalar('baseline'), 'step', \"is('scalar', 'double')\")"
if (exists_file(in_scalar('baseline'))) { eval march }
title_text = 'Error of the pendulum series and of its resummation on [0, T*]'
below_text = 'the largest error on the way from the top to the bottom, '.in_arithmetic(scalar).(strlen(baseline) ? '; RK4: Runge-Kutta method in double, Δt = '.number_name(tidy(step)) : '')
y_columns = 'log10_norm'; y_name = norm_axis
hue_by = 'order'; hues = orders; hue_name(N) = 'N = '.N
tone(h) = colour(h, words(orders))
load scripts.'/shared/energies.gp'
prepare = prepare."; if (strlen(baseline)) { eval level(number(baseline), \"lc rgb '#666666' lw 1.5 dt 4\") }"
layers = curves('log10_bound', '1', 'lines lw 1.1 dt 3 lc rgb tone(h)').', '.curves('log10_norm', '1', 'lines lw 2 dt 3 - k lc rgb tone(h)')
key = key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.key_of_kinds('lines lw 2 dt 3 - k lc rgb soft') \
    .', '.key_entry('lines lw 1.1 dt 3 lc rgb soft', "'proved bound'") \
    .', '.key_entry("lines lw 1.5 dt 4 lc rgb '#666666'", "strlen(baseline) ? 'RK4 at E = 2' : ''")
entries = shown_in_key(words(orders)) + 4; letters = 12
load scripts.'/shared/panels.gp'

# The floors of the other arithmetics.
if (words(arithmetics) > 0 && words(energies_between) > 1) {
    figure = 'error_norm_scalars'
    title_text = 'The same norms in each arithmetic'
    below_text = 'below the floor of the arithmetic no order helps'
    panel_by = 'scalar'; panels = arithmetics; y_name = norm_axis; y_together = 'log10_norm'; height = 440
    hue_by = 'order'; hues = orders; kind_by = 'method'; kinds = 'series resummed'
    prepare = "panel_title = arithmetic_name(this); eval level(unit_of(this), \"lc rgb '#666666' lw 1.2 dt 4\")"
    x = 'energy'; x_name = e_axis; x_axis = 'eval energies_on_x(x_low, x_high); eval separatrix_on_x(x_low, x_high)'
    eval extent('x', table, 'energy', '1')
    finish = 'eval energies_done'
    key = key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.key_of_kinds('lines lw 1.6 dt 3 - k lc rgb soft') \
        .', '.key_entry("lines lw 1.2 dt 4 lc rgb '#666666'", "'ε, the floor'")
    do for [s in arithmetics] {
        table = in_scalar(s)
        layers = layers.(layers eq '' ? '' : ', ').curves('log10_norm', '1', 'lines lw 1.6 dt 3 - k lc rgb tone(h)')
    }
    entries = shown_in_key(words(orders)) + 3; letters = 12
    load scripts.'/shared/panels.gp'
}
