# period_error: error of T* against the energy (left) and towards the separatrix (right).
# Columns: energy,order,method,error,tstar,gap,bound,bound_over_error,scalar,log10_error,log10_bound,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-400 nor 2 - 1e-22 passes through a double.
load scripts.'/style.gp'

file = data.'/period_error.csv'
orders = system(sprintf("cut -d, -f2 '%s' | tail -n +2 | sort -nu", file))
energies = int(system(sprintf("cut -d, -f1 '%s' | tail -n +2 | sort -u | wc -l", file)))
highest = real(system(sprintf("cut -d, -f1 '%s' | tail -n +2 | sort -g | tail -n 1", file)))
# Rows of the right panel, on each side of E = 2.
near(pattern) = int(system(sprintf("awk -F, 'NR > 1 && $12 < 0.2 && $10 > -8 {print $6}' '%s' | grep %s '^-' || true", file, pattern)))
rotations = near('-c')
librations = near('-vc')
closest = real(system(sprintf("cut -d, -f12 '%s' | tail -n +2 | sort -gr | tail -n 1", file)))
low = -40
style = energies > 20 ? 'lines' : 'linespoints pt 7 ps 0.5'     # a lone energy is a point
apart = energies > 20 ? 4 : 1                                   # energies between two crosses

# Columns x and y of the rows that an awk condition picks, behind a blank line a point out of sight: gnuplot warns of a
# file without points, and for [i=1:0] runs once.
rows(file, x, y, which) = sprintf("< awk -F, 'BEGIN {print \"x,y\"} NR > 1 && %s && $%d != \"\" && $%d !~ /inf/ {print $%d \",\" $%d} END {print \"\\n1e9,1e9\"}' '%s'", which, y, y, x, y, file)
of(n, method) = sprintf('$2 == %s && $3 == "%s"', n, method)
crossed(n, method) = of(n, method).sprintf(' && int((NR - 2)/%d) %% %d == 0', 2*words(orders), apart)
below = ' && $6 !~ /^-/'
above = ' && $6 ~ /^-/'
log10_limit(n) = log10(1.0/(8*n + 7))

do for [kind in terminals] {
    eval use_terminal(kind, target.'/period_error', 1180, 620)
    set multiplot
    set label 1 'Error of T* from the series of K (dashed) and from its resummation (solid)' at screen 0.5, 0.965 center font ',16'
    set tmargin 1
    set bmargin 4

    set origin 0, 0
    set size 0.56, 0.93
    set xlabel 'energy E'
    set ylabel 'log_{10} |T*_{series} - T*|' offset 0
    set lmargin 9
    set xrange [0:highest > 8 ? highest : 8]
    set yrange [low:3]
    unset key
    set arrow 1 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3
    set label 2 'E = 2' at 2, graph 0.975 offset 0.8, 0 textcolor rgb '#555555'
    plot for [i=1:words(orders)] rows(file, 1, 10, of(word(orders, i), 'series')) using 1:2 with @style lw 2 dt 2 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file, 1, 10, of(word(orders, i), 'resummed')) using 1:2 with @style lw 2 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file, 1, 11, crossed(word(orders, i), 'series')) using 1:2 with points pt 2 ps 0.6 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file, 1, 11, crossed(word(orders, i), 'resummed')) using 1:2 with points pt 2 ps 0.6 lc rgb shade[(i-1)%6+1]
    unset arrow 1
    unset label 1
    unset label 2

    set origin 0.56, 0
    set size 0.44, 0.93
    set xlabel 'log_{10} |2 - E|: towards the separatrix'
    unset ylabel
    set lmargin 6
    set xrange [0.2:closest < -5 ? closest - 0.8 : -5.8]
    set yrange [-8:2]
    set key at graph 0.97, 0.05 right bottom maxrows words(orders) > 6 ? 8 : 6 title 'order N'
    do for [i=1:words(orders)] {
        set arrow 10+i from graph 0.955, first log10_limit(word(orders, i) + 0) to graph 1, first log10_limit(word(orders, i) + 0) nohead lw 3.5 lc rgb shade[(i-1)%6+1]
    }
    set label 4 '1/(8N+7)' at graph 1, first (log10_limit(word(orders, 1) + 0)) right offset 0, 0.8 textcolor rgb '#555555'
    plot for [i=1:words(orders)] NaN with lines lw 2 lc rgb shade[(i-1)%6+1] title word(orders, i), \
         NaN with lines lw 2 lc rgb '#444444' title (librations ? 'E < 2' : ''), \
         NaN with points pt 6 ps 0.9 lc rgb '#444444' title (rotations ? 'E > 2' : ''), \
         NaN with points pt 2 ps 0.6 lc rgb '#444444' title 'proved bound', \
         for [i=1:words(orders)] rows(file, 12, 10, of(word(orders, i), 'series').below) using 1:2 with @style lw 2 dt 2 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] rows(file, 12, 10, of(word(orders, i), 'resummed').below) using 1:2 with @style lw 2 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] rows(file, 12, 11, crossed(word(orders, i), 'resummed')) using 1:2 with points pt 2 ps 0.6 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] rows(file, 12, 10, of(word(orders, i), 'series').above) using 1:2 with points pt 6 ps 0.9 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] rows(file, 12, 10, of(word(orders, i), 'resummed').above) using 1:2 with points pt 6 ps 0.9 lc rgb shade[(i-1)%6+1] notitle
    do for [i=1:words(orders)] { unset arrow 10+i }
    unset label 4
    unset multiplot
    unset output
}
