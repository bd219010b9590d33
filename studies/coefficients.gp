# coefficients of any equation: their size against n, one panel per unknown, one colour per combination of the
# parameters; the lines follow from the radius and exponent of the radius tests.
load scripts.'/shared/equation.gp'

eval equation_panels('n')
title_text = 'Coefficients of '.called
below_text = 'of the series about the start'
x = 'n'; x_name = 'power n'; y_name = 'log_{10} |a_n|'
layers = by_hue('log10_fitted', '1', "lines lw 1.2 lc rgb cases < 2 ? '#888888' : tone(h)") \
    .', '.by_hue('log10_abs', '1', 'points pt mark_of(h) ps 0.6 lc rgb tone(h)')
key = key_entry('points pt mark_of(1) ps 0.8 lc rgb soft', "'coefficient'") \
    .', '.key_entry("lines lw 1.2 lc rgb '#888888'", "'radius and exponent of the tests'") \
    .', '.key_of_cases('points pt mark_of(h) ps 0.8 lc rgb tone(h)')
entries = shown_in_key(cases) + 2; letters = 20
load scripts.'/shared/panels.gp'
