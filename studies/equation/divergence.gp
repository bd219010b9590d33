# divergence of any equation: the solution and its partial sums over time, a panel for each unknown, of the first
# combination of the parameters; dotted lines at the radius of convergence on either side of the start.
# Columns: <axes>,order,time,value,solution,error,log10_error,log10_abs_value,unknown; in _radius reach, radius, ...
load scripts.'/equation/panels.gp'

radii = table_of('_radius')
k = place(main, 'order') - 1
all = cases(main, k)
orders = sorted(main, k + 1, '1')
n = words(orders)
place_x = place(main, 'time')
curve(u, o) = both(both(in_case(word(all, 1)), of_unknown(main, u)), sprintf('$%d == %s', k + 1, o))
eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 2, 12)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Partial sums of '.called, 'about the start'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))).left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u offset 0, -0.5
        set xlabel 'time / unit of the variable'
        set ylabel u
        eval rising('x', span(main, 'time', '1', 0, -1), span(main, 'time', '1', 1, 1))
        low = span(main, 'solution', of_unknown(main, u), 0, -1)
        high = span(main, 'solution', of_unknown(main, u), 1, 1)
        set yrange [low - larger(0.4 * (high - low), 1e-9):high + larger(0.4 * (high - low), 1e-9)]
        r = first_of(radii, place(radii, 'radius'), both(in_case(word(all, 1)), of_unknown(radii, u)))
        if (strlen(r) > 0) { do for [sign in '-1 1'] { if ((sign + 0) * number(r) >= span(main, 'time', '1', 0, -1) && (sign + 0) * number(r) <= span(main, 'time', '1', 1, 1)) { set arrow int(sign + 2) from (sign + 0) * number(r), graph 0 to (sign + 0) * number(r), graph 1 nohead lc rgb '#888888' dt 3 lw 1.5 } } }
        plot rows(main, place_x, place(main, 'solution'), curve(u, word(orders, 1))) using 1:2 with lines lw 3 lc rgb '#000000', \
             for [i=1:n] rows(main, place_x, place(main, 'value'), curve(u, word(orders, i))) using 1:2 with lines lw 1.8 lc rgb n <= 5 ? shade[i] : colour(i, n)
        unset arrow
        eval no_heading
    }
    eval key_strip
    plot NaN with lines lw 3 lc rgb '#000000' title 'solution', \
         NaN with lines dt 3 lw 1.5 lc rgb '#888888' title 'radius', \
         for [i=1:n] NaN with lines lw 1.8 lc rgb n <= 5 ? shade[i] : colour(i, n) title in_key(i, n) ? 'N = '.word(orders, i) : ''
    unset multiplot
    unset output
    eval restart
}
