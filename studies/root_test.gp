# root_test: error of |a_n|^(-1/n) and of |n a_n|^(-1/n) against n, and the results of the tests by size.
# Columns: energy,point,n,root,corrected,exact,root_error,corrected_error,log10_root_error,log10_corrected_error,
# amplitude,gap. root_test_estimates: energy,point,order,method,radius,uncertainty,exact,relative_error,
# log10_relative_error,log10_relative_uncertainty,note.
#
# For any equation: the roots of the coefficients against 1/n, one panel per unknown, one colour per combination of the
# parameters; lines at the verdict of the longest list.
# Columns: <axes>,n,inverse_n,root,corrected,unknown; in _estimates the results of the tests.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    estimates = table_of('_estimates')
    eval axes_before('n')
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
            eval panel_of_unknown(p)
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
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file = data.'/root_test.csv'
energies = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq", file))
points = ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", file))
shown = words(energies)
across = smaller(words(points), 4)
energy(j) = word(energies, j)
place(i) = pick(points, 4, i)
named(j) = energy_name(energy(j), cell_at(file, 12, '1', energy(j), '1'))
about(p) = p eq '0' ? 'About the top' : p eq '1' ? 'About the bottom' : 'About '.p.' T*'
last = ask(sprintf("tail -n +2 '%s' | cut -d, -f3 | sort -n | tail -n 1", file)) + 0
amplitude(p) = ask(sprintf("awk -F, '$2 == \"%s\" { print $11; exit }' '%s'", p, file)) + 0
# "n,log10 error"; of several n that are close together on the axis of log n the first is drawn.
sparse = '(b = int(60 * log($3))) != last[$1, $2] && ((last[$1, $2] = b) || 1)'
errors(e, p, k) = parts_at(file, '$3', sprintf('$%d', k), '1 2', e.','.p, sprintf('$%d !~ /inf/ && ', k).sparse)
log10_of(x) = x == 0 ? NaN : log10(abs(x))
highest = ask(sprintf("awk -F, 'BEGIN { l = 0.2 } NR > 1 { for (c = 9; c <= 10; ++c) if ($c !~ /inf/ && $c + 0 > l) l = $c + 0 } END { print l + 0.3 }' '%s'", file)) + 0
high = 350
head = 40
foot = 46
all = head + high * 2 + foot + 0.0

do for [kind in terminals] {
    eval use_terminal(kind, target.'/root_test', across < 2 ? 760 : 560 * across, all)
    set multiplot
    set label 1 (across < 2 ? 'The root test against n' : 'The root test, plain and corrected, against the exact radius') at screen 0.5, 1 - 20 / all center font ',16'
    set logscale x
    set xtics (2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000)
    set xrange [2:last * 1.15]
    set samples 600
    set xlabel 'n'
    set lmargin 9; set rmargin 2; set tmargin 2.2; set bmargin 3.4
    do for [row=0:1] {
        do for [i=1:across] {
            p = place(i)
            a = amplitude(p)
            set origin (i - 1.0) / across, (foot + high * (1 - row)) / all
            set size 1.0 / across, high / all
            set title about(p).(row == 0 ? ': |a_n|^{−1/n}' : ': |n a_n|^{−1/n}')
            set yrange [row == 0 ? -4 : -5 : highest]
            if (i == 1) { set ylabel 'log_{10} |relative error|' } else { unset ylabel }
            if (row == 0 && i == 1) { set key at screen 0.5, (foot - 8) / all center top vertical maxrows 1 title '' samplen 1 width 2 } else { unset key }
            set label 2 row == 0 ? 'grey: ln n/n' : sprintf('grey: ln A/n, A = %d', a) at graph 0.98, 0.94 right textcolor rgb soft
            set label 3 row == 0 ? sprintf('dotted: (n/A)^{1/n} − 1, A = %d', a) : 'dotted: 1 − A^{−1/n}' at graph 0.98, 0.855 right textcolor rgb soft
            plot [2:last * 1.15] log10_of(row == 0 ? log(x) / x : log(a) / x) with lines lw 5 lc rgb '#dddddd' notitle, \
                 log10_of(row == 0 ? (x / a)**(1 / x) - 1 : 1 - a**(-1 / x)) with lines lw 1.2 dt 3 lc rgb '#555555' notitle, \
                 for [j=1:shown] errors(energy(j), p, 9 + row) using 1:2 with points pt mark_of(j) ps 0.7 lw 1.2 lc rgb colour(j, shown) title in_key(j, shown) ? 'E = '.named(j) : ''
            unset label 1; unset label 2; unset label 3
        }
    }
    unset multiplot
    unset output
}

# The results of the tests by size: lines are errors, thin ones uncertainties.
answers = data.'/root_test_estimates.csv'
figure = 'root_test_estimates'
listed = 'root root-corrected top-line verdict'
results_title = 'Relative error (marks) and uncertainty (thin lines) of R, from N coefficients'
results_axis = 'log_{10} (|error|/R)'
floor_below(which) = int(smaller(-3, least(answers, '9', which, 0))) - 2
of_verdict = floor_below('$4 == "verdict"')
of_sizes = floor_below('$4 != "verdict"')
floor_of(m) = m eq 'verdict' ? of_verdict : of_sizes
top_of(m) = m eq 'verdict' ? 2 : 1
with_uncertainties = 1
down = across
point(q) = place(q)
load scripts.'/shared/test_results.gp'
