# coefficients of any equation: their size against n, one panel per unknown, one colour per combination of the
# parameters; the lines follow from the radius and exponent of the radius tests.
# Columns: <axes>,n,coefficient,log10_abs,log10_fitted,power,unknown; in _radius the results of the tests.
load scripts.'/shared/panels.gp'

eval axes_before('n')
place_x = place(main, 'n')
tone(c) = n == 1 ? shade[5] : colour(c, n)
curve(c, u) = both(in_case(word(all, c)), of_unknown(main, u))
eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 2, 20)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Coefficients of '.called, 'of the series about the start'.left_out)
    do for [p=1:drawn] {
        eval panel_of_unknown(p)
        set xlabel 'power n'
        set ylabel 'log_{10} |a_n|'
        eval rising('x', 0, span(main, 'n', of_unknown(main, u), 1, 1))
        eval rising('y', span(main, 'log10_abs', of_unknown(main, u), -1, -1), span(main, 'log10_abs', of_unknown(main, u), 1, 1))
        plot for [c=1:n] rows(main, place_x, place(main, 'log10_fitted'), curve(c, u)) using 1:2 with lines lw 1.2 lc rgb n == 1 ? '#888888' : tone(c), \
             for [c=1:n] rows(main, place_x, place(main, 'log10_abs'), curve(c, u)) using 1:2 with points pt mark_of(c) ps 0.6 lc rgb tone(c)
        eval no_heading
    }
    eval key_strip
    plot NaN with points pt mark_of(1) ps 0.8 lc rgb n == 1 ? tone(1) : soft title 'coefficient', \
         NaN with lines lw 1.2 lc rgb '#888888' title 'radius and exponent of the tests', \
         for [c=1:n] NaN with points pt mark_of(c) ps 0.8 lc rgb tone(c) title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    eval figure_done
}
