# singularity_plot: the singularities of a solution in the complex plane, a mark for each kind, and the circle
# through the nearest about the initial point. `problem`, `initial_point` and `figure` are texts.
# Columns of positions: position_re,position_im,modulus,kind,rigour,unknown.
load scripts.'/style.gp'

file = data.'/positions.csv'
# The kinds as quoted words.
kinds = ask(sprintf("awk -F, 'NR > 1 && !n[$4]++ { printf \"\\\"%%s\\\" \", $4 }' '%s'", file))
n = words(kinds)
of_kind(k, proved) = sprintf('$4 == "%s" && $5 %s "proved"', word(kinds, k), proved ? '==' : '!=')
center = number(initial_point)
radius = least(file, '3', 'v($3) > 0', 0)
far = greatest(file, '3', '1', 1)
edge = 1.15 * larger(far, 1e-300)
any_proved = count_of(file, '$5 == "proved"')
any_open = count_of(file, '$5 != "proved"')
hollow = '4 6 8 12 10 14'
solid = '5 7 9 13 11 15'
form(k, proved) = word(proved ? solid : hollow, (k - 1) % 6 + 1) + 0
title_of = problem eq 'typed' ? 'Singularities of the given equation' : 'Singularities of '.problem_name(problem)

across = 1; down = 1
panel_w = 640; panel_h = 560
foot = foot_for(n + 2, 22)
do for [kind in terminals] {
    eval figure_of(kind, figure)
    eval heading(title_of, any_proved ? (any_open ? 'solid: position proved; hollow: heuristic' : 'positions proved') : 'heuristic')
    eval panel(1)
    set lmargin 9; set rmargin 3; set tmargin 1; set bmargin 3.6
    set size ratio -1
    set xrange [center - edge:center + edge]
    set yrange [-edge:edge]
    set xlabel 'Re t'
    set ylabel 'Im t'
    set samples 362
    set xtics step_of(edge); set ytics step_of(edge)
    set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead lc rgb '#bbbbbb' lw 0.8 back
    unset key
    plot '+' using (center + radius * cos(2 * pi * $0 / 360)):(radius * sin(2 * pi * $0 / 360)) with lines lw 1.8 lc rgb '#888888', \
         '+' using (center):(0) every ::0::0 with points pt 1 ps 1.4 lw 1.6 lc rgb '#000000', \
         for [k=1:n] for [proved=0:1] rows(file, 1, 2, of_kind(k, proved)) using 1:2 with points pt form(k, proved) ps 1.3 lw 1.6 lc rgb colour(k <= 6 && n <= 6 ? word('5 4 3 1 2 6', k) + 0 : k, n)
    set size noratio
    unset arrow
    eval no_heading
    eval key_strip
    plot for [k=1:n] NaN with points pt form(k, any_proved > 0) ps 1.3 lw 1.6 lc rgb colour(k <= 6 && n <= 6 ? word('5 4 3 1 2 6', k) + 0 : k, n) title word(kinds, k), \
         NaN with lines lw 1.8 lc rgb '#888888' title sprintf('circle through the nearest, radius %.6g', radius), \
         NaN with points pt 1 ps 1.4 lw 1.6 lc rgb '#000000' title 'initial point'
    eval figure_done
}
