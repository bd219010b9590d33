# reference_problems: the largest condition numbers of each problem over its unknowns and times, without the problems
# that have none; at the left edge those that are zero, absent or below 10^-3. Columns: problem,time,unknown,value,
# digits,rigour,condition_start,condition_parameters,condition_time,changed_digit.
load scripts.'/style.gp'

main = data.'/reference_problems.csv'
problems = seen(main, 1, '$7 != ""')
n = words(problems)
log_of(p, column) = larger(log10(larger(greatest(main, column, sprintf('$1 == "%s" && $%s !~ /inf/', p, column), 1e-3), 1e-3)), -3)
absent = -4
at_edge(x) = x > -2.999 ? x : absent

eval grid(1, 1)
panel_w = 860
panel_h = 90 + 22 * n
foot = foot_for(2, 30)
highest = 0
do for [i=1:n] { highest = larger(highest, log_of(word(problems, i), '7')) }
do for [kind in terminals] {
    eval figure_of(kind, 'reference_problems')
    eval heading('Condition numbers of test problems', 'digits that a relative change of the inputs costs')
    set lmargin 22; set rmargin 3; set tmargin 2; set bmargin 5
    eval panel(1)
    set xrange [-5:highest * 1.05 + 1]
    set yrange [n + 0.7:0.3]
    unset ytics
    set ytics scale 0 font ',12'
    set xtics ("none or\n< 10^{−3}" absent)
    do for [d=0:int(highest + 1):5] { set xtics add (sprintf('%d', d) d) }
    set grid xtics
    set arrow 1 from -3, graph 0 to -3, graph 1 nohead lc rgb '#bbbbbb' lw 0.8
    do for [i=1:n] { set ytics add (problem_name(word(problems, i)) i) }
    set xlabel 'log_{10} of the largest condition number' offset 0, -0.6
    unset key
    plot for [i=1:n] '+' using (at_edge(log_of(word(problems, i), '8'))):(i) every ::0::0 with points pt 6 ps 0.9 lw 1.5 lc rgb shade[3], \
         for [i=1:n] '+' using (at_edge(log_of(word(problems, i), '7'))):(i) every ::0::0 with points pt 7 ps 0.7 lc rgb shade[5]
    unset arrow
    eval no_heading
    eval key_strip
    plot NaN with points pt 7 ps 0.7 lc rgb shade[5] title 'with respect to the start', \
         NaN with points pt 6 ps 0.9 lw 1.5 lc rgb shade[3] title 'with respect to the parameters'
    eval figure_done
}
