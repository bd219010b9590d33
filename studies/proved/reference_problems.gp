# reference_problems: the largest condition numbers of each problem over its unknowns and times, without the problems
# that have none; at the left edge those that are zero, absent or below 10^-3.
load scripts.'/style.gp'
figure = 'reference_problems'
table = data.'/reference_problems.csv'
title_text = 'Condition numbers of test problems'
below_text = 'digits that a relative change of the inputs costs'
eval seen('problems', table, 'problem', "has('condition_start')")
n = words(problems)
array of_start[n]
array of_parameters[n]
absent = -4
log_of(largest) = largest > 1.002e-3 ? log10(largest) : absent
highest = 0
do for [i=1:n] {
    eval extent('start', table, 'condition_start', "is('problem', word(problems, i))")
    eval extent('parameters', table, 'condition_parameters', "is('problem', word(problems, i))")
    of_start[i] = log_of(start_high); of_parameters[i] = log_of(parameters_high)
    highest = larger(highest, of_start[i])
}
width = 860; height = 90 + 22 * n
x = '(0)'; x_name = 'log_{10} of the largest condition number'
x_axis = "set xrange [-5:highest * 1.05 + 1]; set yrange [n + 0.7:0.3]; set xtics (\"none or\\n< 10^{−3}\" absent); do for [d=0:int(highest + 1):5] { set xtics add (sprintf('%d', d) d) }; unset ytics; set ytics scale 0 font ',12'; do for [i=1:n] { set ytics add (problem_name(word(problems, i)) i) }"
prepare = "set lmargin 22; set bmargin 5; set grid xtics; set arrow from -3, graph 0 to -3, graph 1 nohead lc rgb '#bbbbbb' lw 0.8"
layers = "for [i=1:n] '+' using (of_parameters[i]):(i) every ::0::0 with points pt 6 ps 0.9 lw 1.5 lc rgb shade[3], for [i=1:n] '+' using (of_start[i]):(i) every ::0::0 with points pt 7 ps 0.7 lc rgb shade[5]"
key = key_entry('points pt 7 ps 0.7 lc rgb shade[5]', "'with respect to the start'") \
    .', '.key_entry('points pt 6 ps 0.9 lw 1.5 lc rgb shade[3]', "'with respect to the parameters'")
entries = 2; letters = 30
load scripts.'/shared/panels.gp'
