# expansion_point: radius of convergence and rate against the energy, and the rate against the expansion point.
# Columns: energy,point,radius,tstar,covers,rate,measured_rate,height,scalar,gap.
#
# For any equation: the radius about each time, the distance of the nearest singularity from the real axis, and the rate
# on the whole interval, one row of three panels per unknown, one curve per combination of the parameters (of the
# largest order).
# Columns: <axes>,time,order,radius,uncertainty,position_re,position_im,reach,rate,note,unknown.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    eval axes_before('time')
    last = sprintf('%.0f', span(main, 'order', '1', 0, 1))
    tone(c) = n == 1 ? shade[5] : colour(c, n)
    curve(c, u) = both(both(in_case(word(all, c)), of_unknown(main, u)), sprintf('$%d == %s', k + 2, last))
    across = 3; down = drawn
    panel_w = 400; panel_h = 360
    foot = n > 1 ? foot_for(shown_in_key(n), 20) : 20
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Where to expand '.called, 'from '.last.' powers about each time'.left_out)
        do for [p=1:drawn] {
            u = drawn_unknown(p)
            eval single_panel
            set xlabel 'expansion point / unit of the variable'
            eval rising('x', span(main, 'time', '1', 0, -1), span(main, 'time', '1', 1, 1))
            eval panel(3 * p - 2)
            set title u.': radius' offset 0, -0.5
            set ylabel 'radius R / unit of the variable'
            set yrange [0:larger(1e-30, 1.1 * span(main, 'radius', of_unknown(main, u), 1, 1))]
            plot for [c=1:n] rows(main, k + 1, place(main, 'radius'), curve(c, u)) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
            eval no_heading
            eval panel(3 * p - 1)
            set title u.': nearest singularity' offset 0, -0.5
            set ylabel '|Im t| / unit of the variable'
            set yrange [0:larger(1e-30, 1.1 * larger(span(main, 'position_im', of_unknown(main, u), 0, 1), -span(main, 'position_im', of_unknown(main, u), 0, -1)))]
            plot for [c=1:n] rows(main, k + 1, place(main, 'position_im'), curve(c, u)) using 1:(abs($2)) with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
            eval panel(3 * p)
            set title u.': rate on the whole interval' offset 0, -0.5
            set ylabel 'reach/R'
            set yrange [0:larger(1.1, 1.1 * span(main, 'rate', of_unknown(main, u), 1, 1))]
            set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1
            plot for [c=1:n] rows(main, k + 1, place(main, 'rate'), curve(c, u)) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
            unset arrow
        }
        if (n > 1) {
            eval key_strip
            plot for [c=1:n] NaN with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c) title in_key(c, n) ? case_name(main, k, word(all, c)) : ''
        }
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file = data.'/expansion_point.csv'
points = seen(file, 2, '1')
energies = seen(file, 1, '1')
n = words(points)
of(p) = sprintf('$2 == "%s"', p)
name(p) = p eq '0' ? '0 (top)' : p eq '1' ? '1 (bottom)' : p
measured = count_of(file, '$7 != ""')
# Against the distance from E = 2 if all energies are near it, else against the energy; a single energy against the
# point.
near = greatest(file, '10', '1', 1) < 0.2 && least(file, '10', '1', 1) > 0
x_of = near ? 'log(v($10)) / log(10)' : 'v($1)'
curve(p, y) = parts_at(file, x_of, y, '2', p, '('.y.') != ""')
rate_of(m) = m ? '$7' : '$6'

across = 2; down = 1
panel_w = 590; panel_h = 480
if (words(energies) > 1) {
    foot = foot_for(shown_in_key(n) + 2, 16)
    left = least(file, '1', '1', 0); right = greatest(file, '1', '1', 4)
    widest = greatest(file, '3', '1', 1)
    highest = number(ask("awk -F, '".awk_v."NR > 1 { r = v($3) / v($4); if (r > m) m = r } END { print m }' '".file."'"))
    fastest = greatest(file, '6 7', '1', 1)
    do for [kind in terminals] {
        eval figure_of(kind, 'expansion_point')
        eval heading('One expansion for the whole way from the top to the bottom: its radius and its rate', 'x is the expansion point as a fraction of T*')
        set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
        if (near) { eval falling('x', log10(least(file, '10', '1', 1)), log10(greatest(file, '10', '1', 1))) } else { eval energies_on_x(left, right); eval separatrix_on_x(left, right) }
        set xlabel near ? gap_axis : e_axis
        set arrow 2 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1
        eval panel(1)
        set ylabel 'radius of convergence R/T*'
        set yrange [0:larger(highest, 1) * 1.08]
        unset key
        set label 3 'R = T*' at graph 0.98, first 1 right offset 0, -0.7 textcolor rgb soft
        plot for [i=1:n] curve(word(points, i), 'v($3) / v($4)') using 1:2 with linespoints lw 2 pt mark_of(i) ps 0.5 lc rgb colour(i, n)
        eval no_heading
        unset label 3
        eval panel(2)
        set ylabel 'factor of the error on [0, T*] a power'
        set yrange [0:smaller(larger(fastest, 1) * 1.08, 2)]
        if (fastest > 1) { set label 3 'diverges on a part of the way' at graph 0.98, first 1 right offset 0, 0.7 textcolor rgb soft }
        plot for [i=1:n] curve(word(points, i), '$6') using 1:2 with lines lw 2 lc rgb colour(i, n), \
             for [i=1:n] curve(word(points, i), rate_of(measured)) using 1:2 with points pt mark_of(i) ps (measured ? 0.9 : 0.4) lw 1.3 lc rgb colour(i, n)
        unset label; unset arrow
        eval energies_done
        eval key_strip
        plot for [i=1:n] NaN with linespoints lw 2 pt mark_of(i) ps 0.8 lc rgb colour(i, n) title in_key(i, n) ? 'x = '.name(word(points, i)) : '', \
             NaN with lines lw 2 lc rgb soft title 'max(x, 1−x) T*/R', \
             NaN with points pt 4 ps 0.9 lw 1.3 lc rgb soft title measured ? 'measured' : ''
        eval figure_done
    }
}

# Against the expansion point, for at most six of the energies.
shown = smaller(words(energies), 6)
energy(j) = pick(energies, shown, j)
named(j) = energy_name(energy(j), first_of(file, 10, sprintf('$1 == "%s"', energy(j))))
aspect(e) = number(ask("awk -F, '$1 == \"".e."\" { printf \"%.9g\", $8 / $4; exit }' '".file."'"))
rate(x, k) = (x > 0.5 ? x : 1 - x) / sqrt((1 - x)**2 + k**2)
array k[6]
do for [j=1:shown] { k[j] = aspect(energy(j)) }
own = words(energies) > 1 ? '_rate' : ''        # a single energy has this figure alone
across = 1
panel_w = 900
foot = foot_for(shown + 2, 16)
do for [kind in terminals] {
    eval figure_of(kind, 'expansion_point'.own)
    eval heading('The expansion point that covers [0, T*] at the best rate is T*/2', 'above 1 the expansion diverges at an end of the way')
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    eval panel(1)
    set xlabel 'expansion point, fraction x of T* (0 the top, 1 the bottom)'
    set ylabel 'factor of the error on [0, T*] a power'
    set xrange [0:1]
    highest = 1
    do for [j=1:shown] { highest = larger(highest, rate(1, k[j])) }
    set yrange [0:smaller(highest * 1.1, 2)]
    set samples 401
    unset key
    set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888'
    set arrow 2 from 0.5, graph 0 to 0.5, graph 1 nohead lc rgb '#888888' dt 3
    plot for [j=1:shown] rate(x, k[j]) with lines lw 2 dt j lc rgb shade[j], \
         for [j=1:shown] rows_at(file, 2, measured ? 7 : 6, '1', energy(j), '1') using 1:2 with points pt mark[j] ps 1.2 lw 1.5 lc rgb shade[j]
    eval no_heading
    eval key_strip
    plot for [j=1:shown] NaN with linespoints lw 2 dt j pt mark[j] lc rgb shade[j] title 'E = '.named(j), \
         NaN with lines lw 2 lc rgb soft title 'max(x, 1−x) T*/R', \
         NaN with points pt 4 ps 1.2 lw 1.5 lc rgb soft title measured ? 'measured' : ''
    eval figure_done
}
