# manifold_plot: solutions on the stable and unstable manifolds of an equilibrium in a plane of two unknowns.
# `problem`, `x_name`, `y_label`, `below` and `figure` are texts.
# Columns of curves: manifold,x,y, without y between two curves; of arrows, in the direction of time: manifold,x,y,dx,dy; of equilibrium: x,y.
x_text = x_name
load scripts.'/style.gp'
table = data.'/curves.csv'
arrows = data.'/arrows.csv'
point = data.'/equilibrium.csv'
title_text = problem eq 'typed' ? 'Manifolds of an equilibrium of the given equation' : heading_of(problem)
below_text = below
hue_by = 'manifold'; hue_name(word) = word.' manifold'
eval seen_together('hues', table, hue_by, '1')
n = words(hues)
# Where both manifolds are one curve, both colours are seen.
tone(h) = word(hues, h) eq 'stable' ? shade[2] : shade[4]
thick(h) = word(hues, h) eq 'stable' ? 4 : 1.6
width = 640; height = 520
x = 'x'; x_name = x_text; y_name = y_label
x_axis = 'set xrange [x_low - 0.03 * (x_high - x_low):x_high + 0.03 * (x_high - x_low)]'
y_axis = "eval extent('y', table, 'y', '1'); eval rising('y', y_low, y_high)"
line = 'lines lw thick(h) lc rgb tone(h)'
layers = 'for [h=1:n] '.broken_rows(table, x, 'y', of_hue("has('x')")).' with '.line.' notitle' \
    .", for [h=1:n] '".arrows."' using (is('manifold', word(hues, h)) ? at('x') : NaN):(at('y')):(at('dx')):(at('dy')) with vectors head filled size screen 0.018,22,90 fixed lw 1.6 lc rgb tone(h) notitle" \
    .", '".point."' using (at('x')):(at('y')) with points pt 7 ps 1.3 lc rgb '#000000' notitle"
key = key_of_hues(line).', '.key_entry("points pt 7 ps 1.3 lc rgb '#000000'", "'equilibrium'")
entries = n + 1; letters = 18
load scripts.'/shared/panels.gp'
