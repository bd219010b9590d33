# domb_sykes of any equation: ratios of the coefficients over 1/n, a panel for each unknown, a colour for each
# combination of the parameters; lines at plus and minus R^-p of the verdict of the longest list.
# Columns: <axes>,power,n,inverse_n,ratio,log10_abs_ratio,unknown; in _intercepts the answers of the tests.
load scripts.'/equation/panels.gp'

intercepts = table_of('_intercepts')
k = place(main, 'power') - 1
all = cases(main, k)
n = words(all)
tone(c) = n == 1 ? shade[5] : colour(c, n)
late = sprintf('$%d >= 4', k + 2)
curve(c, u) = both(late, both(in_case(word(all, c)), of_unknown(main, u)))
power(c, u) = number('0'.first_of(main, k + 1, both(in_case(word(all, c)), of_unknown(main, u))))
verdict(c, u) = ask(sprintf("awk -F, 'NR > 1 && %s && $%d != \"\" { r = $%d } END { print r }' '%s'", both(with_word(intercepts, 'method', 'verdict'), both(in_case(word(all, c)), of_unknown(intercepts, u))), place(intercepts, 'radius'), place(intercepts, 'radius'), intercepts))
eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 2, 20)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Domb-Sykes plot of '.called, 'ratios of coefficients about the start'.left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        eval single_panel
        set title u offset 0, -0.5
        set xlabel '1/n'
        array level[n]
        highest = 0
        do for [c=1:n] {
            v = verdict(c, u)
            level[c] = strlen(v) > 0 ? number(v) ** (-power(c, u)) : NaN
            highest = strlen(v) > 0 ? larger(highest, level[c]) : highest
        }
        set ylabel sprintf('a_n/a_{n−%d}', int(larger(1, power(1, u))))
        set xrange [0:1.05 * span(main, 'inverse_n', both(late, of_unknown(main, u)), 0.3, 1)]
        if (highest > 0) { set yrange [-2.5 * highest:2.5 * highest] } else { set yrange [*:*] }
        plot for [c=1:n] for [sign in '-1 1'] level[c] * (sign + 0) with lines lw 1.5 lc rgb n == 1 ? '#aaaaaa' : tone(c), \
             for [c=1:n] rows(main, place(main, 'inverse_n'), place(main, 'ratio'), curve(c, u)) using ($1 > 1 ? NaN : $1):($1 > 1 ? NaN : $2) with points pt mark_of(c) ps 0.6 lc rgb tone(c)
        eval no_heading
    }
    eval key_strip
    plot NaN with points pt mark_of(1) ps 0.8 lc rgb n == 1 ? tone(1) : soft title 'ratio', \
         NaN with lines lw 1.5 lc rgb '#888888' title '±R^{−p} of the verdict of all tests', \
         for [c=1:n] NaN with points pt mark_of(c) ps 0.8 lc rgb tone(c) title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    unset multiplot
    unset output
    eval restart
}
