# expansion_point: radius of convergence and rate over the energy, and the rate over the expansion point.
# Columns: energy,point,radius,tstar,covers,rate,measured_rate,height,scalar,gap.
load scripts.'/style.gp'

file = data.'/expansion_point.csv'
points = system(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", file))
energies = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq", file))
# Energies and points may be fractions.
fraction(p) = strstrt(p, '/') ? real(p[1:strstrt(p, '/') - 1]) / real(p[strstrt(p, '/') + 1:*]) : real(p)
of(p, y) = strcol(2) eq p ? y : NaN
name(p) = p eq '0' ? '0 (top)' : p eq '1' ? '1 (bottom)' : p
first = fraction(word(energies, 1))
last = fraction(word(energies, words(energies)))
measured = system(sprintf("awk -F, 'NR > 1 && $7 != \"\"' '%s' | wc -l", file)) + 0
array mark[6] = [4, 8, 6, 12, 10, 2]

do for [kind in terminals] {
    eval use_terminal(kind, target.'/expansion_point', 1180, 560)
    set multiplot
    set label 1 'One expansion for the whole way from the top to the bottom: its radius and its rate' at screen 0.5, 0.965 center font ',16'
    set xlabel 'energy E'
    set xrange [first == last ? first - 0.5 : first : first == last ? last + 0.5 : last]
    e2 = first < 2 && last > 2
    set arrow 2 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1
    if (e2) { set arrow 1 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3 }
    if (e2) { set label 2 'E = 2' at 2, graph 0.03 offset 0.6, 0 textcolor rgb '#555555' }

    set origin 0.01, 0
    set size 0.49, 0.94
    set lmargin 8
    set ylabel 'radius of convergence R/T*'
    set yrange [0:2.6]
    set key top right opaque title 'expanded about this fraction of T*' samplen 3
    set label 3 'R = T*' at graph 0.98, first 1 right offset 0, -0.7 textcolor rgb '#555555'
    plot for [i=1:words(points)] file using (fraction(strcol(1))):(of(word(points, i), column(3) / column(4))) with linespoints lw 2 dt i pt mark[(i-1)%6+1] ps 0.5 lc rgb shade[(i-1)%6+1] title name(word(points, i))
    unset label 1
    unset label 3

    set origin 0.5, 0
    set ylabel 'factor of the error on [0, T*] a power'
    set yrange [0:1.8]
    unset key
    set label 3 'diverges on a part of the way' at graph 0.98, first 1.1 right offset 0, 0.6 textcolor rgb '#555555'
    set label 4 'lines: max(x, 1-x) T*/R'.(measured ? ', marks: measured' : '') at graph 0.98, graph 0.97 right textcolor rgb '#555555'
    plot for [i=1:words(points)] file using (fraction(strcol(1))):(of(word(points, i), column(6))) with lines lw 2 dt i lc rgb shade[(i-1)%6+1], \
         for [i=1:words(points)] file using (fraction(strcol(1))):(of(word(points, i), column(measured ? 7 : 6))) with points pt mark[(i-1)%6+1] ps measured ? 0.9 : 0.4 lw 1.3 lc rgb shade[(i-1)%6+1]
    unset label 3
    unset label 4
    unset multiplot
    unset output
}

# Over the expansion point, for at most six of the energies.
reset
load scripts.'/style.gp'
count = words(energies)
shown = count < 6 ? count : 6
pick(j) = word(energies, shown == 1 ? 1 : 1 + int((j - 1) * (count - 1) / (shown - 1.0) + 0.5))
shorter(e) = strlen(e) > 14 ? e[1:14].'...' : e
of(e, y) = strcol(1) eq e ? y : NaN
aspect(e) = real(system(sprintf("awk -F, '$1 == \"%s\" { printf \"%%.9g\", $8 / $4; exit }' '%s'", e, file)))
rate(x, k) = (x > 0.5 ? x : 1 - x) / sqrt((1 - x)**2 + k**2)
array k[6]
do for [j=1:shown] { k[j] = aspect(pick(j)) }
do for [kind in terminals] {
    eval use_terminal(kind, target.'/expansion_point_rate', 860, 560)
    set title 'The expansion point that covers [0, T*] at the best rate is T*/2' font ',16'
    set xlabel 'expansion point, fraction x of T* (0 the top, 1 the bottom)'
    set ylabel 'factor of the error on [0, T*] a power'
    set xrange [0:1]
    set yrange [0:2]
    set samples 401
    set key top left title 'energy E' samplen 3
    set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888'
    set arrow 2 from 0.5, graph 0 to 0.5, graph 1 nohead lc rgb '#888888' dt 3
    set label 1 'above: diverges at an end' at 0.02, 1 offset 0, 0.6 textcolor rgb '#555555'
    set label 2 'lines: max(x, 1-x) T*/R'.(measured ? ', marks: measured' : '') at graph 0.02, graph 0.03 textcolor rgb '#555555'
    plot for [j=1:shown] rate(x, k[j]) with lines lw 2 dt j lc rgb shade[j] title shorter(pick(j)), \
         for [j=1:shown] file using (fraction(strcol(2))):(of(pick(j), column(measured ? 7 : 6))) with points pt mark[j] ps 1.2 lw 1.5 lc rgb shade[j] notitle
    unset output
}
