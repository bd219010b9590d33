# One panel about a list of coefficients, in the place that the caller has set: `part` is 'ratios' (the Domb-Sykes plot,
# for a pair of singularities in the form of Mercer and Roberts), 'roots' or 'poles'; `ratios` and `poles` are the
# tables of the list; test_cell(m, c) is the cell of the test m of the radius, such as 'verdict', in column c; `named` is
# the name of the list or '', `pade_order` a remark about the approximant. The line through the ratios is that of the
# plot's own test, else that of the verdict.
#
# With n to the right the plots would crowd the end of interest: they are drawn against 1/n, from n = 4 on.
p_left = int(larger(1, number('0'.first_of(ratios, 6, '1'))))
verdict_radius = test_cell('verdict', 'radius')
known_radius = strlen(verdict_radius) > 0
size_of_radius = known_radius ? number(verdict_radius) : 0
level = fit_of(p_left, verdict_radius, test_cell('verdict', 'position_re'), test_cell('verdict', 'position_im'), test_cell('verdict', 'count'))
of_pair = known_radius && level != level
own_test = of_pair ? 'mercer-roberts' : 'domb-sykes'
fitted_by = strlen(test_cell(own_test, 'radius')) ? own_test : 'verdict'
fit_radius = test_cell(fitted_by, 'radius')
fit_error = test_cell(fitted_by, 'uncertainty')
fit_exponent = test_cell(fitted_by, 'exponent')
in_front = named eq '' ? '' : named.': '
late = '$1 >= 4'
set xrange [0:0.26]
set xlabel '1/n'
unset key
set tmargin part eq 'ratios' ? 4.8 : 3.6
if (part eq 'ratios') {
    column_drawn = of_pair ? 8 : 7
    limit = known_radius ? (of_pair || level > 0 ? 1 : -1) * number(fit_radius) ** -p_left : 0
    slope = fit_slope(p_left, limit, fit_exponent)
    half_width = known_radius ? fit_uncertainty(p_left, limit, fit_radius, fit_error) : 0
    limit_in_words = !known_radius ? '' : (of_pair ? p_left == 1 ? 'intercept 1/R = ' : sprintf('intercept R^{−%d} = ', p_left) : 'intercept ').in_powers(printed(sprintf('%%.%dg', smaller(10, digits_beside(fit_radius, fit_error))), sprintf('%.15g', limit)))
    set title in_front.(of_pair ? 'generalised ratios of a pair (Mercer-Roberts)' : 'ratios of coefficients (Domb-Sykes)')."\n{/*0.85 ".(known_radius ? (fitted_by eq 'verdict' ? 'verdict: ' : '').fit_in_words(fit_radius, fit_error, fit_exponent).'}'."\n{/*0.85 ".limit_in_words : 'no radius is found').'}' offset 0, -0.4
    set ylabel of_pair ? 'B_n' : sprintf('a_n/a_{n−%d}', p_left)
    near_limit = known_radius ? sprintf('%s && $%d * %g > 0 && $%d / %.15g < 3', '$1 >= 6', column_drawn, limit, column_drawn, limit) : late
    low = least(ratios, sprintf('%d', column_drawn), near_limit, -1); high = greatest(ratios, sprintf('%d', column_drawn), near_limit, 1)
    if (known_radius) { low = smaller(low, limit - half_width); high = larger(high, limit + half_width) }
    eval rising('y', low, high)
    points_drawn = sprintf("rows(ratios, 2, %d, late) using 1:2 with points pt 6 ps 0.8 lc rgb shade[5]", column_drawn)
    line_drawn = "limit * (1 + slope * x) with lines lw 1.5 lc rgb '#888888', "
    intercept_drawn = ", '+' using (0):(limit):(half_width) every ::0::0 with yerrorbars pt 7 ps 1 lw 2 lc rgb shade[4]"
    eval 'plot '.(known_radius && strlen(fit_exponent) ? line_drawn : '').points_drawn.(known_radius ? intercept_drawn : '')
} else { if (part eq 'roots') {
    set title in_front.'roots of coefficients: they tend to 1/R' offset 0, -0.4
    set ylabel 'n-th root'
    low = least(ratios, '4 5', late.' && $4 > 0', 0); high = greatest(ratios, '4 5', late.' && $4 > 0', 1)
    if (known_radius) { low = smaller(low, 1 / size_of_radius); high = larger(high, 1 / size_of_radius) }
    eval rising('y', low, high)
    set key inside top left reverse Left samplen 1
    level_drawn = known_radius ? "1 / size_of_radius with lines lw 1.5 lc rgb '#888888' title '1/R', " : ''
    eval 'plot '.level_drawn."rows(ratios, 2, 4, late) using 1:2 with points pt 6 ps 0.7 lc rgb shade[5] title '|a_n|^{1/n}', rows(ratios, 2, 5, late) using 1:2 with points pt 4 ps 0.7 lc rgb shade[4] title '|n a_n|^{1/n}'"
    unset key
} else {
    # Around the circle, or up to four times the nearest nonzero pole or zero: distant ones are meaningless.
    edge = known_radius ? 2.4 * size_of_radius : 4 * least(poles, '4', 'v($4) > 0', 1)
    set title in_front.'poles and zeros of the Padé approximant'.pade_order offset 0, -0.4
    set xlabel 'Re t'
    set ylabel 'Im t'
    set xrange [-edge:edge]
    set yrange [-edge:edge]
    set size ratio -1
    set samples 362
    set xtics step_of(edge); set ytics step_of(edge)
    set key outside right top reverse Left samplen 1
    circle = "'+' using (size_of_radius * cos(2 * pi * $0 / 360)):(size_of_radius * sin(2 * pi * $0 / 360)) with lines lw 1.8 lc rgb '#888888' title '|t| = R', "
    eval 'plot '.(known_radius ? circle : '')."for [side in '1 -1'] rows(poles, 2, 3, '$1 == \"pole\"') using 1:($2 * (side + 0)) with points pt 2 ps 1.1 lw 1.6 lc rgb shade[4] title side + 0 > 0 ? 'poles' : '', for [side in '1 -1'] rows(poles, 2, 3, '$1 == \"zero\"') using 1:($2 * (side + 0)) with points pt 6 ps 1 lw 1.4 lc rgb shade[5] title side + 0 > 0 ? 'zeros' : ''"
    set size noratio
    set xtics autofreq; set ytics autofreq
    unset key
} }
