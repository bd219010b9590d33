# Panels about the verdict on a list, which shared/panels.gp draws after shared/coefficient_panel.gp was loaded for the
# list: eval history_panel, fits_panel or predictions_panel. Columns of `history`: order,radius,uncertainty; of `fits`:
# position,exponent; of `predictions`: order,log10_error.
eval test_cell('v_uncertainty', 'verdict', 'uncertainty')
eval test_cell('v_exponent', 'verdict', 'exponent')
eval test_cell('v_exponent_uncertainty', 'verdict', 'exponent_uncertainty')
wide_margin = "set lmargin 12; set tmargin 3.6; y_name_everywhere = 1; set key inside top right Left reverse samplen 1; "

# The range of a column, widened if all its values are equal.
own_range(which, low, high) = low < high ? sprintf('set %srange [*:*]', which) : sprintf('set %srange [%.15g:%.15g]', which, low - 0.1 * larger(abs(low), 1e-3), low + 0.1 * larger(abs(low), 1e-3))

# The stated uncertainty of each length, and how far its radius is from that of the whole list.
moved = "(v_ = abs(at('radius') / size_of_radius - 1), v_ > 1e-16 ? v_ : NaN)"
moved_drawn = 0
if (exists_file(history)) { eval count_of('moved_drawn', history, "abs(at('radius') / size_of_radius - 1) > 1e-16") }
stated_low = 0; stated_high = 1
if (exists_file(history)) { eval extent('stated', history, 'uncertainty', '1') }
history_range = stated_low < stated_high || moved_drawn ? '[*:*]' : sprintf('[%.15g:%.15g]', stated_low / size_of_radius / 10, stated_low / size_of_radius * 10)
history_layer = rows(history, 'order', "(at('uncertainty') / at('radius'))", '1')." with linespoints pt 7 ps 0.8 lw 1.5 lc rgb shade[4] title 'stated uncertainty / R'" \
    .(moved_drawn ? ', '.rows(history, 'order', moved, '1')." with points pt 6 ps 1 lw 1.4 lc rgb shade[5] title 'distance from the last radius / R'" : '')
history_panel = wide_margin."panel_title = in_front.'the verdict from the first coefficients'; set xlabel 'last power N'; y_name = 'relative to R'; x_axis = 'set xrange [*:*]'; y_axis = 'set logscale y; set yrange '.history_range; layers = history_layer"

# Positions in a power of ten that makes them about 1.
x_c = strlen(v_position_re) ? number(v_position_re) : 1
unit_of_fits = 0; fitted_low = 0; fitted_high = 1
if (exists_file(fits)) {
    eval extent('away', fits, 'position', '1')
    widest = larger(number('0'.v_uncertainty) / abs(x_c), larger(abs(away_high / x_c - 1), abs(away_low / x_c - 1)))
    unit_of_fits = widest > 0 ? floor(log10(widest)) : 0
    eval extent('fitted', fits, 'exponent', '1')
}
scaled = 10 ** -unit_of_fits
fits_layer = rows(fits, sprintf("((at('position') / %.17g - 1) * %g)", x_c, scaled), 'exponent', '1')." with points pt 6 ps 0.9 lc rgb shade[5] title 'differential approximants'" \
    .(strlen(v_exponent) ? ", '+' using (0):(number(v_exponent)):(number(v_uncertainty) / abs(x_c) * scaled):(number(v_exponent_uncertainty)) every ::0::0 with xyerrorbars pt 7 ps 0.9 lw 1.6 lc rgb shade[4] title 'verdict'" : '')
fits_panel = wide_margin."panel_title = in_front.'exponents and positions of the approximants that agree'; set xlabel sprintf('(position / x_c − 1) / 10^{%d}', unit_of_fits); y_name = 'exponent'; x_axis = own_range('x', (away_low / x_c - 1) * scaled, (away_high / x_c - 1) * scaled); y_axis = own_range('y', fitted_low, fitted_high); layers = fits_layer"

digits_low = 0; digits_high = 1
if (exists_file(predictions)) { eval extent('digits', predictions, 'log10_error', '1') }
predictions_layer = rows(predictions, 'order', "(-at('log10_error'))", '1')." with linespoints pt 7 ps 0.7 lw 1.2 lc rgb shade[4] notitle"
predictions_panel = wide_margin."panel_title = in_front.'digits to which a_n is predicted from the coefficients before it'; set xlabel 'n'; y_name = 'digits'; x_axis = 'set xrange [*:*]'; y_axis = own_range('y', -digits_high, -digits_low); layers = predictions_layer"
