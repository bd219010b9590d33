# terms: the least order for D digits against the distance of E from 2, on either side; for one energy or two against D.
# Columns: energy,gap,digits,method,order,terms,predicted,proved_order,norm,norm_before,log10_norm,log10_gap.
#
# For any equation: the least order against the number of digits, one panel per unknown, one colour per combination of
# the parameters; thin the prediction from the rate of the series.
# Columns: <axes>,digits,method,order,predicted,norm,norm_before,log10_norm,unknown; in _radius reach, radius, rate, ...
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    eval axes_before('digits')
    tone(c, m) = n == 1 ? shade[m eq 'series' ? 4 : 3] : colour(c, n)
    curve(c, u, m) = both(both(in_case(word(all, c)), of_unknown(main, u)), with_word(main, 'method', m))
    eval grid(drawn, 3)
    foot = foot_for(shown_in_key(n) + 3, 18)
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Terms for D digits of '.called, 'the least order whose largest error at the times is at most 10^{−D}'.left_out)
        do for [p=1:drawn] {
            eval panel_of_unknown(p)
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
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'
tone(i, n) = n <= 6 ? shade[word('4 6 2 3 5 1', i) + 0] : colour(i, n)     # neighbours far apart

file = data.'/terms.csv'
digits = sorted(file, 3, '1')
energies = seen(file, 1, '1')
n = words(digits)
side(k) = k == 1 ? '$2 !~ /^-/' : '$2 ~ /^-/'
panels = ''
do for [k=1:2] { if (count_of(file, side(k)) > 0) { panels = panels.' '.k } }
by_digits = words(energies) <= 2
if (by_digits) { panels = words(energies) == 1 ? '1' : '1 2' }

one_two_five = '1'
do for [k=0:6] { do for [m in '2 5 10'] { one_two_five = one_two_five.sprintf(', %d', m * 10**k) } }

eval grid(words(panels), 2)
panel_w = across == 1 ? 860 : 590
panel_h = 500
foot = foot_for((by_digits ? 2 : shown_in_key(n) + 2) + 3, 17)
do for [kind in terminals] {
    eval figure_of(kind, 'terms')
    eval heading('Powers for D digits on [0, T*]', 'the error norm is at most 10^{−D} rad')
    set lmargin 11; set rmargin 2; set tmargin 2; set bmargin 3.6
    set logscale y
    low = least(file, '5', '$5 > 0', 3) / 1.6; high = greatest(file, '5 8', '1', 10) * 1.6
    set yrange [low:high]
    if (high < 30 * low) { eval 'set ytics ('.one_two_five.')' } # if powers of ten would be one or two tics
    set format y '%g'
    do for [p=1:words(panels)] {
        eval panel(p)
        if (p == 1) { set ylabel 'order N' } else { unset ylabel }
        unset key
        if (by_digits) {
            e = word(energies, p)
            at(m) = sprintf('$1 == "%s" && $4 == "%s"', e, m)
            set title 'E = '.energy_name(e, first_of(file, 2, sprintf('$1 == "%s"', e))) offset 0, -0.5
            set xlabel 'digits D'
            set xrange [0:word(digits, n) * 1.08]
            plot rows(file, 3, 7, at('series')) using 1:2 with lines lw 1.5 dt 3 lc rgb '#444444', \
                 for [m in 'series resummed'] rows(file, 3, 5, at(m).' && $5 > 0') using 1:2 with linespoints pt 7 ps 0.6 lw 2 dt dash_of(m) lc rgb (m eq 'series' ? shade[5] : shade[4]), \
                 for [m in 'series resummed'] rows(file, 3, 8, at(m)) using 1:2 with points pt (m eq 'series' ? 1 : 2) ps 0.8 lc rgb (m eq 'series' ? shade[5] : shade[4])
        } else {
            k = word(panels, p) + 0
            which = ' && '.side(k)
            set title k == 1 ? 'libration, E < 2' : 'rotation, E > 2' offset 0, -0.5
            set xlabel gap_axis
            eval falling('x', least(file, '12', side(k), 0), greatest(file, '12', side(k), 0))
            plot for [i=1:n] rows_at(file, 12, 7, '3 4', word(digits, i).',series', '1'.which) using 1:2 with lines lw 1.5 dt 3 lc rgb tone(i, n), \
                 for [i=1:n] for [m in 'series resummed'] rows_at(file, 12, 5, '3 4', word(digits, i).','.m, '$5 > 0'.which) using 1:2 with linespoints pt 7 ps 0.5 lw 2 dt dash_of(m) lc rgb tone(i, n), \
                 for [i=1:n] rows_at(file, 12, 8, '3 4', word(digits, i).',series', '1'.which) using 1:2 with points pt 1 ps 0.8 lc rgb tone(i, n), \
                 for [i=1:n] rows_at(file, 12, 8, '3 4', word(digits, i).',resummed', '1'.which) using 1:2 with points pt 2 ps 0.7 lc rgb tone(i, n)
        }
        eval no_heading
    }
    eval key_strip
    plot for [i=1:(by_digits ? 1 : n)] NaN with lines lw 2.4 lc rgb tone(i, n) title !by_digits && in_key(i, n) ? 'D = '.word(digits, i) : '', \
         NaN with linespoints pt 7 ps 0.5 lw 2 dt 2 lc rgb by_digits ? shade[5] : soft title 'series', \
         NaN with linespoints pt 7 ps 0.5 lw 2 lc rgb by_digits ? shade[4] : soft title 'resummation', \
         NaN with points pt 1 ps 0.8 lc rgb soft title 'proved bound, series', \
         NaN with points pt 2 ps 0.7 lc rgb soft title 'proved bound, resummation', \
         NaN with lines lw 1.5 dt 3 lc rgb soft title 'D ln 10 / ln (R/T*)'
    eval figure_done
}
