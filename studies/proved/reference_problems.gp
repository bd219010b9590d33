# reference_problems: the largest condition numbers of each problem over its unknowns and times. Columns: problem,time,
# unknown,value,digits,rigour,condition_start,condition_parameters,condition_time,changed_digit.
load scripts.'/style.gp'

main = data.'/reference_problems.csv'
problems = seen(main, 1, '1')
n = words(problems)
name_of(p) = ask("echo '".p."' | tr '_' ' '")
log_of(p, column) = larger(log10(larger(greatest(main, column, sprintf('$1 == "%s" && $%s !~ /inf/', p, column), 1e-3), 1e-3)), -3)

eval grid(1, 1)
panel_w = 860
panel_h = 60 + 15 * n
foot = foot_for(2, 30)
highest = 0
do for [i=1:n] { highest = larger(highest, log_of(word(problems, i), '7')) }
do for [kind in terminals] {
    eval figure_of(kind, 'reference_problems')
    eval heading('Condition numbers of test problems', 'digits that a relative change of the inputs costs')
    set lmargin 22; set rmargin 3; set tmargin 2; set bmargin 3.6
    eval panel(1)
    set xrange [-3.2:highest * 1.05 + 1]
    set yrange [n + 0.7:0.3]
    unset ytics
    set ytics scale 0
    set xtics autofreq
    set grid xtics
    do for [i=1:n] { set ytics add (name_of(word(problems, i)) i) }
    set xlabel 'log_{10} of the largest condition number'
    unset key
    plot for [i=1:n] '+' using (log_of(word(problems, i), '8')):(i) every ::0::0 with points pt 6 ps 0.9 lw 1.5 lc rgb shade[3], \
         for [i=1:n] '+' using (log_of(word(problems, i), '7')):(i) every ::0::0 with points pt 7 ps 0.7 lc rgb shade[5]
    eval no_heading
    eval key_strip
    plot NaN with points pt 7 ps 0.7 lc rgb shade[5] title 'with respect to the start', \
         NaN with points pt 6 ps 0.9 lw 1.5 lc rgb shade[3] title 'with respect to the parameters'
    unset multiplot
}
