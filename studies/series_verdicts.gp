# series_verdicts: the verdict's stated uncertainty and its difference from the published radius, for each list.
load scripts.'/style.gp'
figure = 'series_verdicts'
table = data.'/series_verdicts.csv'
title_text = 'The verdict on published lists'
below_text = 'relative to the published radius; at the left edge: 10^{-13} or less'
eval count_of('n', table, '1')
width = 900; height = 120 + 20 * n
x = "log10(larger(at('relative_uncertainty'), 1e-13))"; x_name = 'log_{10}'
x_axis = "set xrange [-13:0.5]; set yrange [n - 0.5:-0.5]; set ytics scale 0 noenhanced"
prepare = 'set lmargin 34'
layers = rows(table, '(1e99)', 'column(0)', '1').":ytic(strcol('list').' ('.strcol('order').')') with points pt 0" \
    .', '.rows(table, x, 'column(0)', "has('relative_uncertainty')").' with points pt 6 ps 1 lw 1.6 lc rgb shade[5]' \
    .', '.rows(table, "log10(larger(at('relative_error'), 1e-13))", 'column(0)', "has('relative_uncertainty')").' with points pt 7 ps 0.8 lc rgb shade[2]'
key = key_entry('points pt 6 ps 1 lw 1.6 lc rgb shade[5]', "'stated uncertainty'").', '.key_entry('points pt 7 ps 0.8 lc rgb shade[2]', "'difference from the published radius'")
entries = 2; letters = 36
load scripts.'/shared/panels.gp'
