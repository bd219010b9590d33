# precision_floor: norm against the order for each arithmetic, one panel an energy.
# Columns: energy,order,method,scalar,norm,exact_norm,norm_in_epsilon,epsilon,floor,log10_norm,log10_exact_norm,log10_epsilon,gap.
load scripts.'/style.gp'

file = data.'/precision_floor.csv'
energies = system(sprintf("cut -d, -f1 '%s' | tail -n +2 | awk '!seen[$0]++'", file))
scalars = system(sprintf("cut -d, -f4 '%s' | tail -n +2 | awk '!seen[$0]++'", file))
epsilons = system(sprintf("cut -d, -f4,12 '%s' | tail -n +2 | awk -F, '!seen[$1]++ {print $2}'", file))
longest = real(system(sprintf("cut -d, -f2 '%s' | tail -n +2 | sort -nr | sed -n 1p", file)))
lowest = real(system(sprintf("cut -d, -f12 '%s' | tail -n +2 | sort -gr | tail -n 1", file)))
single = int(system(sprintf("cut -d, -f2 '%s' | tail -n +2 | sort -u | wc -l", file))) == 1
panels = words(energies)
across = panels < 3 ? panels : 3
down = (panels + across)/across       # one cell more than panels, for the key
wide(x) = 360*x + (x == 1 ? 200 : 40)

# Columns x and y of the rows that an awk condition picks, behind a blank line a point out of sight: gnuplot warns of a
# file without points, and for [i=1:0] runs once.
rows(file, x, y, which) = sprintf("< awk -F, 'BEGIN {print \"x,y\"} NR > 1 && %s && $%d != \"\" && $%d !~ /inf/ {print $%d \",\" $%d} END {print \"\\n1e9,1e9\"}' '%s'", which, y, y, x, y, file)
of(e, s, method) = sprintf('$1 == "%s" && $4 == "%s" && $3 == "%s"', word(energies, e), word(scalars, s), method)
style = single ? 'points pt 7' : 'lines'

do for [kind in terminals] {
    eval use_terminal(kind, target.'/precision_floor', wide(across), 330*down + 40)
    set xtics nomirror out textcolor rgb '#222222'
    set ytics nomirror out textcolor rgb '#222222'
    set multiplot layout down, across title 'Series (dashed) and resummation (solid) in each arithmetic; dotted: without rounding' font ',15' offset 0, -0.3
    set xrange [0:longest > 0 ? longest*1.04 : 1]
    set yrange [lowest - 4:2]
    set lmargin 8
    do for [e=1:panels] {
        set title sprintf('E = %s', word(energies, e)) offset 0, -0.5
        set xlabel 'order N' offset 0, 0.3
        set ylabel 'log_{10} max |error|, radians' offset 0.7
        unset key
        do for [s=1:words(scalars)] {
            set arrow s from graph 0.95, first (word(epsilons, s) + 0) to graph 1, first (word(epsilons, s) + 0) nohead lw 4 lc rgb shade[(s+1)%6+1]
        }
        plot for [m in 'series resummed'] rows(file, 2, 11, of(e, 1, m)) using 1:2 with @style lw 1.3 dt 3 lc rgb '#666666', \
             for [s=1:words(scalars)] rows(file, 2, 10, of(e, s, 'series')) using 1:2 with @style lw 2 dt 2 lc rgb shade[(s+1)%6+1], \
             for [s=1:words(scalars)] rows(file, 2, 10, of(e, s, 'resummed')) using 1:2 with @style lw 2 lc rgb shade[(s+1)%6+1]
    }
    do for [s=1:words(scalars)] { unset arrow s }
    unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics
    set key at graph 0.75, 0.9 right top title 'arithmetic'
    plot for [s=1:words(scalars)] NaN with lines lw 2 lc rgb shade[(s+1)%6+1] title word(scalars, s), \
         NaN with lines lw 1.3 dt 3 lc rgb '#666666' title 'without rounding', \
         NaN with lines lw 4 lc rgb '#666666' title 'epsilon'
    set border 3 lc rgb '#444444'
    unset multiplot
    unset output
}
