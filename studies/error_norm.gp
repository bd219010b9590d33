# error_norm: for one energy, or few and many orders, the norm against the order: the main convergence study, with the
# rate, the bounds and the floors of the arithmetics. Otherwise the norm against the energy and towards the separatrix
# on either side. And the floors of the scalars against the energy.
# Columns: energy,order,method,norm,time_of_maximum,scalar,rigour,gap,bound,log10_norm,log10_bound,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-400 nor 2 - 1e-22 is representable in double.
#
# For any equation: the norms against the order, one panel per unknown, one colour per combination of the parameters,
# marks for the methods; thin the rate reach/R of the radius estimated from the coefficients.
# Columns: <axes>,order,method,norm,time_of_maximum,scalar,rigour,log10_norm,unknown; in _radius reach, rate, ...
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    radii = table_of('_radius')
    eval axes_before('order')
    N = place(main, 'order')
    y = place(main, 'log10_norm')
    scalar = first_of(main, place(main, 'scalar'), '1')
    methods = 'series pade endpoint'
    name_of(m) = m eq 'pade' ? 'Padé [N/2, N/2]' : m eq 'endpoint' ? 'endpoint' : 'series'
    number_of(m) = m eq 'series' ? 1 : m eq 'pade' ? 2 : 3
    tone(c, m) = n == 1 ? shade[m eq 'series' ? 4 : m eq 'pade' ? 5 : 3] : colour(c, n)
    curve(c, u, m) = both(both(in_case(word(all, c)), of_unknown(main, u)), with_word(main, 'method', m))
    rate_of(c, u) = ask(sprintf("awk -F, 'NR > 1 && %s && $%d != \"\" { print $%d; exit }' '%s'", both(in_case(word(all, c)), of_unknown(radii, u)), place(radii, 'rate'), place(radii, 'rate'), radii))
    height_of(c, u, rate) = number(ask(sprintf("awk -F, 'NR > 1 && %s && $%d !~ /inf/ && $%d != \"\" { h = $%d - $%d * %.12g; if (!s++ || h > m) m = h } END { print s ? m : 0 }' '%s'", curve(c, u, 'series'), y, y, y, N, log10(rate), main)))

    eval grid(drawn, 3)
    foot = foot_for(shown_in_key(n) + 4, n == 1 ? 14 : 20)
    bottom = least(main, sprintf('%d', y), '1', 0)
    top = greatest(main, sprintf('%d', y), '1', 0)
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Error of the series of '.called.' and of its approximants', 'the largest error at times up to '.tidy(first_of(radii, place(radii, 'reach'), '1')).' from the start, '.in_arithmetic(scalar).left_out)
        do for [p=1:drawn] {
            eval panel_of_unknown(p)
            eval rising('x', least(main, sprintf('%d', N), '1', 0), greatest(main, sprintf('%d', N), '1', 1))
            set yrange [bottom - 1:top + 1]
            set xlabel 'order N'
            set ylabel 'log_{10} (max |error| / '.unit_name(u).')'
            array slope[n]
            array height[n]
            do for [c=1:n] {
                r = rate_of(c, u)
                slope[c] = strlen(r) > 0 ? log10(number(r)) : 0
                height[c] = strlen(r) > 0 ? height_of(c, u, number(r)) : 1e9
            }
            plot for [c=1:n] height[c] + x * slope[c] with lines lw 1 dt 3 lc rgb tone(c, 'series'), \
                 for [c=1:n] for [m in methods] rows(main, N, y, curve(c, u, m)) using 1:2 with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb tone(c, m)
            eval no_heading
        }
        eval key_strip
        plot for [m in methods] NaN with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb n == 1 ? tone(1, m) : soft title name_of(m), \
             NaN with lines lw 1 dt 3 lc rgb soft title 'rate (reach/R)^N', \
             for [c=1:n] NaN with lines lw 2.4 lc rgb tone(c, 'series') title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file(suffix) = data.'/error_norm'.suffix.'.csv'
main = file('')
orders = sorted(main, 2, '1')
energies = seen(main, 1, '1')
n = words(orders)
scalar = first_of(main, 6, '1')
# Whether the dotted lines are visible: with two points at least, and not far above the norms.
bounded = count_of(main, sprintf('$11 != "" && $11 !~ /inf/ && $11 < %g', greatest(main, '10', '1', 0) + 2)) > 1
arithmetics = ''
do for [s in 'double long-double quad'] { if (exists_file(file('_'.s))) { arithmetics = arithmetics.' '.s } }
# log10 of the unit of an arithmetic, mpfr:D and ball:D by their digits.
unit_of(s) = s eq 'double' ? -15.65 : s eq 'long-double' ? -18.96 : s eq 'quad' ? -33.72 : -real(s[strstrt(s, ':') + 1:*])
# T*/R from the complete integrals, K/sqrt(K^2 + K'^2) on either side of E = 2, by arithmetic-geometric means.
rate_of(e, g) = number(ask("awk '".awk_v."function agm(a, b, c) { while (a - b > 1e-15 * a) { c = (a + b) / 2; b = sqrt(a * b); a = c } return a } BEGIN { e = v(\"".e."\"); g = v(\"".g."\"); m = g > 0 ? e / 2 : 2 / e; n = g > 0 ? g / 2 : -g / e; k = 1 / agm(1, sqrt(n > 0 ? n : 1e-300)); c = 1 / agm(1, sqrt(m)); print k / sqrt(k * k + c * c) }'"))

panel_h = 540
if (words(energies) <= 2 || (n >= 3 && words(energies) <= 4)) {
    series_colour = shade[5]; resummed_colour = shade[4]
    rounded = '' # suffixes of their tables; the main table if there are none, as gnuplot runs an empty loop once
    do for [s in arithmetics] { rounded = rounded.' _'.s }
    tone(m) = m eq 'series' ? series_colour : resummed_colour
    eval grid(words(energies), 2)
    panel_w = across == 1 ? 900 : 590
    foot = foot_for(8, 14)
    bottom = least(main, '10', '1', 0)
    do for [s in arithmetics] { bottom = smaller(bottom, least(file('_'.s), '10', '1', 0)) }
    coarsest = words(arithmetics) > 0 ? unit_of(word(arithmetics, 1)) : unit_of(scalar)
    if (coarsest > bottom - 25) { bottom = smaller(bottom, coarsest) }
    top = greatest(main, '10', '1', 0)
    floors_drawn = 0
    do for [kind in terminals] {
        eval figure_of(kind, 'error_norm')
        eval heading('Convergence of the series and of its resummation on [0, T*]', 'the largest error on the way from the top to the bottom, '.in_arithmetic(scalar))
        do for [p=1:words(energies)] {
            e = word(energies, p)
            g = first_of(main, 8, sprintf('$1 == "%s"', e))
            rate = rate_of(e, g)
            clear = smaller(0, unit_of(scalar) + 2)
            height = number(ask(sprintf("awk -F, '$1 == \"%s\" && $3 == \"series\" && $10 !~ /inf/ && $10 > %g { h = $10 - $2 * %.12g; if (!n++ || h > m) m = h } END { print n ? m : 0 }' '%s'", e, clear < 0 ? clear : -1e9, log10(rate), main)))
            eval panel(p)
            set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6
            set title 'E = '.energy_name(e, g).sprintf(', rate T*/R = %.4g', rate) offset 0, -0.5
            eval rising('x', 0, word(orders, n) + 0)
            set xrange [0:*]
            set xrange [0:larger(word(orders, n) * 1.06, 2)]
            set yrange [bottom - 2:top + 2]
            set xlabel 'order N'
            if ((p - 1) % across == 0) { set ylabel norm_axis } else { unset ylabel }
            unset key
            k = 0
            do for [s in arithmetics.' '.scalar] {
                k = k + 1
                if (unit_of(s) > bottom - 2) {
                    floors_drawn = 1
                    set arrow 10 + k from graph 0, first unit_of(s) to graph 1, first unit_of(s) nohead lc rgb '#888888' lw 1.2 dt 4
                    set label 10 + k 'ε of '.arithmetic_name(s) at graph 0.01, first unit_of(s) left offset 0, 0.5 textcolor rgb soft
                }
            }
            plot [0:word(orders, n) * 1.06 + 1] height + x * log10(rate) with lines lw 1.2 dt 5 lc rgb '#444444', \
                 for [m in 'series resummed'] rows_at(main, 2, 11, '1 3', e.','.m, '1') using 1:2 with lines lw 1.5 dt 3 lc rgb tone(m), \
                 for [m in 'series resummed'] rows_at(main, 2, 10, '1 3', e.','.m, '1') using 1:2 with linespoints lw 2.2 dt dash_of(m) pt 7 ps 0.6 lc rgb tone(m), \
                 for [i=1:words(rounded)] for [m in 'series resummed'] rows_at(file(word(rounded, i)), 2, 10, '1 3', e.','.m, words(arithmetics) > 0 ? '1' : '0') using 1:2 with points pt mark[i] ps 0.9 lw 1.2 lc rgb tone(m)
            eval no_heading
            do for [i=1:k] { unset arrow 10 + i; unset label 10 + i }
        }
        eval key_strip
        plot NaN with linespoints lw 2.2 dt 2 pt 7 ps 0.6 lc rgb series_colour title 'series', \
             NaN with linespoints lw 2.2 dt 1 pt 7 ps 0.6 lc rgb resummed_colour title 'resummation', \
             NaN with lines lw 1.5 dt 3 lc rgb soft title bounded ? 'proved bound' : '', \
             NaN with lines lw 1.2 dt 5 lc rgb '#444444' title 'rate (T*/R)^N', \
             for [i=1:words(rounded)] NaN with points pt mark[i] ps 0.9 lw 1.2 lc rgb soft title words(arithmetics) > 0 ? 'in '.arithmetic_name(word(arithmetics, i)) : '', \
             NaN with lines lw 1.2 dt 4 lc rgb '#888888' title floors_drawn ? 'ε, the floor of an arithmetic' : ''
        eval figure_done
    }
} else {
    # The Runge-Kutta solution in double with the smallest step, if that table exists: "step log10_norm".
    march = file('_baseline')
    baseline = exists_file(march) ? ask(sprintf("grep ',double,' '%s' | tail -n 1 | cut -d, -f2,9 --output-delimiter=' '", march)) : ''
    near(side) = sprintf('$8 %s /^-/ && $12 < -0.9', side)
    librations = words(seen(main, 12, near('!~'))) > 1
    rotations = words(seen(main, 12, near('~'))) > 1
    over_energy = words(seen(main, 1, '$12 > -2.1')) > 1 || librations + rotations == 0
    count = over_energy + librations + rotations
    eval grid(count, 3)
    panel_w = count == 1 ? 900 : count == 2 ? 590 : 400
    foot = foot_for(shown_in_key(n) + 4, 12)
    do for [kind in terminals] {
        eval figure_of(kind, 'error_norm')
        eval heading('Error of the pendulum series and of its resummation on [0, T*]', 'the largest error on the way from the top to the bottom'.', '.in_arithmetic(scalar).(words(baseline) == 2 ? sprintf('; RK4: Runge-Kutta method in double, Δt = %s', number_name(tidy(word(baseline, 1)))) : ''))
        set rmargin 2; set tmargin 2; set bmargin 3.6; set lmargin 9
        p = 0
        if (over_energy) {
            p = p + 1
            eval panel(p)
            left = least(main, '1', '1', 0); right = greatest(main, '1', '1', 4)
            eval energies_on_x(left, right)
            eval separatrix_on_x(left, right)
            set yrange [least(main, '10', '1', 0) - 1:greatest(main, '10', '1', 0) + 2]
            set xlabel e_axis
            set ylabel norm_axis
            if (words(baseline) == 2) { set arrow 3 from graph 0, first (word(baseline, 2) + 0) to graph 1, first (word(baseline, 2) + 0) nohead lc rgb '#666666' lw 1.5 dt 4 }
            unset key
            plot for [i=1:n] for [m in 'series resummed'] rows_at(main, 1, 11, '2 3', word(orders, i).','.m, '1') using 1:2 with lines lw 1.1 dt 3 lc rgb colour(i, n), \
                 for [i=1:n] for [m in 'series resummed'] rows_at(main, 1, 10, '2 3', word(orders, i).','.m, '1') using 1:2 with lines lw 2 dt dash_of(m) lc rgb colour(i, n)
            unset arrow
            eval energies_done
            eval no_heading
        }
        do for [side in '!~ ~'] {
            if (side eq '~' ? rotations : librations) {
                p = p + 1
                eval panel(p)
                which = sprintf(' && $8 %s /^-/', side)
                eval falling('x', least(main, '12', '1'.which, 0), greatest(main, '12', '1'.which, 0))
                set yrange [least(main, '10', near(side), 0) - 1:greatest(main, '10', near(side), 0) + 2]
                set title side eq '~' ? 'rotation, E > 2' : 'libration, E < 2' offset 0, -0.5
                set xlabel gap_axis
                if (p == 1) { set ylabel norm_axis } else { unset ylabel }
                if (words(baseline) == 2) {
                    set arrow 3 from graph 0, first (word(baseline, 2) + 0) to graph 1, first (word(baseline, 2) + 0) nohead lc rgb '#666666' lw 1.5 dt 4
                }
                unset key
                plot for [i=1:n] for [m in 'series resummed'] rows_at(main, 12, 11, '2 3', word(orders, i).','.m, '1'.which) using 1:2 with lines lw 1.1 dt 3 lc rgb colour(i, n), \
                     for [i=1:n] for [m in 'series resummed'] rows_at(main, 12, 10, '2 3', word(orders, i).','.m, '1'.which) using 1:2 with lines lw 2 dt dash_of(m) lc rgb colour(i, n)
                unset arrow
                eval no_heading
            }
        }
        eval key_strip
        plot for [i=1:n] NaN with lines lw 2.4 lc rgb colour(i, n) title in_key(i, n) ? 'N = '.word(orders, i) : '', \
             NaN with lines lw 2 dt 2 lc rgb soft title 'series', \
             NaN with lines lw 2 lc rgb soft title 'resummation', \
             NaN with lines lw 1.1 dt 3 lc rgb soft title bounded ? 'proved bound' : '', \
             NaN with lines lw 1.5 dt 4 lc rgb '#666666' title words(baseline) == 2 ? 'RK4 at E = 2' : ''
        eval figure_done
    }

    # The floors, if there are tables of the fixed scalars.
    if (words(arithmetics) > 0 && over_energy) {
        across = words(arithmetics); down = 1
        panel_w = 400; panel_h = 440
        foot = foot_for(shown_in_key(n) + 3, 12)
        bottom = 0
        do for [s in arithmetics] { bottom = smaller(bottom, least(file('_'.s), '10', '1', 0)) }
        do for [kind in terminals] {
            eval figure_of(kind, 'error_norm_scalars')
            eval heading('The same norms in each arithmetic', 'below the floor of the arithmetic no order helps')
            set rmargin 2; set tmargin 2; set bmargin 3.6; set lmargin 9
            do for [s=1:words(arithmetics)] {
                a = word(arithmetics, s)
                eval panel(s)
                left = least(main, '1', '1', 0); right = greatest(main, '1', '1', 4)
                eval energies_on_x(left, right)
                eval separatrix_on_x(left, right)
                set yrange [bottom - 2:greatest(main, '10', '1', 0) + 1]
                set title arithmetic_name(a) offset 0, -0.5
                set xlabel e_axis
                if (s == 1) { set ylabel norm_axis } else { unset ylabel }
                unset key
                set arrow 2 from graph 0, first unit_of(a) to graph 1, first unit_of(a) nohead lc rgb '#666666' lw 1.2 dt 4
                plot for [i=1:n] for [m in 'series resummed'] rows_at(file('_'.a), 1, 10, '2 3', word(orders, i).','.m, '1') using 1:2 with lines lw 1.6 dt dash_of(m) lc rgb colour(i, n)
                unset arrow
                eval energies_done
                eval no_heading
            }
            eval key_strip
            plot for [i=1:n] NaN with lines lw 2.4 lc rgb colour(i, n) title in_key(i, n) ? 'N = '.word(orders, i) : '', \
                 NaN with lines lw 1.6 dt 2 lc rgb soft title 'series', \
                 NaN with lines lw 1.6 lc rgb soft title 'resummation', \
                 NaN with lines lw 1.2 dt 4 lc rgb '#666666' title 'ε, the floor'
            eval figure_done
        }
    }
}
