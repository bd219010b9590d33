# The part of error_norm.gp for many energies: the norms against the energy in the axes and the range of the paper's
# figure, with a mark at each computed energy; the bounds with the norms; both towards E = 2 on either side; and the same
# norms in each arithmetic.
# The Runge-Kutta solution in double with the smallest step, if that table exists.
baseline = ''
march = "eval last_cell('baseline', in_scalar('baseline'), 'log10_norm', \"is('scalar', 'double')\"); eval last_cell('step', in_scalar('baseline'), 'step', \"is('scalar', 'double')\")"
if (exists_file(in_scalar('baseline'))) { eval march }
tone(h) = colour(h, words(orders))
hue_name(N) = 'N = '.N
by_order = "hue_by = 'order'; hues = orders; kind_by = 'method'; kinds = 'series resummed'; y_name = norm_axis"
below_norms = 'the largest error on the way from the top to the bottom, '.in_arithmetic(scalar).'; marks on solid curves: computed energies'
baseline_level = "if (strlen(baseline)) { eval level(number(baseline), \"lc rgb '#666666' lw 1.5 dt 4\") }; "
baseline_entry = key_entry("lines lw 1.5 dt 4 lc rgb '#666666'", "strlen(baseline) ? 'RK4 at E = 2, Δt = '.number_name(tidy(step)) : ''")
norms = "curves('log10_norm', '1', 'lines lw 2 dt 3 - k lc rgb tone(h)').', '.by_hue('log10_norm', \"is('method', 'resummed')\", 'points pt 7 ps 0.3 lc rgb tone(h)')"
key_of_norms = "key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.key_of_kinds('lines lw 2 dt 3 - k lc rgb soft')"
bounds_entry = key_entry('lines lw 1.3 dt 3 lc rgb soft', "'proved bound'")
eval seen('energies_between', table, 'energy', "at('log10_gap') > -2.1")

# The paper's axes: the energy from 0 to 4 and errors down to the precision of double.
if (words(energies_between) > 1) {
    least_drawn = -17.0
    eval extent('energy', table, 'energy', '1')
    eval extent('norm', table, 'log10_norm', '1')
    of_paper = energy_low < 1 && energy_high > 3
    x_axis_of_paper = "if (of_paper) { set xrange [0:4] } else { eval energies_on_x(energy_low, energy_high) }; eval separatrix_on_x(energy_low, energy_high)"
    y_axis_of_paper = "eval rising('y', larger(norm_low, least_drawn), norm_high)"
    eval by_order
    title_text = 'Error of the pendulum series and of its resummation on [0, T*]'
    below_text = below_norms
    x = 'energy'; x_name = e_axis; x_axis = x_axis_of_paper; y_axis = y_axis_of_paper
    prepare = baseline_level; finish = 'eval energies_done'
    eval 'layers = '.norms
    eval 'key = '.key_of_norms.".', '.baseline_entry"
    entries = shown_in_key(words(orders)) + 3; letters = 24
    load scripts.'/shared/panels.gp'

    figure = 'error_norm_bounds'
    eval by_order
    title_text = 'The same errors and their proved bounds A and A2'
    below_text = 'the bounds hold for all times up to T* and every energy but 0 and 2'
    panel_by = 'method'; panels = kinds; most_across = 2; height = 500
    x = 'energy'; x_name = e_axis; x_axis = x_axis_of_paper; y_axis = y_axis_of_paper
    prepare = "panel_title = kind_name(this)"; finish = 'eval energies_done'
    layers = by_hue('log10_bound', '1', 'lines lw 1.6 dt 3 lc rgb tone(h)').', '.by_hue('log10_norm', '1', 'lines lw 2 lc rgb tone(h)')
    key = key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.bounds_entry
    entries = shown_in_key(words(orders)) + 1; letters = 12
    load scripts.'/shared/panels.gp'
    figure = 'error_norm_separatrix'
}

# Towards the separatrix.
near = "at('log10_gap') < -0.9"
eval seen('energies_below', table, 'log10_gap', near.' && !('.rotates.')')
eval seen('energies_above', table, 'log10_gap', near.' && '.rotates)
sides = (words(energies_below) > 1 ? ' libration' : '').(words(energies_above) > 1 ? ' rotation' : '')
if (sides ne '' || words(energies_between) < 2) {
    eval by_order
    title_text = 'The same errors towards the separatrix'
    below_text = below_norms
    panels = sides eq '' ? 'libration rotation' : sides; most_across = 2; height = 500
    # Where there are few energies, all of them.
    side = (sides eq '' ? '1' : near).' && ('.rotates.") == (this eq 'rotation')"
    always = side
    x = 'log10_gap'; x_name = gap_axis; x_axis = "eval extent('x', table, 'log10_gap', always); eval falling('x', x_low, x_high)"
    y_axis = "eval extent('y', table, 'log10_norm', sides eq '' ? '1' : near); eval rising('y', y_low, y_high)"
    prepare = baseline_level."panel_title = this eq 'libration' ? 'libration, E < 2' : 'rotation, E > 2'"
    eval 'layers = '.norms
    eval 'key = '.key_of_norms.".', '.baseline_entry"
    entries = shown_in_key(words(orders)) + 3; letters = 24
    load scripts.'/shared/panels.gp'
}

# The floors of the other arithmetics.
if (words(arithmetics) > 0 && words(energies_between) > 1) {
    figure = 'error_norm_scalars'
    title_text = 'The same norms in each arithmetic'
    below_text = 'below the floor of the arithmetic no order helps'
    eval by_order
    panel_by = 'scalar'; panels = arithmetics; y_together = 'log10_norm'; height = 440
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
