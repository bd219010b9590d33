# published: the distance of printed values from the proved ones.
load scripts.'/style.gp'
figure = 'published'
table = data.'/published.csv'
title_text = 'Published reference values'
below_text = 'distance from the proved value in units of the last printed digit'
eval count_of('n', table, '1')
eval extent('units', table, 'units', '1')
width = 860; height = 90 + 22 * n
x = "log10(larger(at('units'), 1e-3))"; x_name = 'log_{10} of the distance in units'
x_axis = 'set xrange [-3:log10(larger(units_high, 10)) * 1.1 + 1]; set yrange [n - 0.5:-0.5]; set ytics scale 0 noenhanced'
prepare = 'set lmargin 42; set arrow from 0, graph 0 to 0, graph 1 nohead dt 3 lw 1.2 lc rgb soft'
layers = rows(table, x, 'column(0)', '1').":ytic(strcol('problem').': '.strcol('quantity')) with points pt 7 ps 0.8 lc rgb shade[5]"
key = key_entry('points pt 7 ps 0.8 lc rgb shade[5]', "'printed value'").', '.key_entry('lines dt 3 lw 1.2 lc rgb soft', "'one unit'")
entries = 2; letters = 30
load scripts.'/shared/panels.gp'
