# divergence: partial sums about the bottom against the exact angle (above) and their error (below), one column per
# energy. Columns: energy,order,time,periods,theta,theta_exact,error,log10_error,log10_abs_theta,gap;
# of _radius: energy,tstar,radius,period,radius_over_tstar,gap. Angles beyond 1e300 are excluded by their log10.
#
# For any equation: the solution and its partial sums against time, one panel per unknown, for the first combination of
# the parameters; dotted lines at the radius of convergence on either side of the initial point.
# Columns: <axes>,order,time,value,solution,error,log10_error,log10_abs_value,unknown; in _radius reach, radius, ...
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    radii = table_of('_radius')
    eval axes_before('order')
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
            eval panel_of_unknown(p)
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
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

main = data.'/divergence.csv'
of_radius = data.'/divergence_radius.csv'
energies = seen(of_radius, 1, '1')
orders = sorted(main, 2, '1')
n = words(orders)
tone(i) = n <= 6 ? shade[word('4 6 2 3 5 1', i) + 0] : colour(i, n)     # neighbours far apart
columns = smaller(words(energies), 3)
known(e, c) = number(first_of(of_radius, c, sprintf('$1 == "%s"', e)))
rows_of(e) = count_of(main, sprintf('$1 == "%s" && $2 == %s', e, word(orders, 1)))

# Energies are compared as text: 2 - 1e-20 differs from 2.
of(e, i) = e.','.word(orders, i)
tame = '($9 == "-inf" || $9 + 0 < 2 ? $5 : $5 ~ /^-/ ? "-100" : "100")'
dash(i) = n <= 6 ? i + 1 : 1

across = columns
down = 2
panel_w = columns == 1 ? 860 : columns == 2 ? 590 : 420
panel_h = 340
foot = foot_for(shown_in_key(n) + 1, 12)
low = larger(least(main, '8', '1', -16), -20)
high = smaller(greatest(main, '8', '1', 0), 8)
do for [kind in terminals] {
    eval figure_of(kind, 'divergence')
    eval heading('Taylor series about the bottom: it diverges at R', 'R is the radius of convergence, T* the time from the bottom to the top'.(words(energies) > columns ? sprintf('; %d of %d energies', columns, words(energies)) : ''))
    set lmargin 9; set rmargin 3; set tmargin 2
    do for [c=1:columns] {
        e = pick(energies, columns, c)
        which = sprintf('$1 == "%s"', e)
        tstar = known(e, 2); reach = known(e, 3)
        below = least(main, '6', which, 0); above = greatest(main, '6', which, 1)
        first = least(main, '3', which, 0); last = greatest(main, '3', which, 1)
        height = above > below ? above - below : 1
        apart = rows_of(e) > 80 ? rows_of(e)/40 : 1     # rows between two circles
        set xrange [first:last > first ? last : first + 1]
        set arrow 1 from reach, graph 0 to reach, graph 1 nohead lc rgb '#555555' lw 1.2
        set arrow 2 from tstar, graph 0 to tstar, graph 1 nohead lc rgb '#555555' lw 1.2 dt 2
        eval panel(c)
        set title 'E = '.energy_name(e, first_of(of_radius, 6, which)).(first_of(of_radius, 6, which)[1:1] eq '-' ? ' (rotation)' : ' (libration)') offset 0, -0.5
        eval upper_panel
        if (c == 1) { set ylabel 'angle θ / rad' } else { unset ylabel }
        set yrange [below - 0.35*height:above + 0.35*height]
        unset key
        plot for [i=1:n] parts_at(main, '$3', tame, '1 2', of(e, i), '1') using 1:2 with lines lw 2.2 dt dash(i) lc rgb tone(i), \
             parts_at(main, '$3', '$6', '1 2', of(e, 1), sprintf('(NR - 2) %% %d == 0', apart)) using 1:2 with points pt 6 ps 0.8 lc rgb '#222222'
        eval no_heading
        eval panel(c + columns)
        eval lower_panel
        set xlabel t_axis
        if (c == 1) { set ylabel error_axis } else { unset ylabel }
        set yrange [low:high]
        if (reach <= last) { set label 1 'R' at reach, graph 0.03 left offset 0.5, 0 }
        if (tstar <= last) { set label 2 'T*' at tstar, graph 0.03 left offset 0.5, 0 }
        plot for [i=1:n] parts_at(main, '$3', '$8', '1 2', of(e, i), '$8 != "-inf"') using 1:2 with lines lw 2.2 dt dash(i) lc rgb tone(i)
        unset label; unset arrow
    }
    eval key_strip
    plot for [i=1:n] NaN with lines lw 2.2 dt dash(i) lc rgb tone(i) title in_key(i, n) ? 'N = '.word(orders, i) : '', \
         NaN with points pt 6 ps 0.8 lc rgb '#222222' title 'exact'
    eval figure_done
}
