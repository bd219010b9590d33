# divergence: partial sums about the bottom against the exact angle (above) and their error (below), one column an energy.
# Columns: energy,order,time,periods,theta,theta_exact,error,log10_error,log10_abs_theta,gap;
# of _radius: energy,tstar,radius,period,radius_over_tstar,gap. Angles beyond 1e300 are kept away by their log10.
load scripts.'/style.gp'
tone(i) = shade[word('4 6 2 3 5 1', (i - 1)%6 + 1) + 0]     # neighbours far apart

file(suffix) = data.'/divergence'.suffix.'.csv'
energies = system(sprintf("cut -d, -f1 '%s' | tail -n +2", file('_radius')))
orders = system(sprintf("cut -d, -f2 '%s' | tail -n +2 | sort -nu", file('')))
panels = words(energies)
radius(e, c) = real(system(sprintf("awk -F, 'NR == %d {print $%d}' '%s'", e + 1, c, file('_radius'))))
range_of(e, c, pick) = real(system(sprintf("awk -F, '$1 == \"%s\" {print $%d}' '%s' | grep -v inf | sort -g%s | tail -n 1", word(energies, e), c, file(''), pick)))
rows_of(e) = int(system(sprintf("awk -F, '$1 == \"%s\" && $2 == %s' '%s' | wc -l", word(energies, e), word(orders, 1), file(''))))

# Energies are compared as they are written: 2 - 1e-20 is not 2.
of(e, n, y) = (strcol(1) eq word(energies, e) && column(2) == n) ? y : NaN
tame(y) = (strcol(9) eq '-inf' || column(9) < 2) ? y : (strcol(5)[1:1] eq '-' ? -100 : 100)
finite(y) = strcol(8) eq '-inf' ? NaN : y
few(y) = int(column(0)) % apart == 0 ? y : NaN

do for [kind in terminals] {
    eval use_terminal(kind, target.'/divergence', panels > 1 ? 560*panels + 60 : 700, 760)
    set multiplot title 'Taylor series about the bottom (dashed): it diverges at R' font ',16' offset 0, -0.2
    do for [e=1:panels] {
        left = (e - 1.0)/panels
        tstar = radius(e, 2); reach = radius(e, 3)
        below = range_of(e, 6, 'r'); above = range_of(e, 6, '')
        latest = range_of(e, 3, ''); earliest = range_of(e, 3, 'r')
        height = above > below ? above - below : 1
        apart = rows_of(e) > 80 ? rows_of(e)/40 : 1     # rows between two circles
        set size 1.0/panels, 0.5
        set xrange [earliest : latest > earliest ? latest : earliest + 1]
        set lmargin 9; set rmargin 2
        set arrow 1 from reach, graph 0 to reach, graph 1 nohead lc rgb '#555555' lw 1.2
        set arrow 2 from tstar, graph 0 to tstar, graph 1 nohead lc rgb '#555555' lw 1.2 dt 2

        set origin left, 0.46
        set title sprintf('E = %s (%s)', word(energies, e), tstar*3 < radius(e, 4) ? 'libration' : 'rotation') offset 0, -0.4
        set format x ''
        unset xlabel
        set ylabel 'θ, radians' offset 0.5
        set yrange [below - 0.35*height : above + 0.35*height]
        unset key
        plot for [i=1:words(orders)] file('') using (column(3)):(of(e, word(orders, i) + 0, tame(column(5)))) with lines lw 2.2 dt i+1 lc rgb tone(i) , \
             file('') using (column(3)):(few(of(e, word(orders, 1) + 0, column(6)))) with points pt 6 ps 0.8 lc rgb '#222222'
        unset title
        set origin left, 0
        set format x '%g'
        set xlabel 'time t since the bottom'
        set ylabel 'log_{10} |error|, radians' offset 0.5
        set yrange [-20:8]
        set key at graph 0.97, 0.06 right bottom title 'order N'
        if (e > 1) { unset key }
        set label 1 'R' at reach, graph 0.03 left offset 0.5, 0
        set label 2 'T*' at tstar, graph 0.03 left offset 0.5, 0
        plot for [i=1:words(orders)] file('') using (column(3)):(of(e, word(orders, i) + 0, finite(column(8)))) with lines lw 2.2 dt i+1 lc rgb tone(i) title word(orders, i), \
             NaN with points pt 6 ps 0.8 lc rgb '#222222' title 'exact'
        unset label 1
        unset label 2
    }
    unset arrow 1
    unset arrow 2
    unset multiplot
    unset output
}
