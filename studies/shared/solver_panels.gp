# The studies of solvers.cpp: digits against evaluations of the right-hand side, one panel per problem, a point for each
# tolerance. Columns: problem,solver,version,method,tolerance,outcome,evaluations,error,digits,unknown,time,rounding,
# rigour.
load scripts.'/style.gp'
figure = stem
table = data.'/'.stem.'.csv'
title_text = stem eq 'solvers' ? 'Solvers of initial value problems in double' : 'Implicit solvers of stiff initial value problems in double'
below_text = 'a point for each tolerance; errors from proved values at '.(stem eq 'solvers' ? 'eight' : 'eleven').' times'
panel_by = 'problem'; most_panels = 60; most_across = 4
eval seen('panels', table, 'problem', '1')
n = words(panels)
width = n == 1 ? 860 : n == 2 ? 590 : n == 3 ? 400 : 300
height = n == 1 ? 520 : 290
# All methods, a colour for each library, and the index of the method within its library.
hue_by = 'solver method'
eval seen_together('hues', table, hue_by, "has('digits')")
eval seen('libraries', table, 'solver', "has('digits')")
library_of(h) = word(hues, h)[1:strstrt(word(hues, h), ',') - 1]
hue_name(v) = v[1:strstrt(v, ',') - 1].' '.v[strstrt(v, ',') + 1:*]
place(h) = sum [i=1:words(libraries)] (word(libraries, i) eq library_of(h) ? i : 0)
turn(h) = sum [i=1:h] (library_of(i) eq library_of(h) ? 1 : 0)
eval extent('count', table, 'evaluations', "has('digits') && at('evaluations') > 0")
x = 'evaluations'; x_name = 'evaluations'; x_axis = "set logscale x; set format x '10^{%T}'; set xrange [count_low / 1.5:count_high * 1.5]; if (p <= n - across) { unset xlabel }"
y_name = 'digits'; y_axis = 'set yrange [-1:16.5]; set ytics 0, 5'
# The cost of rounding the inputs to double, which stiff problems do not have.
prepare = "panel_title = problem_name(this); eval last_cell('rounding', table, 'rounding', of_panel('1')); if (number('0'.rounding) > 0) { set arrow from graph 0, first -log10(number(rounding)) to graph 1, first -log10(number(rounding)) nohead dt 3 lw 1.4 lc rgb soft }"
line = 'linespoints lw 1.3 dt turn(h) pt mark_of(turn(h)) ps 0.5 lc rgb shade[place(h)]'
layers = by_hue('digits', "at('evaluations') > 0", line)
key = 'for [h=1:words(hues)] '.key_entry(line, 'hue_name(word(hues, h))').', '.key_entry('lines dt 3 lw 1.4 lc rgb soft', "stem eq 'solvers' ? 'inputs in double' : ''")
entries = words(hues) + 1; letters = 22
load scripts.'/shared/panels.gp'
