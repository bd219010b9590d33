# error_norm: error norm against the energy (left) and towards the separatrix (right); and the floors of the scalars.
# Columns: energy,order,method,norm,time_of_maximum,scalar,rigour,gap,bound,log10_norm,log10_bound,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-400 nor 2 - 1e-22 passes through a double.
load scripts.'/style.gp'

file(suffix) = data.'/error_norm'.suffix.'.csv'
orders = system(sprintf("cut -d, -f2 '%s' | tail -n +2 | sort -nu", file('')))
low = -52

of(n, method, y) = (column(2) == n && strcol(3) eq method) ? y : NaN
# The Runge-Kutta march in double with the smallest step, where the table is there: "step log10_norm".
baseline = system(sprintf("test -f '%s' && grep ',double,' '%s' | tail -n 1 | cut -d, -f2,9 --output-delimiter=' ' || true", file('_baseline'), file('_baseline')))
# Columns x and y of the rows that an awk condition picks, behind a blank line a point out of sight: gnuplot warns of a
# file without points, and for [i=1:0] runs once.
rows(file, x, y, which) = sprintf("< awk -F, 'BEGIN {print \"x,y\"} NR > 1 && %s && $%d != \"\" && $%d !~ /inf/ {print $%d \",\" $%d} END {print \"\\n1e9,1e9\"}' '%s'", which, y, y, x, y, file)
of_libration(n, method) = sprintf('$2 == %s && $3 == "%s" && $8 !~ /^-/', n, method)

do for [kind in terminals] {
    eval use_terminal(kind, target.'/error_norm', 1180, 620)
    set multiplot
    set label 1 'Error of the pendulum series (dashed) and of its resummation (solid) on [0, T*]' at screen 0.5, 0.965 center font ',16'

    set origin 0, 0
    set size 0.58, 0.94
    set xlabel 'energy E'
    set ylabel 'log_{10} max |error|, radians' offset 0
    set lmargin 9
    set xrange [0:8]
    set yrange [low:2]
    set key at graph 0.97, 0.02 right bottom maxrows 2 title 'order N (thin dotted: proved bounds A, A2)'
    set arrow 1 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3
    set label 2 'E = 2' at 2.08, graph 0.975 textcolor rgb '#555555'
    if (words(baseline) == 2) {
        set arrow 3 from graph 0, first (word(baseline, 2) + 0) to graph 1, first (word(baseline, 2) + 0) nohead lc rgb '#666666' lw 1.5 dt 4
    }
    plot for [i=1:words(orders)] file('') using (column(1)):(of(word(orders, i) + 0, 'series', column(11))) with lines lw 1.1 dt 3 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] file('') using (column(1)):(of(word(orders, i) + 0, 'resummed', column(11))) with lines lw 1.1 dt 3 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] file('') using (column(1)):(of(word(orders, i) + 0, 'series', column(10))) with lines lw 2 dt 2 lc rgb shade[(i-1)%6+1] notitle, \
         for [i=1:words(orders)] file('') using (column(1)):(of(word(orders, i) + 0, 'resummed', column(10))) with lines lw 2 lc rgb shade[(i-1)%6+1] title word(orders, i)
    unset arrow 1
    unset label 1
    unset label 2

    set origin 0.58, 0
    set size 0.42, 0.94
    set xlabel 'log_{10}(2 - E): towards the separatrix, libration'
    unset ylabel
    set lmargin 6
    set xrange [0.4:-10.4]
    set yrange [-16:2]
    unset key
    if (words(baseline) == 2) {
        set label 3 sprintf('RK4 in double, dt = %g, at E = 2', word(baseline, 1) + 0) at graph 0.99, first (word(baseline, 2) + 0) right offset 0, -0.7 textcolor rgb '#444444'
    }
    plot for [i=1:words(orders)] rows(file(''), 12, 11, of_libration(word(orders, i), 'series')) using 1:2 with lines lw 1.1 dt 3 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file(''), 12, 11, of_libration(word(orders, i), 'resummed')) using 1:2 with lines lw 1.1 dt 3 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file(''), 12, 10, of_libration(word(orders, i), 'series')) using 1:2 with lines lw 2 dt 2 lc rgb shade[(i-1)%6+1], \
         for [i=1:words(orders)] rows(file(''), 12, 10, of_libration(word(orders, i), 'resummed')) using 1:2 with lines lw 2 lc rgb shade[(i-1)%6+1]
    unset arrow 3
    unset label 3
    unset multiplot
    unset output
}

# The floors, where the three tables of the fixed scalars are there.
scalars = 'double long-double quad'
floors = '-15.65 -18.96 -33.72'      # log10 of 2^-52, 2^-63, 2^-112
present = system(sprintf("test -f '%s' && test -f '%s' && test -f '%s' && echo yes || true", file('_double'), file('_long-double'), file('_quad')))
if (present eq 'yes') {
    do for [kind in terminals] {
        eval use_terminal(kind, target.'/error_norm_scalars', 1180, 520)
        set lmargin 8; set multiplot layout 1,3 title 'The same norms in each scalar (series dashed, resummation solid)' font ',16' offset 0,-0.3
        set xrange [0:8]
        set yrange [-38:2]
        do for [s=1:3] {
            set title word(scalars, s)
            set xlabel 'energy E'
            if (s == 1) { set ylabel 'log_{10} max |error|, radians' offset -0.5 } else { unset ylabel }
            if (s == 1) { set key at graph 0.98, 0.14 right bottom maxrows 5 title 'order N' } else { unset key }
            set arrow 1 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3
            set arrow 2 from 0, (word(floors, s) + 0) to 8, (word(floors, s) + 0) nohead lc rgb '#555555' lw 1
            set label 2 'epsilon' at 7.9, (word(floors, s) + 0) right offset 0,-0.7 textcolor rgb '#555555'
            plot for [i=1:words(orders)] file('_'.word(scalars, s)) using (column(1)):(of(word(orders, i) + 0, 'series', column(10))) with lines lw 1.6 dt 2 lc rgb shade[(i-1)%6+1] notitle, \
                 for [i=1:words(orders)] file('_'.word(scalars, s)) using (column(1)):(of(word(orders, i) + 0, 'resummed', column(10))) with lines lw 1.6 lc rgb shade[(i-1)%6+1] title word(orders, i)
            unset label 2
        }
        unset multiplot
        unset output
    }
}
