# solution_plot: quantities of solutions over the time or over each other. One solution: one panel, a curve for each
# quantity; a family: a panel for each quantity, below each other, a curve for each solution.
# `problem`, `x_name`, `quantities`, `solutions`, `marks_name`, `over_time` and `figure` are texts.
# Columns of points and marks: solution,quantity,x,y.
load scripts.'/style.gp'

points = data.'/points.csv'
marks = data.'/marks.csv'
several = words(quantities)
members = words(solutions)
single = members == 1
panels = single ? 1 : several
drawn = single ? several : members
# More than a few points of a curve are joined without marks.
sparse = count_of(points, '$1 == 1 && $2 == 1') <= 40
curve(i, q) = parts_at(points, 'v($3)', '($4 == "" || $4 ~ /inf|nan/ ? "nan" : $4)', '1 2', sprintf('%d,%d', i, q), '$3 != ""')
first_point(i, q) = points_by(sprintf("awk -F, 'BEGIN { print \"x,y\" } NR > 1 && $1 == %d && $2 == %d && $3 != \"\" && $4 != \"\" { print $3 \",\" $4; exit }' '%s'", i, q, points))
marked(q) = rows(marks, 3, 4, sprintf('$2 == %d', q))
any_marks = strlen(marks_name) > 0 && count_of(marks, '1') > 0
solution_of(p, c) = single ? 1 : c
quantity_of(p, c) = single ? c : p
tone(c) = drawn == 1 ? shade[5] : colour(c <= 6 ? (drawn <= 6 ? word('5 4 3 1 2 6', c) + 0 : c) : c, drawn)
dash(c) = drawn <= 6 ? c : 1
style = sparse ? 'linespoints pt mark_of(c) ps 0.7' : 'lines'
in_panel(p) = single ? '1' : sprintf('$2 == %d', p)
key_name(c) = single ? word(quantities, c) : word(solutions, c)
title_of = problem eq 'typed' ? 'Solution of the given equation' : problem_name(problem)

across = 1; down = panels
panel_w = 640; panel_h = panels > 2 ? 300 : 420
head = 50
with_key = drawn > 1 || any_marks || !(over_time + 0)
foot = with_key ? foot_for(shown_in_key(drawn) + any_marks + 1, 14) : 10
left_x = least(points, '3', '1', 0); right_x = greatest(points, '3', '1', 1)
do for [kind in terminals] {
    eval figure_of(kind, figure)
    eval heading(title_of, ' ')
    set lmargin 11; set rmargin 3; set tmargin 1; set bmargin 3.6
    unset key
    do for [p=1:panels] {
        eval panel(p)
        if (over_time + 0) { set xrange [left_x:right_x > left_x ? right_x : left_x + 1] } else { eval rising('x', left_x, right_x) }
        low = least(points, '4', in_panel(p), 0); high = greatest(points, '4', in_panel(p), 1)
        eval rising('y', low, high)
        set xlabel x_name
        set ylabel single ? (several == 1 ? word(quantities, 1) : '') : word(quantities, p)
        curves = "for [c=1:drawn] curve(solution_of(p, c), quantity_of(p, c)) using 1:2 with ".style." lw 2 dt dash(c) lc rgb tone(c)"
        starts = ", for [c=1:drawn] first_point(solution_of(p, c), quantity_of(p, c)) using 1:2 with points pt 6 ps 1.3 lw 1.6 lc rgb tone(c)"
        events = ", for [q=1:several] marked(q) using 1:2 with points pt 7 ps 1 lc rgb '#000000'"
        eval 'plot '.curves.(over_time + 0 ? '' : starts).(any_marks ? events : '')
        eval no_heading
    }
    if (with_key) {
        eval key_strip
        plot for [c=1:drawn] NaN with @style lw 2 dt dash(c) lc rgb tone(c) title drawn > 1 && in_key(c, drawn) ? key_name(c) : '', \
             NaN with points pt 6 ps 1.3 lw 1.6 lc rgb soft title over_time + 0 ? '' : 'start', \
             NaN with points pt 7 ps 1 lc rgb '#000000' title any_marks ? marks_name : ''
    }
    eval figure_done
}
