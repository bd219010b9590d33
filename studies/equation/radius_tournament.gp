# radius_tournament of any equation: how far each test is from the proved radius, or from what all tests say of a longer
# list, over the order; a panel for each unknown, of the first combination of the parameters.
# Columns: <axes>,order,method,radius,uncertainty,difference,log10_difference,note,truth,unknown.
load scripts.'/equation/panels.gp'

k = place(main, 'order') - 1
all = cases(main, k)
methods = seen(main, k + 2, '1')
n = words(methods)
y = place(main, 'log10_difference')
curve(u, m) = both(both(in_case(word(all, 1)), of_unknown(main, u)), with_word(main, 'method', m))
tone(i) = i == 1 ? '#000000' : colour(i, larger(n, 7))
eval grid(drawn, 3)
foot = foot_for(n, 26)
bottom = span(main, 'log10_difference', '1', -1, -1)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Radius tests on '.called, '|R of the test/R − 1| over the order'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))).left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u.': against R '.(count_of(main, both(of_unknown(main, u), with_word(main, 'truth', 'verdict'))) ? 'of a longer list' : first_of(main, place(main, 'truth'), both(of_unknown(main, u), '1'))) offset 0, -0.5
        set xlabel 'order N'
        set ylabel 'log_{10} |R of the test/R − 1|'
        eval rising('x', span(main, 'order', '1', 0, -1), span(main, 'order', '1', 1, 1))
        set yrange [bottom - 1:1]
        plot for [i=1:n] rows(main, k + 1, y, curve(u, word(methods, i))) using 1:2 with linespoints lw i == 1 ? 2.6 : 1.2 dt 1 pt mark_of(i) ps 0.6 lc rgb tone(i)
        eval no_heading
    }
    eval key_strip
    plot for [i=1:n] NaN with linespoints lw i == 1 ? 2.6 : 1.2 pt mark_of(i) ps 0.7 lc rgb tone(i) title word(methods, i)
    unset multiplot
    unset output
    eval restart
}
