# period_effect: theta over the time, extended with the T* of each rule, and the error below; each energy has a column of
# its own, three at most. Where there are several orders N, the first is drawn.
# Columns: energy,period_by,order,period,period_error,time,theta,error,log10_error,periods,gap,method.
load scripts.'/style.gp'

file = data.'/period_effect.csv'
numerical = data.'/period_effect_numerical.csv'
energies = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | awk '!seen[$0]++' | head -n 3", file))
how_many = system(sprintf("tail -n +2 '%s' | cut -d, -f1 | sort -u | wc -l", file)) + 0
rules = system(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", file))
order = system(sprintf("sed -n 2p '%s' | cut -d, -f3", file))
n = words(energies)
key_rows = ceil((words(rules) + 1) / 2.0)
array width[3] = [980, 1360, 1800]

# Long dashes for (Kold); for (Knew) the last rule solid and those before it dashed; the exact T* a thin grey line.
last_resummed = 0
do for [i=1:words(rules)] { if (word(rules, i)[1:1] eq 'r') { last_resummed = i } }
array dashes[4] = ['-', '.', '-.', '-..']
dash(i) = word(rules, i)[1:1] eq 's' ? '_' : (word(rules, i)[1:1] eq 'a' || i == last_resummed) ? 1 : dashes[(i-1)%4+1]
colour(i) = word(rules, i) eq 'agm' ? '#888888' : shade[(7-i)%6+1]
weight(i) = word(rules, i) eq 'agm' ? 1.2 : 2.3
of(e, rule, y) = strcol(1) eq e && strcol(2) eq rule && strcol(3) eq order ? y : NaN
at(e, y) = strcol(1) eq e ? y : NaN
in_periods(e) = system(sprintf("awk -F, -v e='%s' 'NR>1&&$1==e{if(!n++||$10>h)h=$10;if(n==1||$10<l)l=$10}END{if(h==l)h+=1;print \"first=\" l \";last=\" h}' '%s'", e, file))
name_of(i) = word(rules, i) eq 'agm' ? 'exact T*' : 'T* by '.word(rules, i)

do for [kind in terminals] {
    eval use_terminal(kind, target.'/period_effect', width[n], 720)
    set multiplot
    set label 1 'The resummation (N = '.order.') extended with an inexact T*'.(how_many > n ? sprintf(' (%d of %d energies)', n, how_many) : '') at screen 0.5, 0.965 center font ',16'
    do for [c=1:n] {
        e = word(energies, c)
        set lmargin at screen (c-1.0)/n + 84.0/width[n]
        set rmargin at screen (c+0.0)/n - 22.0/width[n]
        eval in_periods(e)
        set xrange [first:last]
        set tmargin at screen 0.905 - 0.029*key_rows
        set bmargin at screen 0.40
        set title 'E = '.e offset 0,-0.5 font ',13'
        set format x ''
        unset xlabel
        set ylabel 'angle θ / π' offset 0.5
        set format y '%g'
        set yrange [*:*]
        set offsets 0, 0, 0.1, 0.1
        if (c == 1) { set key at screen 0.5, 0.945 center top horizontal width 1 } else { unset key }
        plot for [i=1:words(rules)] file using 10:(of(e, word(rules, i), column(7)/pi)) with lines lw weight(i) dt dash(i) lc rgb colour(i) title name_of(i), \
             numerical using 10:(at(e, column(7)/pi)) with points pt 7 ps 0.6 lc rgb '#000000' title 'numerical'
        set tmargin at screen 0.37
        set bmargin at screen 0.09
        unset title
        unset label 1
        unset key
        unset offsets
        set format x '%g'
        set xlabel 'time t / T (exact period)'
        set ylabel 'log_{10} |error|, radians' offset 0.5
        set yrange [-12:2]
        plot for [i=1:words(rules)] file using 10:(of(e, word(rules, i), column(9))) with lines lw weight(i) dt dash(i) lc rgb colour(i), \
             numerical using 10:(at(e, column(9))) with points pt 7 ps 0.5 lc rgb '#000000'
    }
    unset multiplot
    unset output
}
