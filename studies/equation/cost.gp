# cost of any equation: multiplications and seconds over the order, of the first combination of the parameters.
# Columns: <axes>,order,route,multiplications,nonzero_multiplications,...; in _time order,route,scalar,seconds,...
load scripts.'/equation/panels.gp'

times = table_of('_time')
k = place(main, 'order') - 1
all = cases(main, k)
routes = seen(main, k + 2, '1')
scalars = seen(times, k + 3, '1')
curve(f, r) = both(in_case(word(all, 1)), with_word(f, 'route', r))
across = 2; down = 1
panel_w = 520
foot = foot_for(1 + words(scalars) * words(routes), 18)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Cost of the coefficients of '.called, 'all unknowns up to the order'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))))
    eval single_panel
    set xlabel 'order N'
    set logscale x
    set xtics ()
    do for [N in sorted(main, k + 1, '1')] { set xtics add (N N + 0) }
    set xrange [span(main, 'order', '1', 1, -1) / 1.2:span(main, 'order', '1', 1, 1) * 1.2]
    eval panel(1)
    set title 'multiplications' offset 0, -0.5
    set ylabel 'multiplications / N^2'
    set yrange [0:1.2 * number(ask(sprintf("awk -F, 'NR > 1 { q = $%d / $%d ^ 2; if (q > m) m = q } END { print m + 1e-9 }' '%s'", k + 4, k + 1, main)))]
    plot for [i=1:words(routes)] rows(main, k + 1, k + 4, curve(main, word(routes, i))) using ($1 > 1e9 ? NaN : $1):($1 > 1e9 ? NaN : $2 / $1**2) with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb '#000000'
    eval no_heading
    eval panel(2)
    set title 'time' offset 0, -0.5
    set ylabel 'log_{10} (time / s)'
    set yrange [span(times, 'log10_seconds', '1', -6, -1) - 0.5:span(times, 'log10_seconds', '1', 0, 1) + 0.5]
    plot for [s=1:words(scalars)] for [i=1:words(routes)] rows(times, k + 1, place(times, 'log10_seconds'), both(curve(times, word(routes, i)), with_word(times, 'scalar', word(scalars, s)))) using 1:2 with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb shade[s + 2]
    eval key_strip
    plot for [i=1:words(routes)] NaN with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb '#000000' title 'about the '.word(routes, i), \
         for [s=1:words(scalars)] NaN with lines lw 2.4 lc rgb shade[s + 2] title word(scalars, s)
    unset multiplot
    unset output
    eval restart
}
