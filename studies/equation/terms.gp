# terms of any equation: the least order over the number of digits, a panel for each unknown, a colour for each
# combination of the parameters; thin what the rate of the series predicts.
# Columns: <axes>,digits,method,order,predicted,norm,norm_before,log10_norm,unknown; in _radius reach, radius, rate, ...
load scripts.'/equation/panels.gp'

k = place(main, 'digits') - 1
all = cases(main, k)
n = words(all)
tone(c, m) = n == 1 ? shade[m eq 'series' ? 4 : 3] : colour(c, n)
curve(c, u, m) = both(both(in_case(word(all, c)), of_unknown(main, u)), with_word(main, 'method', m))
eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 3, 18)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Terms for D digits of '.called, 'the least order whose largest error at the times is at most 10^{−D}'.left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u offset 0, -0.5
        set xlabel 'digits D'
        set ylabel 'least order N'
        eval rising('x', span(main, 'digits', '1', 0, -1), span(main, 'digits', '1', 1, 1))
        set yrange [0:larger(1, 1.08 * span(main, 'order', of_unknown(main, u), 1, 1))]
        plot for [c=1:n] rows(main, k + 1, place(main, 'predicted'), curve(c, u, 'series')) using 1:2 with lines lw 1 dt 3 lc rgb tone(c, 'series'), \
             for [c=1:n] for [m in 'series endpoint'] rows(main, k + 1, place(main, 'order'), curve(c, u, m)) using 1:2 with linespoints lw 1.8 dt m eq 'series' ? 2 : 1 pt mark[m eq 'series' ? 1 : 3] ps 0.7 lc rgb tone(c, m)
        eval no_heading
    }
    eval key_strip
    plot NaN with linespoints lw 1.8 dt 2 pt mark[1] ps 0.7 lc rgb n == 1 ? tone(1, 'series') : soft title 'series', \
         NaN with linespoints lw 1.8 dt 1 pt mark[3] ps 0.7 lc rgb n == 1 ? tone(1, 'endpoint') : soft title 'endpoint', \
         NaN with lines lw 1 dt 3 lc rgb soft title 'rate of the series', \
         for [c=1:n] NaN with lines lw 2.4 lc rgb tone(c, 'series') title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    unset multiplot
    unset output
    eval restart
}
