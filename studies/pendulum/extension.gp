# The figure of the four studies that share studies/extension.hpp: theta against the time in periods, the error below;
# one column per energy, three at most. The script that loads this one sets `name` and `heading_text`.
# Columns: energy,order,method,time,theta,omega,error,log10_error,periods,gap.
load scripts.'/style.gp'

file = data.'/'.name.'.csv'
numerical = data.'/'.name.'_numerical.csv'
exact = data.'/'.name.'_exact.csv'
energies = seen(file, 1, '1')
orders = sorted(file, 2, '1')
n = words(orders)
columns = smaller(words(energies), 3)
resummed = first_of(file, 3, '1') eq 'resummed'
array dashes[6] = ['_', '-', '.', '_.', '-.', '_..']
dash(i) = resummed || n > 6 ? 1 : dashes[i]

# number of T* in a period: 4 below E = 2, where the gap 2 - E has no minus sign
marks(e) = first_of(file, 10, sprintf('$1 == "%s"', e))[1:1] eq '-' ? 2 : 4
# Vertical grey lines at the multiples of T*.
grid_lines = "do for [q=ceil(first * marks(e)):floor(last * marks(e))] { set arrow from q / (1.0 * marks(e)), graph 0 to q / (1.0 * marks(e)), graph 1 nohead back lw 0.8 lc rgb (q % marks(e) ? '#dddddd' : '#999999') }"

across = columns
down = 2
panel_w = columns == 1 ? 940 : columns == 2 ? 600 : 420
panel_h = 300
foot = foot_for(shown_in_key(n) + 2, 16)
do for [kind in terminals] {
    eval figure_of(kind, name)
    eval heading(heading_text, 'T is the period; vertical lines at the multiples of T*, a quarter or half of it'.(words(energies) > columns ? sprintf('; %d of %d energies', columns, words(energies)) : ''))
    set lmargin 9; set rmargin 3; set tmargin 2
    do for [c=1:columns] {
        e = pick(energies, columns, c)
        which = sprintf('$1 == "%s"', e)
        first = least(exact, '9', which, 0); last = greatest(exact, '9', which, 1)
        if (last <= first) { last = first + 1 }
        set xrange [first:last]
        eval grid_lines
        eval panel(c)
        set title 'E = '.energy_name(e, first_of(file, 10, which)) offset 0, -0.5
        eval upper_panel
        if (c == 1) { set ylabel 'angle θ / (π rad)' } else { unset ylabel }
        low = least(exact, '5', which, 0) / pi; high = greatest(exact, '5', which, 1) / pi
        set yrange [low - 0.12 * (high - low) - 0.02:high + 0.12 * (high - low) + 0.02]
        unset key
        plot broken_at(exact, 9, 5, '1', e) using 1:($2/pi) with lines lw 1 lc rgb '#888888', \
             for [i=1:n] broken_at(file, 9, 5, '1 2', e.','.word(orders, i)) using 1:($2/pi) with lines lw 2.3 dt dash(i) lc rgb colour(i, n), \
             broken_at(numerical, 9, 5, '1', e) using 1:($2/pi) with points pt 6 ps 0.8 lw 1.2 lc rgb '#000000'
        eval no_heading
        eval panel(c + columns)
        eval lower_panel
        set xlabel 'time t / T'
        if (c == 1) { set ylabel error_axis } else { unset ylabel }
        set yrange [larger(least(file, '8', which, -16) - 0.5, -20):larger(greatest(file, '8', which, 0), -12) + 0.5]
        plot for [i=1:n] broken_at(file, 9, 8, '1 2', e.','.word(orders, i)) using 1:2 with lines lw 2.3 dt dash(i) lc rgb colour(i, n), \
             broken_at(numerical, 9, 8, '1', e) using 1:2 with points pt 6 ps 0.6 lc rgb '#000000'
        unset arrow
    }
    eval key_strip
    plot for [i=1:n] NaN with lines lw 2.3 dt dash(i) lc rgb colour(i, n) title in_key(i, n) ? 'N = '.word(orders, i) : '', \
         NaN with lines lw 1 lc rgb '#888888' title 'exact', \
         NaN with points pt 6 ps 0.8 lw 1.2 lc rgb '#000000' title 'Runge-Kutta (RK4)'
    eval figure_done
}
