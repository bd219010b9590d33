# domb_sykes: the plots in t and in the power of t that symmetry leaves, and the results of radius tests for the same
# lists.
# Columns: energy,point,power,n,inverse_n,ratio,scaled_ratio,log10_scaled_ratio,line,gap. domb_sykes_lists:
# energy,point,power,first,ratios,undefined,zero,least,largest,limit,radius,pattern. domb_sykes_intercepts:
# energy,point,order,method,radius,uncertainty,exact,relative_error,log10_relative_error,log10_relative_uncertainty,
# note.
#
# For any equation: ratios of the coefficients against 1/n, one panel per unknown, one colour per combination of the
# parameters; lines at plus and minus R^-p of the verdict of the longest list.
# Columns: <axes>,power,n,inverse_n,ratio,log10_abs_ratio,unknown; in _intercepts the results of the tests.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    intercepts = table_of('_intercepts')
    eval axes_before('power')
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
            eval panel_of_unknown(p)
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
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file = data.'/domb_sykes.csv'
lists = data.'/domb_sykes_lists.csv'
energies = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq", lists))
points = ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", lists))
shown = words(energies)
energy(j) = word(energies, j)
named(j) = energy_name(energy(j), cell_at(file, 10, '1', energy(j), '1'))
about(p) = p eq '0' ? 'About the top' : p eq '1' ? 'About the bottom' : 'About '.p.' T*'
down = smaller(words(points), 6)
edge = 2.85               # ratios beyond it are drawn at it
widest = ask(sprintf("tail -n +2 '%s' | cut -d, -f4 | sort -n | tail -n 1", file)) >= 12 ? 0.21 : 0.55
plot_of(e, p, k) = e.','.p.','.sprintf('%d', k)
# The power that symmetry leaves at (e, p), and the theoretical intercept in t^power.
power(e, p) = or_0(cell_at(lists, 3, '1 2', e.','.p, '1'))
limit(e, p, k) = or_0(cell_at(lists, 10, '1 2 3', plot_of(e, p, k), '1'))
not_defined(e, p, k) = or_0(cell_at(lists, 6, '1 2 3', plot_of(e, p, k), '1'))
# "1/n,ratio" of a plot, clipped to the edge. Of more than 60 ratios every second pair: they are close together near 1/n
# = 0.
thinned = '($4 <= 60 || int($4 / 4) * 2 == int($4 / 2))'
clipped = sprintf('($8 !~ /inf/ && $8 + 0 > %g ? ($7 ~ /^-/ ? -%g : %g) : $7 + 0)', log10(edge), edge, edge)
ratios(e, p, k) = parts_at(file, '$5', clipped, '1 2 3', plot_of(e, p, k), '$7 != "" && '.thinned)
undefined(e, p, k) = parts_at(file, '$5', '-2.55', '1 2 3', plot_of(e, p, k), '$7 == "" && '.thinned)
# "in t^2 (E = 1: in t^4)"
in_power(k) = k == 1 ? 'in t' : sprintf('in t^%d', k)
apart(p) = ask(sprintf("awk -F, 'NR > 1 && $2 == \"%s\" { of[$1] = $3 } END { for (e in of) ++seen[of[e]]; for (k in seen) if (seen[k] > most) { most = seen[k]; usual = k }; printf \"%%d\", usual; for (e in of) if (of[e] != usual) printf \" %%s %%d\", e, of[e] }' '%s'", p, lists))
title_of(s) = in_power(word(s, 1) + 0).(words(s) > 2 ? '; E = '.number_name(word(s, 2)).': '.in_power(word(s, 3) + 0) : '')
high = 400
head = 40
foot = 46
all = head + high * down + foot + 0.0

do for [kind in terminals] {
    eval use_terminal(kind, target.'/domb_sykes', 1180, all)
    set multiplot
    set label 1 'Domb-Sykes plots: ratios of coefficients times the exact R^p, in t^p' at screen 0.5, 1 - 20 / all center font ',16'
    set xrange [0:widest]
    set yrange [-3:3]
    set xlabel '1/n'
    set lmargin 8; set rmargin 2; set tmargin 2.2; set bmargin 3.4
    do for [q=1:down] {
        p = word(points, q)
        symmetric = 0
        do for [j=1:shown] { symmetric = symmetric + (power(energy(j), p) > 1) }
        do for [side=1:(symmetric ? 2 : 1)] {
            set origin (side - 1) * 0.5, (foot + high * (down - q)) / all
            set size symmetric ? 0.5 : 1, high / all
            set title about(p).', '.(side == 1 ? 'in t' : title_of(apart(p)))
            set ylabel side == 1 ? 'a_n/a_{n-1} · R' : 'a_n/a_{n-p} · R^p'
            if (q == 1 && side == 1) { set key at screen 0.5, (foot - 8) / all center top vertical maxrows 1 title '' samplen 1 width 2 } else { unset key }
            set yrange [-3:3]
            set arrow 1 from 0, 1 to widest, 1 nohead lc rgb '#bbbbbb' lw 0.8 back
            set arrow 2 from 0, -1 to widest, -1 nohead lc rgb '#bbbbbb' lw 0.8 back
            lines = ''
            straight = 0
            bad = 0
            do for [j=1:shown] {
                k = side == 1 ? 1 : power(energy(j), p)
                s = limit(energy(j), p, k)
                straight = straight + (s != 0)
                bad = bad + not_defined(energy(j), p, k)
                lines = lines.(s ? sprintf("[0:%g] %d * (1 - %d * x) with lines lw 5 lc rgb '#dddddd' notitle, ", widest, s, k) : '')
                if (s) { set label 10 + j '' at 0, s point pt 13 ps 1.8 lc rgb '#D55E00' front }
            }
            if (straight == shown && !bad) { set yrange [-1.25:0.25]; unset arrow 1 }
            if (straight) { set label 2 '◆ exact: ±1/R^p, and the slope of a logarithm' at graph 0.98, 0.94 right textcolor rgb soft }
            if (straight < shown && !bad) { set label 3 (straight ? 'elsewhere ' : '').'a pair is nearest: no intercept' at graph 0.98, 0.865 right textcolor rgb soft }
            if (bad) { set label 3 'bottom rows: not defined, divided by 0' at graph 0.98, 0.23 right textcolor rgb soft }
            eval 'plot '.lines.'for [j=1:shown] ratios(energy(j), p, side == 1 ? 1 : power(energy(j), p)) using 1:2 with points pt mark_of(j) ps 0.9 lw 1.3 lc rgb colour(j, shown) title in_key(j, shown) ? "E = ".named(j) : "", for [j=1:shown] undefined(energy(j), p, side == 1 ? 1 : power(energy(j), p)) using 1:(column(2) - smaller(0.09, 0.4 / shown) * (j - 1)) with points pt 2 ps 0.35 lw 1 lc rgb colour(j, shown) notitle'
            unset label 1; unset label 2; unset label 3
            do for [j=1:shown] { unset label 10 + j }
        }
    }
    unset multiplot
    unset output
}

# The results of the tests for the same lists.
answers = data.'/domb_sykes_intercepts.csv'
figure = 'domb_sykes_intercepts'
listed = 'ratio-in-power domb-sykes mercer-roberts verdict'
results_title = 'Relative error of R by the tests, from N coefficients'
results_axis = 'log_{10} |R estimated/R - 1|'
lowest = int(smaller(-4, least(answers, '9', '1', 0))) - 2
floor_of(m) = lowest
top_of(m) = 2
with_uncertainties = 0
point(q) = word(points, q)
load scripts.'/shared/test_results.gp'
