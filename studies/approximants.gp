# approximants: error of asymptotic approximants against the order, one panel per problem; last the digits that the
# Vandermonde system loses. Columns: problem,order,method,norm,time_of_maximum,log10_norm,rigour,predicted,
# log10_predicted,unknown; of _digits: problem,terms,log10_condition,log10_amplitudes,log10_vandermonde,log10_decay,
# lost_digits.
#
# approximants of any equation with a known asymptotic behaviour: left the error against the order, one curve per
# combination of the parameters; right the least error of all orders against the parameter with the most values, one
# curve per method. Columns:
# <axes>,order,method,norm,time_of_maximum,log10_norm,rigour,predicted,log10_predicted,unknown.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    eval axes_before('order')
    N = place(main, 'order')
    y = place(main, 'log10_norm')
    q = place(main, 'log10_predicted')
    u = drawn_unknown(1)
    values(i) = words(seen(main, i, '1'))
    along = 1
    do for [i=2:k] { if (values(i) > values(along)) { along = i } }
    methods = 'series pade asymptotic'
    name_of(m) = m eq 'pade' ? 'Padé' : m eq 'asymptotic' ? 'asymptotic approximant' : 'series'
    number_of(m) = m eq 'series' ? 1 : m eq 'pade' ? 2 : 3
    tone_of(m) = '#444444'
    curve(c, m) = both(in_case(word(all, c)), with_word(main, 'method', m))
    best(m) = points_by(sprintf("awk -F, 'BEGIN { print \"x,y\" } NR > 1 && %s && $%d != \"\" && $%d !~ /inf|nan/ { v = $%d + 0; if (!($%d in s) || v < s[$%d]) s[$%d] = v; if (!n[$%d]++) o[++c] = $%d } END { for (i = 1; i <= c; ++i) print o[i] \",\" s[o[i]] }' '%s' | sort -t, -g", with_word(main, 'method', m), y, y, y, along, along, along, along, along, main))

    eval grid(2, 2)
    panel_w = 520
    panel_h = 400
    foot = foot_for(shown_in_key(n) + 4, 28)
    of_approximants = with_word(main, 'method', 'asymptotic')
    bottom = least(main, sprintf('%d', y), of_approximants, -10)
    top = greatest(main, sprintf('%d', y), of_approximants, 0)
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Asymptotic approximants of '.called, 'largest error of '.u.' up to where the solution has its asymptotic form')
        set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6
        unset key
        eval panel(1)
        set title 'against the order' offset 0, -0.5
        eval rising('x', least(main, sprintf('%d', N), '1', 0), greatest(main, sprintf('%d', N), '1', 1))
        set yrange [bottom - 1:top + 1]
        set xlabel 'order N'
        set ylabel 'log_{10} (max |error| / '.unit_name(u).')'
        plot for [c=1:n] rows(main, N, q, curve(c, 'asymptotic')) using 1:2 with lines lw 1 dt 3 lc rgb colour(c, n), \
             for [c=1:n] rows(main, N, y, curve(c, 'asymptotic')) using 1:2 with linespoints lw 1.8 pt mark_of(c) ps 0.6 lc rgb colour(c, n)
        eval no_heading
        if (k > 0 && values(along) > 1) {
            eval panel(2)
            set title 'the least of all orders' offset 0, -0.5
            a = span(main, header(main, along), '1', 0, -1); b = span(main, header(main, along), '1', 1, 1)
            set xrange [a - 0.03 * (b - a):b + 0.03 * (b - a)]
            set yrange [bottom - 1:*]
            set xlabel header(main, along)
            unset ylabel
            plot for [m in methods] best(m) using 1:2 with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb tone_of(m)
        }
        eval key_strip
        plot for [m in methods] NaN with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb tone_of(m) title name_of(m), \
             NaN with lines lw 1 dt 3 lc rgb soft title 'predicted by its form, up to a factor', \
             for [c=1:n] NaN with linespoints lw 1.8 pt mark_of(c) ps 0.6 lc rgb colour(c, n) title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

main = data.'/approximants.csv'
losses = data.'/approximants_digits.csv'
problems = seen(main, 1, '1')
with_losses = seen(losses, 1, '1')
n = words(problems)
has_losses = words(with_losses) > 0
highest = greatest(main, '2', '1', 10)
of(p, m) = sprintf('$1 == "%s" && $3 == "%s"', p, m)
name_of(p) = problem_name(p)

eval grid(n + has_losses, 3)
panel_w = across == 1 ? 860 : across == 2 ? 590 : 393
panel_h = 330
foot = foot_for(4, 28)
do for [kind in terminals] {
    eval figure_of(kind, 'approximants')
    eval heading('Asymptotic approximants', 'largest error up to where the solution has its asymptotic form')
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    do for [p=1:n] {
        eval panel(p)
        which = word(problems, p)
        in_panel = sprintf('$1 == "%s"', which)
        low = larger(least(main, '6', of(which, 'asymptotic'), -16), -40)
        high = smaller(greatest(main, '6', in_panel, 2), greatest(main, '6', of(which, 'asymptotic'), 0) + 6)
        set title name_of(which).', '.first_of(main, 10, in_panel) offset 0, -0.5
        set xrange [0:highest * 1.03]
        set yrange [low - 1:high + 1]
        set xlabel 'order N'
        if ((p - 1) % across == 0) { set ylabel 'log_{10} of the error' } else { unset ylabel }
        unset key
        plot rows(main, 2, 6, of(which, 'series')) using 1:2 with lines lw 2 dt 2 lc rgb shade[5], \
             rows(main, 2, 6, of(which, 'pade')) using 1:2 with lines lw 1.5 dt 4 lc rgb shade[3], \
             rows(main, 2, 9, of(which, 'asymptotic')) using 1:2 with lines lw 1.8 dt 3 lc rgb '#444444', \
             rows(main, 2, 6, of(which, 'asymptotic')) using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb shade[4]
        eval no_heading
    }
    if (has_losses) {
        eval panel(n + 1)
        set title 'digits lost in double' offset 0, -0.5
        set xrange [0:highest * 1.03]
        set yrange [-1:1.7 * greatest(losses, '7', '1', 16)]
        set xlabel 'number of exponentials'
        set ylabel 'digits'
        set key top left reverse Left
        plot for [i=1:words(with_losses)] rows(losses, 2, 7, sprintf('$1 == "%s" && $7 !~ /inf/', word(with_losses, i))) using 1:2 with linespoints pt mark_of(i) ps 0.7 lw 1.8 lc rgb shade[i] title name_of(word(with_losses, i)), \
             15.95 with lines lw 1.2 dt 3 lc rgb soft title 'digits of double'
        unset key
    }
    eval key_strip
    plot NaN with lines lw 2 dt 2 lc rgb shade[5] title 'series', \
         NaN with lines lw 1.5 dt 4 lc rgb shade[3] title 'Padé', \
         NaN with linespoints pt 7 ps 0.5 lw 2 lc rgb shade[4] title 'asymptotic approximant', \
         NaN with lines lw 1.8 dt 3 lc rgb '#444444' title 'predicted by its form, up to a factor'
    eval figure_done
}
