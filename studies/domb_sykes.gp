# domb_sykes: the plots in t and in the power of t that symmetry leaves, and the results of radius tests for the same
# lists.
# Columns: energy,point,power,n,inverse_n,ratio,scaled_ratio,log10_scaled_ratio,line,gap. domb_sykes_lists:
# energy,point,power,first,ratios,undefined,zero,least,largest,limit,radius,pattern. domb_sykes_intercepts:
# energy,point,order,method,radius,uncertainty,exact,relative_error,log10_relative_error,log10_relative_uncertainty,
# note.
#
# For any equation: ratios of the coefficients against 1/n, one panel per unknown, one colour per combination of the
# parameters; the intercept and the straight line that follow from the verdict of the longest list.
# Columns: <axes>,power,n,inverse_n,ratio,log10_abs_ratio,unknown; in _intercepts the results of the tests.
if (equation ne '') {
    load scripts.'/shared/panels.gp'
    load scripts.'/shared/ratio_fit.gp'

    intercepts = table_of('_intercepts')
    eval axes_before('power')
    tone(c) = n == 1 ? shade[5] : colour(c, n)
    late = sprintf('$%d >= 4', k + 2)
    curve(c, u) = both(late, both(in_case(word(all, c)), of_unknown(main, u)))
    power(c, u) = larger(1, number('0'.first_of(main, k + 1, both(in_case(word(all, c)), of_unknown(main, u)))))
    # A cell of the verdict of the longest list.
    verdict(c, u, name) = ask(sprintf("awk -F, 'NR > 1 && %s { r = $%d } END { print r }' '%s'", both(with_word(intercepts, 'method', 'verdict'), both(in_case(word(all, c)), of_unknown(intercepts, u))), place(intercepts, name), intercepts))
    eval grid(drawn, 3)
    panel_h = 490
    foot = foot_for(shown_in_key(n) + 3, 26)
    do for [kind in terminals] {
        any_fit = 0
        eval figure_of(kind, stem)
        eval heading('Domb-Sykes plot of '.called, 'ratios of coefficients about the start'.left_out)
        do for [p=1:drawn] {
            eval panel_of_unknown(p)
            set tmargin 5
            set lmargin 11
            set xlabel '1/n'
            array level[n]
            array slope[n]
            array half_width[n]
            scattered = 0
            fitted = ''
            sloped = ''
            do for [c=1:n] {
                q = power(c, u)
                found = fit_of(q, verdict(c, u, 'radius'), verdict(c, u, 'position_re'), verdict(c, u, 'position_im'), verdict(c, u, 'count'))
                level[c] = found
                scattered = found == found || strlen(verdict(c, u, 'radius')) == 0 ? scattered : larger(scattered, number(verdict(c, u, 'radius')) ** -q)
                slope[c] = fit_slope(q, found, verdict(c, u, 'exponent'))
                if (found == found) { fitted = fitted.' '.c; any_fit = 1; sloped = slope[c] == slope[c] ? sloped.' '.c : sloped }
                half_width[c] = fit_uncertainty(q, found, verdict(c, u, 'radius'), verdict(c, u, 'uncertainty'))
                if (c == 1) { about_fit = fit_in_words(verdict(c, u, 'radius'), verdict(c, u, 'uncertainty'), verdict(c, u, 'exponent'))."}\n{/*0.8 ".intercept_in_words(found, verdict(c, u, 'radius'), verdict(c, u, 'uncertainty')) }
            }
            set title u."\n{/*0.8 ".(n > 1 && k > 0 ? case_name(main, k, word(all, 1)).': ' : '').about_fit.'}' offset 0, -0.5
            set ylabel sprintf('a_n/a_{n−%d}', int(power(1, u))) offset -0.5, 0
            set xrange [0:1.05 * span(main, 'inverse_n', both(late, of_unknown(main, u)), 0.3, 1)]
            eval ratio_range(main, place(main, 'ratio'), both(late, of_unknown(main, u)), scattered)
            lines = "for [c in sloped] level[c + 0] * (1 + slope[c + 0] * x) with lines lw 1.5 lc rgb n == 1 ? '#999999' : tone(c + 0), "
            intercepts_there = ", for [c in fitted] '+' using (0):(level[c + 0]):(half_width[c + 0]) every ::0::0 with yerrorbars pt 7 ps 0.9 lw 2 lc rgb '#D55E00'"
            eval 'plot '.(words(sloped) ? lines : '')."for [c=1:n] rows(main, place(main, 'inverse_n'), place(main, 'ratio'), curve(c, u)) using ($1 > 1 ? NaN : $1):($1 > 1 ? NaN : $2) with points pt mark_of(c) ps 0.6 lc rgb tone(c)".(words(fitted) ? intercepts_there : '')
            eval no_heading
        }
        eval key_strip
        plot NaN with points pt mark_of(1) ps 0.8 lc rgb n == 1 ? tone(1) : soft title 'ratio', \
             NaN with lines lw 1.5 lc rgb '#999999' title any_fit ? 'line of radius and exponent' : '', \
             NaN with points pt 7 ps 0.9 lc rgb '#D55E00' title any_fit ? 'intercept with its interval' : '', \
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
# The energies whose plot about p is a straight line, and the sum of their intercepts, which are 1 or -1.
straight_at(p) = sum [j=1:shown] (limit(energy(j), p, power(energy(j), p)) != 0)
intercepts_at(p) = sum [j=1:shown] limit(energy(j), p, power(energy(j), p))
undefined_at(p) = sum [j=1:shown] not_defined(energy(j), p, power(energy(j), p))
# "in t^2 (E = 1: in t^4)"
in_power(k) = k == 1 ? 'in t' : sprintf('in t^%d', k)
apart(p) = ask(sprintf("awk -F, 'NR > 1 && $2 == \"%s\" { of[$1] = $3 } END { for (e in of) ++seen[of[e]]; for (k in seen) if (seen[k] > most) { most = seen[k]; usual = k }; printf \"%%d\", usual; for (e in of) if (of[e] != usual) printf \" %%s %%d\", e, of[e] }' '%s'", p, lists))
title_of(s) = in_power(word(s, 1) + 0).(words(s) > 2 ? '; E = '.number_name(word(s, 2)).': '.in_power(word(s, 3) + 0) : '')
note_of(p) = straight_at(p) == shown ? '' : straight_at(p) == 0 ? 'a pair is nearest: no intercept' : 'a pair is nearest and there is no intercept, except at'.excepted(p)
excepted(p) = (exceptions = '', sum [j=1:shown] (limit(energy(j), p, power(energy(j), p)) != 0 ? (exceptions = exceptions.' E = '.named(j), 0) : 0), exceptions)
# If symmetry leaves only powers of t^p.
symmetric = 0
do for [q=1:words(points)] { do for [j=1:shown] { symmetric = symmetric + (power(energy(j), word(points, q)) > 1) } }
eval grid(smaller(words(points), 6), 2)
panel_w = across == 1 ? 860 : 590; panel_h = 450
foot = foot_for(shown_in_key(shown) + 2, 16)

do for [kind in terminals] {
    eval figure_of(kind, 'domb_sykes')
    eval heading('Domb-Sykes plots: ratios of coefficients times the exact R^p, in t^p', symmetric ? 'in t itself every other ratio is 0 or not defined, because the solution is odd or even' : ' ')
    set xrange [0:widest]
    set xlabel '1/n'
    set lmargin 9; set rmargin 2; set tmargin 3.2; set bmargin 3.6
    unset key
    do for [q=1:across * down] {
        p = word(points, q)
        if (q <= words(points)) {
            eval panel(q)
            set title about(p).', '.title_of(apart(p))."\n{/*0.85 ".note_of(p).(undefined_at(p) ? (note_of(p) eq '' ? '' : '; ').'× at the lower edge: not defined, divided by 0' : '').' }'
            if ((q - 1) % across == 0) { set ylabel 'a_n/a_{n−p} · R^p' } else { unset ylabel }
            if (straight_at(p) == shown && abs(intercepts_at(p)) == shown && !undefined_at(p)) { set yrange [(intercepts_at(p) < 0 ? -1.25 : -0.25):(intercepts_at(p) < 0 ? 0.25 : 1.25)] } else { set yrange [-3:3] }
            set arrow 1 from 0, 1 to widest, 1 nohead lc rgb '#bbbbbb' lw 0.8 back
            set arrow 2 from 0, -1 to widest, -1 nohead lc rgb '#bbbbbb' lw 0.8 back
            lines = ''
            do for [j=1:shown] {
                k = power(energy(j), p)
                s = limit(energy(j), p, k)
                lines = lines.(s ? sprintf("[0:%g] %d * (1 - %d * x) with lines lw 5 lc rgb '#dddddd' notitle, ", widest, s, k) : '')
                if (s) { set label 10 + j '' at 0, s point pt 13 ps 1.8 lc rgb '#D55E00' front }
            }
            eval 'plot '.lines.'for [j=1:shown] ratios(energy(j), p, power(energy(j), p)) using 1:2 with points pt mark_of(j) ps 0.9 lw 1.3 lc rgb colour(j, shown) notitle, for [j=1:shown] undefined(energy(j), p, power(energy(j), p)) using 1:(column(2) - smaller(0.09, 0.4 / shown) * (j - 1)) with points pt 2 ps 0.35 lw 1 lc rgb colour(j, shown) notitle'
            unset arrow
            do for [j=1:shown] { unset label 10 + j }
            eval no_heading
        }
    }
    eval key_strip
    plot for [j=1:shown] NaN with points pt mark_of(j) ps 0.9 lw 1.3 lc rgb colour(j, shown) title in_key(j, shown) ? 'E = '.named(j) : '', \
         NaN with points pt 13 ps 1.6 lc rgb '#D55E00' title 'exact: ±1', \
         NaN with lines lw 5 lc rgb '#dddddd' title 'slope of a logarithm'
    eval figure_done
}

# The results of the tests for the same lists.
answers = data.'/domb_sykes_intercepts.csv'
figure = 'domb_sykes_intercepts'
down = smaller(words(points), 6)
listed = 'ratio-in-power domb-sykes mercer-roberts verdict'
results_title = 'Relative error of R by the tests, from N coefficients'
results_axis = 'log_{10} (|error|/R)'
lowest = int(smaller(-4, least(answers, '9', '1', 0))) - 2
floor_of(m) = lowest
top_of(m) = 2
with_uncertainties = 0
point(q) = word(points, q)
load scripts.'/shared/test_results.gp'
