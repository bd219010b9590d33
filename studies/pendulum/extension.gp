# The figure of the four studies that share studies/extension.hpp: theta over the time in periods, the error below; each
# energy has a column of its own, three at most. The script that loads this one sets `name` and `heading`.
# Columns: energy,order,method,time,theta,omega,error,log10_error,periods,gap.
load scripts.'/style.gp'

file = data.'/'.name.'.csv'
numerical = data.'/'.name.'_numerical.csv'
exact = data.'/'.name.'_exact.csv'
energies = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq | awk '!seen[$0]++' | head -n 3", file))
how_many = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | sort -u | wc -l", file)) + 0
orders = system(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", file))
resummed = system(sprintf("sed -n 2p '%s' | cut -d, -f3", file)) eq 'resummed'
array dashes[6] = ['_', '-', '.', '_.', '-.', '_..']
dash(i) = resummed ? 1 : dashes[(i-1)%6+1]
array width[3] = [940, 1400, 1800]
n = words(energies)
key_rows = ceil((words(orders) + 2) / (n == 1 ? 5.0 : 3.0))

at(e, y) = strcol(1) eq e ? y : NaN
of(e, o, y) = strcol(1) eq e && strcol(2) eq o ? y : NaN
# T* in a period: 4 below E = 2, where the gap 2 - E has no minus sign
marks(e) = system(sprintf("awk -F, -v e='%s' '$1==e{print $10;exit}' '%s'", e, file))[1:1] eq '-' ? 2 : 4
smallest(e) = system(sprintf("awk -F, -v e='%s' 'NR>1&&$1==e&&$8!=\"-inf\"&&$8<m{m=$8}END{print (m<-20)?-20:m-0.5}' '%s'", e, file)) + 0
# theta in units of pi: its range in the exact curve, half a turn wider at most for what leaves it
edge(e, side) = system(sprintf("awk -F, -v e='%s' 'NR>1&&$1==e{x=$5/3.14159265358979;if(!n++||x>h)h=x;if(n==1||x<l)l=x}END{print %s}' '%s'", e, side, exact)) + 0

do for [kind in terminals] {
    eval use_terminal(kind, target.'/'.name, width[n], 720)
    set multiplot
    set label 1 heading.(how_many > n ? sprintf(' (%d of %d energies)', n, how_many) : '') at screen 0.5, 0.965 center font ',16'
    do for [c=1:n] {
        e = word(energies, c)
        set lmargin at screen (c-1.0)/n + 84.0/width[n]
        set rmargin at screen (c+0.0)/n - 22.0/width[n]
        bottom = edge(e, 'l')
        top = edge(e, 'h')
        unset arrow
        stats exact using (strcol(1) eq e ? column(9) : NaN) nooutput
        first = STATS_min
        last = STATS_max > first ? STATS_max : first + 1
        set xrange [first:last]
        do for [q=ceil(first*marks(e)):floor(last*marks(e))] {
            set arrow from q/(1.0*marks(e)), graph 0 to q/(1.0*marks(e)), graph 1 nohead back lw 0.8 lc rgb (q % marks(e) ? '#dddddd' : '#999999')
        }
        set tmargin at screen 0.875 - 0.027*key_rows
        set bmargin at screen 0.40
        set title 'E = '.e offset 0,-0.5 font ',13'
        set format x ''
        unset xlabel
        set ylabel 'angle θ / π' offset 0.5
        set format y '%g'
        set yrange [bottom - 0.12*(top-bottom) - 0.02 : top + 0.12*(top-bottom) + 0.02]
        if (c == 1) { set key at screen 0.5, 0.945 center top horizontal width 2 } else { unset key }
        plot exact using 9:(at(e, column(5)/pi)) with lines lw 1 lc rgb '#888888' title 'exact', \
             for [i=1:words(orders)] file using 9:(of(e, word(orders, i), column(5)/pi)) with lines lw 2.3 dt dash(i) lc rgb shade[(i-1)%6+1] title 'N = '.word(orders, i), \
             numerical using 9:(at(e, column(5)/pi)) with points pt 6 ps 0.8 lw 1.2 lc rgb '#000000' title 'numerical'
        set tmargin at screen 0.37
        set bmargin at screen 0.09
        unset title
        unset label 1
        unset key
        set format x '%g'
        set xlabel 'time t / T (grey lines: multiples of T*)'
        set ylabel 'log_{10} |error|, radians' offset 0.5
        set yrange [smallest(e):*]
        plot for [i=1:words(orders)] file using 9:(of(e, word(orders, i), column(8))) with lines lw 2.3 dt dash(i) lc rgb shade[(i-1)%6+1], \
             numerical using 9:(at(e, column(8))) with points pt 6 ps 0.6 lc rgb '#000000'
    }
    unset multiplot
    unset output
}
