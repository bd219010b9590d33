# root_test of any equation: the roots of the coefficients over 1/n, a panel for each unknown, a colour for each
# combination of the parameters; lines at the verdict of the longest list.
# Columns: <axes>,n,inverse_n,root,corrected,unknown; in _estimates the answers of the tests.
load scripts.'/equation/panels.gp'

estimates = table_of('_estimates')
k = place(main, 'n') - 1
all = cases(main, k)
n = words(all)
place_x = place(main, 'inverse_n')
tone(c) = n == 1 ? shade[5] : colour(c, n)
late = sprintf('$%d >= 4', k + 1)
curve(c, u) = both(late, both(in_case(word(all, c)), of_unknown(main, u)))
verdict(c, u) = ask(sprintf("awk -F, 'NR > 1 && %s && $%d != \"\" { r = $%d } END { print r }' '%s'", both(with_word(estimates, 'method', 'verdict'), both(in_case(word(all, c)), of_unknown(estimates, u))), place(estimates, 'radius'), place(estimates, 'radius'), estimates))
eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 3, 20)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Root test of '.called, 'roots of the coefficients about the start'.left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u offset 0, -0.5
        set xlabel '1/n'
        set ylabel 'radius / unit of the variable'
        set xrange [0:1.05 * span(main, 'inverse_n', late, 0.3, 1)]
        set yrange [*:*]
        array level[n]
        do for [c=1:n] { v = verdict(c, u); level[c] = strlen(v) > 0 ? number(v) : NaN }
        plot for [c=1:n] level[c] with lines lw 1.5 lc rgb n == 1 ? '#888888' : tone(c), \
             for [c=1:n] rows(main, place_x, place(main, 'root'), curve(c, u)) using ($1 > 1 ? NaN : $1):($1 > 1 ? NaN : $2) with points pt 6 ps 0.6 lc rgb tone(c), \
             for [c=1:n] rows(main, place_x, place(main, 'corrected'), curve(c, u)) using ($1 > 1 ? NaN : $1):($1 > 1 ? NaN : $2) with points pt 2 ps 0.5 lc rgb tone(c)
        eval no_heading
    }
    eval key_strip
    plot NaN with points pt 6 ps 0.8 lc rgb soft title '|a_n|^{−1/n}', \
         NaN with points pt 2 ps 0.8 lc rgb soft title '|n a_n|^{−1/n}', \
         NaN with lines lw 1.5 lc rgb '#888888' title 'verdict of all tests', \
         for [c=1:n] NaN with lines lw 2.4 lc rgb tone(c) title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    unset multiplot
    unset output
    eval restart
}
