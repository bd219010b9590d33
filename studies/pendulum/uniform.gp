# uniform: error of the uniform resummation against the energy, for E < 1, 1 < E < 2 and E > 2, or for one energy or two
# against the number of coefficients.
# Columns: energy,gap,count,order,norm,time_of_maximum,scalar,rigour,bound,rate,log10_norm,log10_bound,
# log10_energy,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-100 nor 2 - 1e-100 is representable in double.
load scripts.'/style.gp'
tone(i, n) = n <= 6 ? shade[word('4 3 5 2 1 6', i) + 0] : colour(i, n)     # neighbours far apart

exact = data.'/uniform.csv'
rounded = data.'/uniform_double.csv'
counts = sorted(exact, 3, '1')
n = words(counts)
energies = seen(exact, 1, '1')
drawn = count_of(exact, '$3 == 16') > 0 ? '16' : word(counts, 1)
low = smaller(least(exact, '11', '1', -1), least(rounded, '11', '1', 0))
high = larger(greatest(exact, '11 12', '1', 0), 0)

if (words(energies) <= 2) {
    eval grid(words(energies), 2)
    panel_w = across == 1 ? 900 : 590
    panel_h = 500
    foot = foot_for(4, 16)
    do for [kind in terminals] {
        eval figure_of(kind, 'uniform')
        eval heading('Convergence of the uniform resummation on [0, T*]', in_arithmetic(first_of(exact, 7, '1')).' and in double')
        do for [p=1:words(energies)] {
            e = word(energies, p)
            which = sprintf('$1 == "%s"', e)
            eval panel(p)
            set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6
            set title 'E = '.energy_name(e, first_of(exact, 2, which)).sprintf(', rate %.4g a coefficient', number(first_of(exact, 10, which))) offset 0, -0.5
            set xrange [0:word(counts, n) * 1.06]
            set yrange [low - room(low, high):high + room(low, high)]
            set xlabel 'coefficients that are not 0'
            if (p == 1) { set ylabel norm_axis } else { unset ylabel }
            set arrow 1 from graph 0, first -15.65 to graph 1, first -15.65 nohead lc rgb '#888888' lw 1.2 dt 4
            unset key
            plot rows(exact, 3, 12, which) using 1:2 with lines lw 1.5 dt 3 lc rgb shade[5], \
                 rows(exact, 3, 11, which) using 1:2 with linespoints pt 7 ps 0.6 lw 2.2 lc rgb shade[5], \
                 rows(rounded, 3, 11, which) using 1:2 with points pt 6 ps 1 lw 1.3 lc rgb '#333333'
            unset arrow
            eval no_heading
        }
        eval key_strip
        plot NaN with linespoints pt 7 ps 0.6 lw 2.2 lc rgb shade[5] title 'uniform', \
             NaN with lines lw 1.5 dt 3 lc rgb shade[5] title 'proved bound (U)', \
             NaN with points pt 6 ps 1 lw 1.3 lc rgb '#333333' title 'in double', \
             NaN with lines lw 1.2 dt 4 lc rgb '#888888' title 'ε of double'
        eval figure_done
    }
} else {
    # The panels: condition, column of x, title.
    array where[3] = ['$13 <= 0', '$13 > 0 && $2 !~ /^-/', '$2 ~ /^-/']
    array column_of[3] = [13, 14, 14]
    array titled[3] = ['towards rest', 'libration, E < 2', 'rotation, E > 2']
    panels = ''
    do for [k=1:3] { if (words(seen(exact, 1, where[k])) > 1) { panels = panels.' '.k } }
    if (panels eq '') { do for [k=1:3] { if (count_of(exact, where[k]) > 0) { panels = panels.' '.k } } }
    eval grid(words(panels), 3)
    panel_w = across == 1 ? 900 : across == 2 ? 590 : 400
    panel_h = 500
    foot = foot_for(shown_in_key(n) + 2, 16)
    do for [kind in terminals] {
        eval figure_of(kind, 'uniform')
        eval heading('Error of the uniform resummation on [0, T*] by its number of coefficients', 'the same accuracy at every energy: from rest over the separatrix to fast rotation')
        set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
        do for [p=1:words(panels)] {
            k = word(panels, p) + 0
            c = column_of[k]
            eval panel(p)
            set title titled[k] offset 0, -0.5
            a = least(exact, sprintf('%d', c), where[k], 0); b = greatest(exact, sprintf('%d', c), where[k], 0)
            eval k == 1 ? rising('x', a, b) : falling('x', a, b)
            set xlabel k == 1 ? 'log_{10} (E / (m g ℓ))' : gap_axis
            if (p == 1) { set ylabel norm_axis } else { unset ylabel }
            set yrange [low - room(low, high):smaller(high, 2) + 0.5]
            unset key
            plot for [i=1:n] rows_at(exact, c, 12, '3', word(counts, i), where[k]) using 1:2 with lines lw 1.5 dt 3 lc rgb tone(i, n), \
                 for [i=1:n] rows_at(exact, c, 11, '3', word(counts, i), where[k]) using 1:2 with linespoints pt 7 ps 0.35 lw 2.2 lc rgb tone(i, n), \
                 rows_at(rounded, c, 11, '3', drawn, where[k]) using 1:2 with points pt 6 ps 0.6 lc rgb '#333333'
            eval no_heading
        }
        eval key_strip
        plot for [i=1:n] NaN with lines lw 2.4 lc rgb tone(i, n) title in_key(i, n) ? word(counts, i).' coefficients' : '', \
             NaN with points pt 6 ps 0.8 lc rgb '#333333' title drawn.', in double', \
             NaN with lines lw 1.5 dt 3 lc rgb soft title 'proved bound (U)'
        eval figure_done
    }
}
