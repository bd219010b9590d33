# error_norm: the norms against the order, with the rate, the bounds and the floors of the arithmetics, if there are few
# energies; otherwise against the energy and towards E = 2 on either side, and in a second figure in each arithmetic.
#
# For any equation: the norms against the order, one panel per unknown, one colour per combination of the parameters,
# marks for the methods; dotted the rate reach/R of the radius that the coefficients show.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('order')
    eval first_cell('scalar', main, 'scalar', '1')
    further = 0  # arithmetics besides that of the main table
    eval count_of('far', main, "is('method', 'asymptotic')")
    title_text = 'Error of the series of '.called.' and of its approximants'
    below_text = 'the largest error, '.in_arithmetic(scalar)
    if (far == 0) {
        radii = table_of('_radius')
        eval first_cell('reach', radii, 'reach', '1')
        below_text = 'the largest error at times up to '.tidy(reach).' from the start, '.in_arithmetic(scalar)
    }
    kind_by = 'method'; kinds = 'series pade endpoint'
    eval count_of('mapped', main, "is('method', 'euler') && has('log10_norm')")
    if (mapped > 0) { kinds = kinds.' euler gauge' }
    if (far > 0) { kinds = 'series pade asymptotic' }
    kind_name(m) = m eq 'pade' ? 'Padé [N/2, N/2]' : m eq 'euler' ? "Euler's variable" : m eq 'gauge' ? 'gauge function' : approximation_name(m)
    hue(h, k) = cases < 2 ? shade[word('4 5 3 2 6', k) + 0] : tone(h)
    prepare = "y_name = 'log_{10} (max |error| / unit of '.this.')'"
    x = 'order'; x_name = 'order N'; y_together = 'log10_norm'
    layers = (far > 0 ? '' : rate_lines(radii, 'lw 1 dt 3 lc rgb hue(h, 1)').', ') \
        .curves('log10_norm', '1', 'linespoints lw 1.8 dt k pt mark[k] ps 0.7 lc rgb hue(h, k)')
    key = key_of_kinds('linespoints lw 1.8 dt k pt mark[k] ps 0.7 lc rgb cases < 2 ? hue(1, k) : soft') \
        .(far > 0 ? '' : ', '.key_entry('lines lw 1 dt 3 lc rgb soft', "'rate (reach/R)^N'")).', '.key_of_cases('lines lw 2.4 lc rgb tone(h)')
    entries = shown_in_key(cases) + words(kinds) + 1; letters = cases < 2 ? 16 : 20
    do for [file in tables] {
        other = strstrt(file, stem.'_') == 1 && file ne stem.'_radius.csv' ? file[strlen(stem) + 2:strlen(file) - 4] : ''
        if (other ne '') {
            further = further + 1; table = table_of('_'.other)
            layers = layers.', '.curves('log10_norm', '1', sprintf('points pt %d ps 1.1 lw 1.2 lc rgb hue(h, k)', mark_of(further + 3)))
            key = key.', '.key_entry(sprintf('points pt %d ps 1.1 lw 1.2 lc rgb soft', mark_of(further + 3)), sprintf("'%s'", in_arithmetic(other)))
        }
    }
    table = main
    entries = entries + further
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'

in_scalar(s) = data.'/error_norm_'.s.'.csv'
table = data.'/error_norm.csv'
eval seen('energies', table, 'energy', '1')
eval seen('orders', table, 'order', '1')
eval first_cell('scalar', table, 'scalar', '1')
arithmetics = ''
do for [s in 'double long-double quad'] { if (exists_file(in_scalar(s))) { arithmetics = arithmetics.' '.s } }
# log10 of the unit of an arithmetic, mpfr:D and ball:D by their digits.
unit_of(s) = s eq 'double' ? -15.65 : s eq 'long-double' ? -18.96 : s eq 'quad' ? -33.72 : -real(s[strstrt(s, ':') + 1:*])
# T*/R from the complete integrals, K/sqrt(K^2 + K'^2) on either side of E = 2.
agm(a, b) = abs(a - b) < 1e-14 * a ? a : agm((a + b) / 2, sqrt(a * b))
squares(K, L) = K / sqrt(K**2 + L**2)
rate_of(e, g) = g > 0 ? squares(1 / agm(1.0, sqrt(g / 2)), 1 / agm(1.0, sqrt(e / 2))) : squares(1 / agm(1.0, sqrt(-g / e)), 1 / agm(1.0, sqrt(2 / e)))
level(y, style) = sprintf('set arrow from graph 0, first %g to graph 1, first %g nohead %s', y, y, style)
kind_by = 'method'; kinds = 'series resummed'
kind_name(m) = approximation_name(m)
figure = 'error_norm'

if (words(energies) <= 2 || (words(orders) >= 3 && words(energies) <= 4)) {
    title_text = 'Convergence of the series and of its resummation on [0, T*]'
    below_text = 'the largest error on the way from the top to the bottom, '.in_arithmetic(scalar)
    eval energy_names(table)
    panel_by = 'energy'; most_across = 2
    prepare = "rate = rate_of(number(tidy(this)), number(gap_of(this))); panel_title = 'E = '.named_energy(this).sprintf(', rate T*/R = %.4g', rate); do for [s in arithmetics.' '.scalar] { if (unit_of(s) > y_low - 2) { eval level(unit_of(s), \"lc rgb '#888888' lw 1.2 dt 4\"); set label 'ε of '.arithmetic_name(s) at graph 0.01, first unit_of(s) left offset 0, 0.5 textcolor rgb soft } }"
    finish = 'unset label'
    x = 'order'; x_name = 'order N'; y_name = norm_axis; y_together = 'log10_norm'
    hue(k) = shade[k == 1 ? 5 : 4]
    layers = "x * log10(rate) with lines lw 1.2 dt 5 lc rgb '#444444', ".curves('log10_bound', '1', 'lines lw 1.5 dt 3 lc rgb hue(k)') \
        .', '.curves('log10_norm', '1', 'linespoints lw 2.2 dt 3 - k pt 7 ps 0.6 lc rgb hue(k)')
    key = key_of_kinds('linespoints lw 2.2 dt 3 - k pt 7 ps 0.6 lc rgb hue(k)') \
        .', '.key_entry('lines lw 1.5 dt 3 lc rgb soft', "'proved bound'").', '.key_entry("lines lw 1.2 dt 5 lc rgb '#444444'", "'rate (T*/R)^N'")
    main = table
    do for [i=1:words(arithmetics)] {
        s = word(arithmetics, i)
        table = in_scalar(s)
        layers = layers.', '.curves('log10_norm', '1', sprintf('points pt mark[%d] ps 0.9 lw 1.2 lc rgb hue(k)', i))
        key = key.', '.key_entry(sprintf('points pt mark[%d] ps 0.9 lw 1.2 lc rgb soft', i), sprintf("'in %s'", arithmetic_name(s)))
    }
    table = main
    entries = 4 + words(arithmetics)
    load scripts.'/shared/panels.gp'
} else {
    load scripts.'/pendulum/norms_over_energies.gp'
}
