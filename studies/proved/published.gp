# published: the distance of printed values from the proved ones. Columns:
# value_of,problem,quantity,printed,value,units, verdict,rigour,source.
load scripts.'/style.gp'

main = data.'/published.csv'
set datafile separator ','
stats main using 6 nooutput
n = int(STATS_records)
highest = larger(log10(larger(STATS_max, 1)), 1)

eval grid(1, 1)
panel_w = 860
panel_h = 90 + 22 * n
foot = foot_for(2, 30)
do for [kind in terminals] {
    eval figure_of(kind, 'published')
    eval heading('Published reference values', 'distance from the proved value in units of the last printed digit')
    set lmargin 42; set rmargin 3; set tmargin 2; set bmargin 3.6
    eval panel(1)
    set xrange [-3:highest * 1.1 + 1]
    set yrange [n - 0.5:-0.5]
    set xlabel 'log_{10} of the distance in units'
    set xtics autofreq
    set ytics scale 0 noenhanced
    set arrow 1 from 0, graph 0 to 0, graph 1 nohead dt 3 lw 1.2 lc rgb soft
    unset key
    plot main using (log10(larger($6, 1e-3))):0:ytic(stringcolumn(2).': '.stringcolumn(3)) with points pt 7 ps 0.8 lc rgb shade[5]
    unset arrow 1
    eval no_heading
    eval key_strip
    plot NaN with points pt 7 ps 0.8 lc rgb shade[5] title 'printed value', \
         NaN with lines dt 3 lw 1.2 lc rgb soft title 'one unit'
    unset multiplot
}
