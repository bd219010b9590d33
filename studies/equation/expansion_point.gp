# expansion_point of any equation: the radius about each time, how far from real times the nearest singularity is, and
# the rate on the whole interval, a row of three panels for each unknown, a curve for each combination of the parameters
# (of the largest order).
# Columns: <axes>,time,order,radius,uncertainty,position_re,position_im,reach,rate,note,unknown.
load scripts.'/equation/panels.gp'

k = place(main, 'time') - 1
all = cases(main, k)
n = words(all)
last = sprintf('%.0f', span(main, 'order', '1', 0, 1))
tone(c) = n == 1 ? shade[5] : colour(c, n)
curve(c, u) = both(both(in_case(word(all, c)), of_unknown(main, u)), sprintf('$%d == %s', k + 2, last))
across = 3; down = drawn
panel_w = 400; panel_h = 360
foot = n > 1 ? foot_for(shown_in_key(n), 20) : 20
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Where to expand '.called, 'from '.last.' powers about each time'.left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval single_panel
        set xlabel 'expansion point / unit of the variable'
        eval rising('x', span(main, 'time', '1', 0, -1), span(main, 'time', '1', 1, 1))
        eval panel(3 * p - 2)
        set title u.': radius' offset 0, -0.5
        set ylabel 'radius R / unit of the variable'
        set yrange [0:larger(1e-30, 1.1 * span(main, 'radius', of_unknown(main, u), 1, 1))]
        plot for [c=1:n] rows(main, k + 1, place(main, 'radius'), curve(c, u)) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
        eval no_heading
        eval panel(3 * p - 1)
        set title u.': nearest singularity' offset 0, -0.5
        set ylabel '|Im t| / unit of the variable'
        set yrange [0:larger(1e-30, 1.1 * larger(span(main, 'position_im', of_unknown(main, u), 0, 1), -span(main, 'position_im', of_unknown(main, u), 0, -1)))]
        plot for [c=1:n] rows(main, k + 1, place(main, 'position_im'), curve(c, u)) using 1:(abs($2)) with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
        eval panel(3 * p)
        set title u.': rate on the whole interval' offset 0, -0.5
        set ylabel 'reach/R'
        set yrange [0:larger(1.1, 1.1 * span(main, 'rate', of_unknown(main, u), 1, 1))]
        set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1
        plot for [c=1:n] rows(main, k + 1, place(main, 'rate'), curve(c, u)) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
        unset arrow
    }
    if (n > 1) {
        eval key_strip
        plot for [c=1:n] NaN with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c) title in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    }
    unset multiplot
    unset output
    eval restart
}
