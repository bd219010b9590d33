# The studies audit_NAME: correct digits against the gap, one panel per time.
load scripts.'/style.gp'
figure = stem
table = data.'/'.stem.'.csv'
library = stem eq 'audit_gsl' ? 'gsl' : 'boost'
called = stem eq 'audit_gsl' ? 'GSL' : 'Boost.Math'
title_text = 'Correct digits of θ in double, from the rounded modulus k and from the exact gap'
below_text = 't = 0 at the top'
eval has_column('typed', table, 'time_typed')
panel_by = typed ? 'time_typed' : 'time'; height = 350
prepare = "panel_title = 't = '.this.(strstrt(this, 'T') ? '' : ' (ℓ/g)^{1/2}')"
x = "log10(at('gap'))"; x_name = gap_axis
eval extent('gap', table, 'gap', '1')
x_axis = "eval falling('x', log10(gap_low), log10(gap_high)); if (across == 3 && gap_high > 1e10 * gap_low) { set xtics 5 }"
y_name = 'correct digits'; y_axis = 'set yrange [0:19]; set ytics 0, 5'
digits = "smaller(20, at('correct_digits'))"
# The digits lost by rounding k, before the library is called.
told = "at('input_ulp') > 0 ? smaller(20, -log10(at('input_ulp') * 2.0**-52)) : 20"
layers = "15.653559774527 with lines lw 1.3 dt 3 lc rgb '#666666'" \
    .', '.once(told, "is('library', library)", 'linespoints lw 2 dt 2 pt 0 lc rgb shade[6]') \
    .', '.once(digits, "is('library', library)", 'points pt 7 ps 0.5 lc rgb shade[4]') \
    .', '.once(digits, "is('library', 'libration')", 'points pt 6 ps 0.6 lc rgb shade[5]')
key = key_entry('points pt 6 lc rgb shade[5]', "'Libration, from the exact gap'") \
    .', '.key_entry('points pt 7 lc rgb shade[4]', "called.', from k rounded to double'") \
    .', '.key_entry('lines lw 2 dt 2 lc rgb shade[6]', "'limit due to the rounding of k'") \
    .', '.key_entry("lines lw 1.3 dt 3 lc rgb '#666666'", "'ε of double'")
entries = 4; letters = 28
load scripts.'/shared/panels.gp'
