# solution_plot: quantities of solutions over the time or over each other. One solution: one panel, a curve for each
# quantity; a family: a panel for each quantity, below each other, a curve for each solution.
# `problem`, `x_name`, `quantities`, `solutions`, `marks_name`, `over_time` and `figure` are texts.
# Columns of points and marks: solution,quantity,x,y.
x_text = x_name
load scripts.'/style.gp'
table = data.'/points.csv'
events = data.'/marks.csv'
title_text = problem eq 'typed' ? 'Solution of the given equation' : heading_of(problem)
single = words(solutions) == 1
panel_by = single ? '' : 'quantity'; most_panels = 60; most_across = 1
hue_by = single ? 'quantity' : 'solution'
hue_name(h) = word(single ? quantities : solutions, int(h))
n = words(single ? quantities : solutions)
do for [h=1:n] { hues = hues.' '.h }
if (!single) { do for [p=1:words(quantities)] { panels = panels.' '.p } }
tone(h) = n == 1 ? shade[5] : n <= 6 ? shade[word('5 4 3 1 2 6', h) + 0] : colour(h, n)
dash(h) = n <= 6 ? h : 1
width = 640; height = words(panels) > 2 ? 300 : 420
x = 'x'; x_name = x_text
x_axis = over_time + 0 ? 'set xrange [x_low:x_high > x_low ? x_high : x_low + 1]' : "eval rising('x', x_low, x_high)"
y_axis = "eval extent('y', table, 'y', of_panel('1')); eval rising('y', y_low, y_high)"
prepare = "panel_title = ''; y_name = single ? (n == 1 ? hue_name(1) : '') : word(quantities, int(this)); set lmargin 11; set tmargin 1"
# More than a few points of a curve are joined without marks.
eval count_of('count', table, "is('solution', '1') && is('quantity', '1')")
line = (count <= 40 ? 'linespoints pt mark_of(h) ps 0.7' : 'lines').' lw 2 dt dash(h) lc rgb tone(h)'
layers = 'for [h=1:n] '.broken_rows(table, x, 'y', of_hue("has('x')")).' with '.line.' notitle'
key = n > 1 ? key_of_hues(line) : ''
entries = shown_in_key(n)
# Over each other, a mark at the first point of each curve.
curve_here = ''
starts(curve, row) = (row == 0 || curve ne curve_here ? (curve_here = curve, start_row = row) : 0, row == start_row)
if (!(over_time + 0)) {
    layers = layers.', '.by_hue('y', "starts(strcol('solution').','.strcol('quantity'), column(0))", 'points pt 6 ps 1.3 lw 1.6 lc rgb tone(h)')
    key = key.(key eq '' ? '' : ', ').key_entry('points pt 6 ps 1.3 lw 1.6 lc rgb soft', "'start'")
    entries = entries + 1
}
marked = 0
if (strlen(marks_name)) { eval count_of('marked', events, '1') }
if (marked) {
    layers = layers.', '.rows(events, x, 'y', of_panel('1'))." with points pt 7 ps 1 lc rgb '#000000'"
    key = key.(key eq '' ? '' : ', ').key_entry("points pt 7 ps 1 lc rgb '#000000'", 'marks_name')
    entries = entries + 1
}
load scripts.'/shared/panels.gp'
