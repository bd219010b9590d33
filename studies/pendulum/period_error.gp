# period_error: for one energy or two, the error of T* against the order, with its bounds and its rate; otherwise
# against the energy, and towards the separatrix on either side.
# Columns: energy,order,method,error,tstar,gap,bound,bound_over_error,scalar,log10_error,log10_bound,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-400 nor 2 - 1e-22 is representable in double.
load scripts.'/style.gp'

file = data.'/period_error.csv'
orders = sorted(file, 2, '1')
energies = seen(file, 1, '1')
n = words(orders)
at(e, method) = sprintf('$1 == "%s" && $3 == "%s"', e, method)
period_axis = 'log_{10} (|error of T*| / (ℓ/g)^{1/2})'

style = words(energies) > 20 ? 'lines' : 'linespoints pt 7 ps 0.5'

if (words(energies) <= 2) {
    tone(m) = m eq 'series' ? shade[5] : shade[4]
    eval grid(words(energies), 2)
    panel_w = across == 1 ? 900 : 590
    panel_h = 520
    foot = foot_for(4, 12)
    # log10 of m, the parameter of K: E/2 below E = 2 and 2/E above; by the gap, as E may be a long decimal.
    parameter(e, g) = g[1:1] eq '-' ? log10(2 / (2 - number(g))) : log10(number(tidy(e)) / 2)
    do for [kind in terminals] {
        eval figure_of(kind, 'period_error')
        eval heading('Convergence of T* by the series of K and by its resummation', 'm = E/2 below E = 2 and 2/E above it')
        do for [p=1:words(energies)] {
            e = word(energies, p)
            which = sprintf('$1 == "%s"', e)
            g = first_of(file, 6, which)
            rate = parameter(e, g)
            low = least(file, '10', which, 0); high = greatest(file, '10', which, 0)
            first = first_of(file, 10, at(e, 'series').sprintf(' && $2 == %s', word(orders, 1)))
            start = (first eq '' || first eq '-inf' ? high : number(first)) - rate * word(orders, 1)
            eval panel(p)
            set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6
            set title 'E = '.energy_name(e, g).sprintf(', rate m = %.4g', 10**rate) offset 0, -0.5
            set xrange [0:larger(word(orders, n) * 1.06, 2)]
            set yrange [low - room(low, high):high + room(low, high)]
            set xlabel 'order N'
            if ((p - 1) % across == 0) { set ylabel period_axis } else { unset ylabel }
            unset key
            plot start + x * rate with lines lw 1.2 dt 5 lc rgb '#444444', \
                 for [m in 'series resummed'] rows_at(file, 2, 10, '1 3', e.','.m, '1') using 1:2 with linespoints lw 2.2 dt dash_of(m) pt 7 ps 0.6 lc rgb tone(m), \
                 for [m in 'series resummed'] rows_at(file, 2, 11, '1 3', e.','.m, '1') using 1:2 with points pt 2 ps 0.7 lc rgb tone(m)
            eval no_heading
        }
        eval key_strip
        plot NaN with linespoints lw 2.2 dt 2 pt 7 ps 0.6 lc rgb tone('series') title 'series', \
             NaN with linespoints lw 2.2 dt 1 pt 7 ps 0.6 lc rgb tone('resummed') title 'resummation', \
             NaN with points pt 2 ps 0.7 lc rgb soft title 'proved bound', \
             NaN with lines lw 1.2 dt 5 lc rgb '#444444' title 'rate m^N'
        eval figure_done
    }
} else {
    apart = words(energies) > 20 ? 4 : 1                            # energies between two crosses
    crossed = sprintf('int((NR - 2)/%d) %% %d == 0', 2*n, apart)
    near(side) = sprintf('$12 < -0.9 && $6 %s /^-/', side)
    librations = words(seen(file, 12, near('!~'))) > 1
    rotations = words(seen(file, 12, near('~'))) > 1
    over_energy = words(seen(file, 1, '$12 > -2.1')) > 1 || librations + rotations == 0
    eval grid(over_energy + librations + rotations, 3)
    panel_w = across == 1 ? 900 : across == 2 ? 590 : 400
    panel_h = 540
    foot = foot_for(shown_in_key(n) + 3, 12)
    limit(order) = log10(1.0 / (8 * order + 7))
    do for [kind in terminals] {
        eval figure_of(kind, 'period_error')
        eval heading('Error of T* from the series of K and from its resummation', librations + rotations > 0 ? 'bars on the right: 1/(8N + 7), where the resummation stays at E = 2' : ' ')
        set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
        p = 0
        if (over_energy) {
            p = p + 1
            eval panel(p)
            left = least(file, '1', '1', 0); right = greatest(file, '1', '1', 4)
            eval energies_on_x(left, right)
            eval separatrix_on_x(left, right)
            set yrange [larger(least(file, '10', '1', 0), -40) - 1:greatest(file, '10', '1', 0) + 2]
            set xlabel e_axis
            set ylabel period_axis
            unset key
            plot for [i=1:n] for [m in 'series resummed'] rows_at(file, 1, 10, '2 3', word(orders, i).','.m, '1') using 1:2 with @style lw 2 dt dash_of(m) lc rgb colour(i, n), \
                 for [i=1:n] for [m in 'series resummed'] rows_at(file, 1, 11, '2 3', word(orders, i).','.m, crossed) using 1:2 with points pt 2 ps 0.6 lc rgb colour(i, n)
            eval energies_done
            eval no_heading
        }
        do for [side in '!~ ~'] {
            if (side eq '~' ? rotations : librations) {
                p = p + 1
                which = sprintf(' && $6 %s /^-/', side)
                eval panel(p)
                eval falling('x', least(file, '12', '1'.which, 0), greatest(file, '12', '1'.which, 0))
                low = least(file, '10', near(side), 0)
                set yrange [larger(low, -8) - 1:greatest(file, '10', near(side), 0) + 1]
                set title side eq '~' ? 'rotation, E > 2' : 'libration, E < 2' offset 0, -0.5
                set xlabel gap_axis
                if (p == 1) { set ylabel period_axis } else { unset ylabel }
                do for [i=1:n] {
                    set arrow 10+i from graph 0.965, first limit(word(orders, i) + 0) to graph 1, first limit(word(orders, i) + 0) nohead lw 3.5 lc rgb colour(i, n)
                }
                unset key
                plot for [i=1:n] for [m in 'series resummed'] rows_at(file, 12, 10, '2 3', word(orders, i).','.m, '1'.which) using 1:2 with @style lw 2 dt dash_of(m) lc rgb colour(i, n), \
                     for [i=1:n] for [m in 'series resummed'] rows_at(file, 12, 11, '2 3', word(orders, i).','.m, crossed.which) using 1:2 with points pt 2 ps 0.6 lc rgb colour(i, n)
                do for [i=1:n] { unset arrow 10+i }
                eval no_heading
            }
        }
        eval key_strip
        plot for [i=1:n] NaN with lines lw 2.4 lc rgb colour(i, n) title in_key(i, n) ? 'N = '.word(orders, i) : '', \
             NaN with lines lw 2 dt 2 lc rgb soft title 'series', \
             NaN with lines lw 2 lc rgb soft title 'resummation', \
             NaN with points pt 2 ps 0.6 lc rgb soft title 'proved bound'
        eval figure_done
    }
}
