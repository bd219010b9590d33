# precision_floor: norm against the order for each arithmetic, one panel per energy.
#
# For any equation: the norms against the order in each arithmetic, one panel per unknown, for the first combination of
# the parameters; thin without rounding.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval first_case('order')
    title_text = 'Where rounding takes over in '.called
    below_text = 'the largest error at the times'.in_first
    kinds = 'series pade'
    prepare = "y_name = 'log_{10} (max |error| / unit of '.this.')'"
} else {
    load scripts.'/style.gp'
    figure = 'precision_floor'
    table = data.'/precision_floor.csv'
    title_text = 'How small the error gets before rounding dominates'
    below_text = 'error norm on [0, T*]'
    kinds = 'series resummed'
    eval energy_names(table)
    panel_by = 'energy'; y_name = norm_axis
    prepare = "panel_title = 'E = '.named_energy(this)"
    # Beyond the order from which every arithmetic is at its floor, the curves are level: that part is not drawn. The
    # title of a panel whose orders end before states it.
    reaches = "eval last_cell('last', table, 'floor', of_panel(\"is('method', 'series')\"))"
    x_axis = "eval extent('x', table, 'order', both(of_panel('1'), \"is('floor', 'no')\")); eval extent('all', table, 'order', of_panel('1')); eval extent('level', table, 'order', both(of_panel('1'), 'at(\"order\") > x_high')); end_ = smaller(all_high, larger(level_low > x_high ? 1.12 * level_low : x_high, 20.0)); set xrange [0:end_]; set xtics step_of(end_)"
    prepare = prepare."; ".reaches."; panel_title = panel_title.(last eq 'yes' ? '' : ': floor beyond N = '.last_order)"
    finish = 'set xtics autofreq'
    eval last_cell('last_order', table, 'order', '1')
    eval has_column('routes_known', table, 'recurrence')
    eval seen('scalars', table, 'scalar', '1')
    if (routes_known) { eval seen_together('ways', table, 'scalar recurrence', '1') } else { ways = scalars }
}
hue_by = 'scalar'; kind_by = 'method'
# Several recurrences in one arithmetic are separate curves.
several = equation eq '' && words(ways) > words(scalars)
if (several) { hue_by = 'scalar recurrence' }
scalar_of(w) = (at_ = strstrt(w, ','), at_ > 0 ? w[1:at_ - 1] : w)
hue_name(w) = arithmetic_name(scalar_of(w)).(strstrt(w, ',') ? ', '.w[strstrt(w, ',') + 1:*] : '')
kind_name(m) = approximation_name(m).(m eq 'pade' ? ' [N/2, N/2]' : '')
x = 'order'; x_name = 'order N'
if (several) { hues = ways } else { eval seen('hues', table, 'scalar', always) }
eval seen('orders', table, 'order', always)
tone(h) = colour(words(hues) <= 4 ? h + 2 : h, words(hues) <= 4 ? 6 : words(hues))
eval extent('e', table, 'log10_epsilon', always)
y_axis = "eval extent('y', table, 'log10_norm', of_panel('1')); eval rising('y', smaller(y_low, e_low), y_high)"
prepare = prepare."; do for [h=1:words(hues)] { eval first_cell('level', table, 'log10_epsilon', \"is('scalar', scalar_of(word(hues, h)))\"); set arrow from graph 0.95, first number(level) to graph 1, first number(level) nohead lw 4 lc rgb tone(h) }"
style = words(orders) == 1 ? 'points pt 7' : 'lines'
layers = 'for [k=1:2] '.rows(table, x, 'log10_exact_norm', of_panel("is('method', word(kinds, k)) && is('scalar', scalar_of(word(hues, 1))) && has('log10_exact_norm')")).' with '.style." lw 1.3 dt 3 lc rgb '#666666' notitle" \
    .', '.curves('log10_norm', '1', style.' lw 2 dt 3 - k lc rgb tone(h)')
key = key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.key_of_kinds('lines lw 2 dt 3 - k lc rgb soft') \
    .', '.key_entry("lines lw 1.3 dt 3 lc rgb '#666666'", "'without rounding'").', '.key_entry("lines lw 4 lc rgb '#666666'", "'ε, on the right'")
entries = shown_in_key(words(hues)) + 4; letters = several ? 24 : 18
load scripts.'/shared/panels.gp'
