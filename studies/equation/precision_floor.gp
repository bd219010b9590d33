# precision_floor of any equation: the norms over the order in each arithmetic, a panel for each unknown, of the first
# combination of the parameters; thin without rounding, short lines at the epsilon of each arithmetic.
# Columns: <axes>,order,method,scalar,norm,exact_norm,epsilon,norm_in_epsilon,floor,log10_norm,log10_exact_norm,
# log10_epsilon,unknown.
load scripts.'/equation/panels.gp'

k = place(main, 'order') - 1
all = cases(main, k)
scalars = seen(main, k + 3, '1')
n = words(scalars)
curve(u, m, s) = both(both(in_case(word(all, 1)), of_unknown(main, u)), both(with_word(main, 'method', m), with_word(main, 'scalar', s)))
eval grid(drawn, 3)
foot = foot_for(n + 3, 14)
bottom = smaller(span(main, 'log10_norm', '1', -1, -1), span(main, 'log10_epsilon', '1', -1, -1))
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Where rounding takes over in '.called, 'the largest error at the times'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))).left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u offset 0, -0.5
        set xlabel 'order N'
        set ylabel 'log_{10} (max |error| / '.unit_name(u).')'
        eval rising('x', span(main, 'order', '1', 0, -1), span(main, 'order', '1', 1, 1))
        set yrange [bottom - 2:span(main, 'log10_norm', '1', 1, 1) + 1]
        do for [i=1:n] {
            level = number(first_of(main, place(main, 'log10_epsilon'), curve(u, 'series', word(scalars, i))))
            set arrow i from graph 0.85, first level to graph 1, first level nohead lc rgb shade[i] lw 1.6 dt 4
        }
        plot for [m in 'series pade'] rows(main, k + 1, place(main, 'log10_exact_norm'), curve(u, m, word(scalars, 1))) using 1:2 with lines lw 1 dt 3 lc rgb '#444444', \
             for [i=1:n] for [m in 'series pade'] rows(main, k + 1, place(main, 'log10_norm'), curve(u, m, word(scalars, i))) using 1:2 with linespoints lw 1.6 dt m eq 'series' ? 1 : 2 pt mark[m eq 'series' ? 1 : 2] ps 0.6 lc rgb shade[i]
        unset arrow
        eval no_heading
    }
    eval key_strip
    plot NaN with linespoints lw 1.6 dt 1 pt mark[1] ps 0.7 lc rgb soft title 'series', \
         NaN with linespoints lw 1.6 dt 2 pt mark[2] ps 0.7 lc rgb soft title 'Padé [N/2, N/2]', \
         NaN with lines lw 1 dt 3 lc rgb '#444444' title 'without rounding', \
         for [i=1:n] NaN with lines lw 2.4 lc rgb shade[i] title word(scalars, i)
    unset multiplot
    unset output
    eval restart
}
