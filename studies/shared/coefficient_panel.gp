# Panels about lists of coefficients, which shared/panels.gp draws. Before this is loaded: `ratios`, `poles` and `tests`
# are the tables of a list; `of_list` is the condition of the list's rows in `tests`; `named` is its name or '',
# `pade_order` a remark about the approximant. After it: the settings of a panel by eval ratios_panel (the Domb-Sykes
# plot, for a pair of singularities in the form of Mercer and Roberts), roots_panel or poles_panel. The line through the
# ratios is that of the verdict, or of the plot's own test if the verdict has no exponent.
#
# With n to the right the plots would crowd the end of interest: they are drawn against 1/n, from n = 4 on.
load scripts.'/shared/ratio_fit.gp'
late = "at('n') >= 4"
in_front = named eq '' ? '' : named.': '
test_cell(name, method, c) = first_cell(name, tests, c, sprintf("is('method', '%s') && (%s)", method, of_list))
do for [c in 'radius position_re position_im count'] { eval test_cell('v_'.c, 'verdict', c) }
eval first_cell('p_left', ratios, 'power', '1')
p_left = int(larger(1, number('0'.p_left)))
known_radius = strlen(v_radius) > 0
size_of_radius = known_radius ? number(v_radius) : 0
level = fit_of(p_left, v_radius, v_position_re, v_position_im, v_count)
of_pair = known_radius && level != level
eval test_cell('fit_exponent', 'verdict', 'exponent')
fitted_by = strlen(fit_exponent) ? 'verdict' : of_pair ? 'mercer-roberts' : 'domb-sykes'
eval test_cell('fit_radius', fitted_by, 'radius')
if (fit_radius eq '') { fitted_by = 'verdict'; fit_radius = v_radius }
eval test_cell('fit_error', fitted_by, 'uncertainty')
eval test_cell('fit_exponent', fitted_by, 'exponent')
limit = known_radius ? (of_pair || level > 0 ? 1 : -1) * number(fit_radius) ** -p_left : NaN
slope = fit_slope(p_left, limit, fit_exponent)
half_width = known_radius ? fit_uncertainty(p_left, limit, fit_radius, fit_error) : 0
limit_in_words = !known_radius ? '' : (of_pair ? p_left == 1 ? 'intercept 1/R = ' : sprintf('intercept R^{−%d} = ', p_left) : 'intercept ').in_powers(printed(sprintf('%%.%dg', smaller(10, digits_beside(fit_radius, fit_error))), sprintf('%.15g', limit)))
column_drawn = of_pair ? 'pair_ratio' : 'ratio_in_power'
eval extent('r', ratios, column_drawn, known_radius ? sprintf("at('n') >= 6 && at('%s') * %g > 0 && at('%s') / %.15g < 3", column_drawn, limit, column_drawn, limit) : late)
eval extent('roots', ratios, 'root corrected_root', late." && at('root') > 0")
eval extent('pole', poles, 'modulus', "at('modulus') > 0")
eval count_of('ratios_drawn', ratios, "has('ratio_in_power') && at('ratio_in_power') != 0")
eval count_of('poles_drawn', poles, '1')
# Around the circle, or up to four times the nearest nonzero pole or zero: distant ones are meaningless.
edge = known_radius ? 2.4 * size_of_radius : 4 * pole_low

over_n = "set lmargin 12; set tmargin 3.6; x_name = '1/n'; set xlabel x_name; x_axis = 'set xrange [0:0.26]'; y_name_everywhere = 1; "
x = 'inverse_n'
ratios_layer = rows(ratios, 'inverse_n', column_drawn, late).' with points pt 6 ps 0.8 lc rgb shade[5] notitle' \
    .(slope == slope ? ", limit * (1 + slope * x) with lines lw 1.5 lc rgb '#888888' notitle" : '') \
    .(known_radius ? ", '+' using (0):(limit):(half_width) every ::0::0 with yerrorbars pt 7 ps 1 lw 2 lc rgb shade[4] notitle" : '')
ratios_panel = over_n."set tmargin 4.8; panel_title = in_front.(of_pair ? 'generalised ratios of a pair (Mercer-Roberts)' : 'ratios of coefficients (Domb-Sykes)').\"\\n{/*0.85 \".(known_radius ? (fitted_by eq 'verdict' ? 'verdict: ' : '').fit_in_words(fit_radius, fit_error, fit_exponent).\"}\\n{/*0.85 \".limit_in_words : 'no radius is found').'}'; y_name = of_pair ? 'B_n' : sprintf('a_n/a_{n−%d}', p_left); y_axis = known_radius ? rising('y', smaller(r_low, limit - half_width), larger(r_high, limit + half_width)) : rising('y', r_low, r_high); layers = ratios_layer"
roots_layer = rows(ratios, 'inverse_n', 'root', late)." with points pt 6 ps 0.7 lc rgb shade[5] title '|a_n|^{1/n}'" \
    .', '.rows(ratios, 'inverse_n', 'corrected_root', late)." with points pt 4 ps 0.7 lc rgb shade[4] title '|n a_n|^{1/n}'" \
    .(known_radius ? ", 1 / size_of_radius with lines lw 1.5 lc rgb '#888888' title '1/R'" : '')
roots_panel = over_n."panel_title = in_front.'roots of coefficients: they tend to 1/R'; y_name = 'n-th root'; y_axis = known_radius ? rising('y', smaller(roots_low, 1 / size_of_radius), larger(roots_high, 1 / size_of_radius)) : rising('y', roots_low, roots_high); set key inside top left reverse Left samplen 1; layers = roots_layer"
half_of(kind, sign, style, title) = rows(poles, 'position_re', sign." * at('position_im')", sprintf("is('kind', '%s')", kind))." with points ".style." title '".title."'"
poles_layer = half_of('pole', '1', 'pt 2 ps 1.1 lw 1.6 lc rgb shade[4]', 'poles').', '.half_of('pole', '-1', 'pt 2 ps 1.1 lw 1.6 lc rgb shade[4]', '') \
    .', '.half_of('zero', '1', 'pt 6 ps 1 lw 1.4 lc rgb shade[5]', 'zeros').', '.half_of('zero', '-1', 'pt 6 ps 1 lw 1.4 lc rgb shade[5]', '') \
    .(known_radius ? ", '+' using (size_of_radius * cos(2 * pi * $0 / 360)):(size_of_radius * sin(2 * pi * $0 / 360)) with lines lw 1.8 lc rgb '#888888' title '|t| = R'" : '')
poles_panel = "set lmargin 12; set tmargin 3.6; panel_title = in_front.'poles and zeros of the Padé approximant'.pade_order; set xlabel 'Re t'; y_name = 'Im t'; x_axis = 'set xrange [-edge:edge]; set xtics step_of(edge)'; y_axis = 'set yrange [-edge:edge]; set ytics step_of(edge)'; set size ratio -1; set samples 362; set key outside right top reverse Left samplen 1; layers = poles_layer"
