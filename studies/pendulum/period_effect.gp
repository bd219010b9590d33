# period_effect: theta against the time, extended with the T* of each rule, and the error below; one column per energy,
# three at most. If there are several orders N, the first is drawn.
# Columns: energy,period_by,order,period,period_error,time,theta,error,log10_error,periods,gap,method.
load scripts.'/style.gp'

file = data.'/period_effect.csv'
numerical = data.'/period_effect_numerical.csv'
energies = seen(file, 1, '1')
rules = seen(file, 2, '1')
n = words(rules)
order = first_of(file, 3, '1')
columns = smaller(words(energies), 3)

# Long dashes for (Kold); for (Knew) the last rule solid and those before it dashed; the exact T* a thin grey line.
last_resummed = 0
do for [i=1:n] { if (word(rules, i)[1:1] eq 'r') { last_resummed = i } }
array dashes[4] = ['-', '.', '-.', '-..']
dash(i) = word(rules, i)[1:1] eq 's' ? '_' : (word(rules, i)[1:1] eq 'a' || i == last_resummed) ? 1 : dashes[(i-1)%4+1]
hue(i) = word(rules, i) eq 'agm' ? '#888888' : n > 6 ? colour(i, n) : shade[(7-i)%6+1]
weight(i) = word(rules, i) eq 'agm' ? 1.2 : 2.3
of(e, i) = e.','.word(rules, i).','.order
name_of(i) = rule_name(word(rules, i))

across = columns
down = 2
panel_w = columns == 1 ? 940 : columns == 2 ? 600 : 420
panel_h = 300
foot = foot_for(shown_in_key(n) + 1, 20)
do for [kind in terminals] {
    eval figure_of(kind, 'period_effect')
    eval heading('The resummation (N = '.order.') extended with an inexact T*', 'the key names the sum from which T* is computed'.(words(energies) > columns ? sprintf('; %d of %d energies', columns, words(energies)) : ''))
    set lmargin 9; set rmargin 3; set tmargin 2
    do for [c=1:columns] {
        e = pick(energies, columns, c)
        which = sprintf('$1 == "%s"', e)
        first = least(file, '10', which, 0); last = greatest(file, '10', which, 1)
        set xrange [first:last > first ? last : first + 1]
        eval panel(c)
        set title 'E = '.energy_name(e, first_of(file, 11, which)) offset 0, -0.5
        eval upper_panel
        if (c == 1) { set ylabel 'angle θ / (π rad)' } else { unset ylabel }
        low = least(file, '7', which, 0) / pi; high = greatest(file, '7', which, 1) / pi
        set yrange [low - room(low, high):high + room(low, high)]
        unset key
        plot for [i=1:n] broken_at(file, 10, 7, '1 2 3', of(e, i)) using 1:($2/pi) with lines lw weight(i) dt dash(i) lc rgb hue(i), \
             broken_at(numerical, 10, 7, '1', e) using 1:($2/pi) with points pt 7 ps 0.6 lc rgb '#000000'
        eval no_heading
        eval panel(c + columns)
        eval lower_panel
        set xlabel 'time t / T, T exact'
        if (c == 1) { set ylabel error_axis } else { unset ylabel }
        low = larger(least(file, '9', which, -12), -14); high = greatest(file, '9', which, 0)
        set yrange [low - 0.5:larger(high, low + 1) + 0.5]
        plot for [i=1:n] broken_at(file, 10, 9, '1 2 3', of(e, i)) using 1:2 with lines lw weight(i) dt dash(i) lc rgb hue(i), \
             broken_at(numerical, 10, 9, '1', e) using 1:2 with points pt 7 ps 0.5 lc rgb '#000000'
    }
    eval key_strip
    plot for [i=1:n] NaN with lines lw weight(i) dt dash(i) lc rgb hue(i) title in_key(i, n) ? name_of(i) : '', \
         NaN with points pt 7 ps 0.6 lc rgb '#000000' title 'Runge-Kutta (RK4)'
    eval figure_done
}
