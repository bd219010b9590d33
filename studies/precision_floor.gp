# precision_floor: norm against the order for each arithmetic, one panel per energy.
# Columns: energy,order,method,scalar,norm,exact_norm,norm_in_epsilon,epsilon,floor,log10_norm,log10_exact_norm,
# log10_epsilon,gap.
#
# For any equation: the norms against the order in each arithmetic, one panel per unknown, for the first combination of
# the parameters; thin without rounding, short lines at the epsilon of each arithmetic.
# Columns: <axes>,order,method,scalar,norm,exact_norm,epsilon,norm_in_epsilon,floor,log10_norm,log10_exact_norm,
# log10_epsilon,unknown.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    eval axes_before('order')
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
            eval panel_of_unknown(p)
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
             for [i=1:n] NaN with lines lw 2.4 lc rgb shade[i] title arithmetic_name(word(scalars, i))
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file = data.'/precision_floor.csv'
energies = seen(file, 1, '1')
scalars = seen(file, 4, '1')
epsilons = ask(sprintf("cut -d, -f4,12 '%s' | tail -n +2 | awk -F, '!seen[$1]++ {print $2}'", file))
n = words(scalars)
last = greatest(file, '2', '1', 1)
single = words(seen(file, 2, '1')) == 1
panels = smaller(words(energies), 9)
of(e, s, method) = e.','.word(scalars, s).','.method
style = single ? 'points pt 7' : 'lines'
tone(s) = colour(n <= 4 ? s + 2 : s, n <= 4 ? 6 : n)

eval grid(panels, 3)
panel_w = panels == 1 ? 860 : 400
panel_h = panels == 1 ? 520 : 360
foot = foot_for(shown_in_key(n) + 4, 18)
do for [kind in terminals] {
    eval figure_of(kind, 'precision_floor')
    eval heading('How small the error gets before rounding dominates', 'error norm on [0, T*]'.(panels < words(energies) ? sprintf(', %d of %d energies', panels, words(energies)) : ''))
    set xrange [0:last * 1.06]
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    do for [p=1:panels] {
        e = pick(energies, panels, p)
        which = sprintf('$1 == "%s"', e)
        eval panel(p)
        set title 'E = '.energy_name(e, first_of(file, 13, which)) offset 0, -0.5
        set yrange [smaller(least(file, '10', which, 0), least(file, '12', '1', 0)) - 2:greatest(file, '10 11', which, 0) + 2]
        set xlabel 'order N'
        if ((p - 1) % across == 0) { set ylabel norm_axis } else { unset ylabel }
        unset key
        do for [s=1:n] {
            set arrow s from graph 0.95, first (word(epsilons, s) + 0) to graph 1, first (word(epsilons, s) + 0) nohead lw 4 lc rgb tone(s)
        }
        plot for [m in 'series resummed'] rows_at(file, 2, 11, '1 4 3', of(e, 1, m), '1') using 1:2 with @style lw 1.3 dt 3 lc rgb '#666666', \
             for [s=1:n] rows_at(file, 2, 10, '1 4 3', of(e, s, 'series'), '1') using 1:2 with @style lw 2 dt 2 lc rgb tone(s), \
             for [s=1:n] rows_at(file, 2, 10, '1 4 3', of(e, s, 'resummed'), '1') using 1:2 with @style lw 2 lc rgb tone(s)
        do for [s=1:n] { unset arrow s }
        eval no_heading
    }
    eval key_strip
    plot for [s=1:n] NaN with lines lw 2.4 lc rgb tone(s) title arithmetic_name(word(scalars, s)), \
         NaN with lines lw 2 dt 2 lc rgb soft title 'series', \
         NaN with lines lw 2 lc rgb soft title 'resummation', \
         NaN with lines lw 1.3 dt 3 lc rgb '#666666' title 'without rounding', \
         NaN with lines lw 4 lc rgb '#666666' title 'ε, on the right'
    eval figure_done
}
