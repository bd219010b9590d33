# singularity_plot: the singularities of a solution in the complex plane, a mark for each kind, and the circle
# through the nearest about the initial point. `problem`, `initial_point` and `figure` are texts.
# Columns of positions: position_re,position_im,modulus,kind,rigour,unknown.
load scripts.'/style.gp'
table = data.'/positions.csv'
kind_by = 'kind'; kind_name(k) = k
eval seen('kinds', table, 'kind', '1')
n = words(kinds)
center = number(initial_point)
eval extent('radius', table, 'modulus', "at('modulus') > 0")
eval extent('far', table, 'modulus', '1')
edge = 1.15 * larger(far_high, 1e-300)
eval count_of('proved', table, "is('rigour', 'proved')")
eval count_of('open', table, "!is('rigour', 'proved')")
title_text = problem eq 'typed' ? 'Singularities of the given equation' : 'Singularities of '.heading_of(problem)
below_text = proved ? (open ? 'solid: position proved; hollow: heuristic' : 'positions proved') : 'heuristic'
width = 640; height = 560
x = 'position_re'; x_name = 'Re t'; y_name = 'Im t'
x_axis = 'set xrange [center - edge:center + edge]; set yrange [-edge:edge]; set xtics step_of(edge); set ytics step_of(edge)'
prepare = "set size ratio -1; set samples 362; set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead lc rgb '#bbbbbb' lw 0.8 back"
finish = 'set size noratio'
hue(k) = colour(k <= 6 && n <= 6 ? word('5 4 3 1 2 6', k) + 0 : k, n)
hollow_form(k) = word('4 6 8 12 10 14', (k - 1) % 6 + 1) + 0
solid_form(k) = hollow_form(k) + 1
hollow = 'points pt hollow_form(k) ps 1.3 lw 1.6 lc rgb hue(k)'
solid = 'points pt solid_form(k) ps 1.3 lw 1.6 lc rgb hue(k)'
of_rigour(condition, style) = 'for [k=1:n] '.rows(table, x, 'position_im', of_kind(condition)).' with '.style
layers = "'+' using (center + radius_low * cos(2 * pi * $0 / 360)):(radius_low * sin(2 * pi * $0 / 360)) with lines lw 1.8 lc rgb '#888888'" \
    .", '+' using (center):(0) every ::0::0 with points pt 1 ps 1.4 lw 1.6 lc rgb '#000000'" \
    .', '.of_rigour("!is('rigour', 'proved')", hollow).', '.of_rigour("is('rigour', 'proved')", solid)
key = key_of_kinds(proved ? solid : hollow).', '.key_entry("lines lw 1.8 lc rgb '#888888'", "sprintf('circle through the nearest, radius %.6g', radius_low)") \
    .', '.key_entry("points pt 1 ps 1.4 lw 1.6 lc rgb '#000000'", "'initial point'")
entries = n + 2; letters = 22
load scripts.'/shared/panels.gp'
