# proved_radius of any equation: the radius against the parameter with the most values, one curve per combination of the
# others, and the cost of a proof against its digits.
# Columns: <axes>,digits,lower,upper,position_re,position_im,kind,unknown; in _cost <axes>,digits,discs,seconds,unknown.
load scripts.'/shared/panels.gp'

costs = table_of('_cost')
k = place(main, 'digits') - 1
lower = place(main, 'lower')
values(i) = i <= k ? words(seen(main, i, '1')) : 1
along = 1
do for [i=2:k] { if (values(i) > values(along)) { along = i } }
most = greatest(main, text_of_column(main, 'digits'), '1', 1)
at_most = k > 0 ? sprintf('$%d == %d', k + 1, int(most)) : '1'
others(j) = j == along ? '"-"' : sprintf('$%d', j)
cells = ''
do for [j=1:k] { cells = cells.(j > 1 ? ' "," ' : '').others(j) }
curves = k > 1 ? ask(sprintf("awk -F, 'NR > 1 { s = %s; if (!n[s]++) print s }' '%s'", cells, main)) : 'all'
m = words(curves)
is_curve(c) = k > 1 ? sprintf('(%s) == "%s"', cells, word(curves, c)) : '1'
curve_name(c) = k > 1 ? ask(sprintf("head -n 1 '%s' | cut -d, -f1-%d | awk -F, -v c=\"%s\" '{ split(c, v, \",\"); for (i = 1; i <= NF; ++i) if (v[i] != \"-\") s = s $i \" = \" sprintf(\"%%.6g\", v[i]) \" \"; print s }'", main, k, word(curves, c))) : 'radius'
abscissa = k > 0 ? along : k + 1
tone(c) = m == 1 ? shade[5] : colour(c, m)
every_digit = words(seen(costs, k + 1, '1')) > 1
across = every_digit ? 3 : 1; down = 1
panel_w = every_digit ? 400 : 900; panel_h = 420
foot = foot_for(shown_in_key(m), 20)

do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Radius of convergence of '.called.', proved', sprintf('bounds about the start that agree to %d digits', int(most)))
    eval panel(1)
    eval single_panel
    set xlabel k > 0 ? header(main, along) : 'digits D'
    set ylabel 'radius R / unit of the variable'
    eval rising('x', span(main, header(main, abscissa), '1', 0, -1), span(main, header(main, abscissa), '1', 1, 1))
    if (k == 0) { eval tics_at('x', sorted(main, k + 1, '1'), 8) }
    set yrange [0:larger(1e-30, 1.1 * greatest(main, sprintf('%d', lower), '1', 1))]
    plot for [c=1:m] rows(main, abscissa, lower, both(is_curve(c), at_most)) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
    eval no_heading
    if (every_digit) {
        set xlabel 'digits D'
        set logscale x
        eval tics_at('x', sorted(costs, k + 1, '1'), 6)
        eval sprintf('set xrange [%.9g:%.9g]', least(costs, sprintf('%d', k + 1), '1', 1) / 1.2, most * 1.2)
        do for [part in 'discs seconds'] {
            c = place(costs, part)
            eval panel(part eq 'discs' ? 2 : 3)
            set title part eq 'discs' ? 'discs of a proof' : 'time of a proof' offset 0, -0.5
            set ylabel part eq 'discs' ? 'discs' : 'log_{10} (time / s)'
            if (part eq 'discs') {
                set yrange [0:1.15 * greatest(costs, sprintf('%d', c), '1', 1)]
                plot rows(costs, k + 1, c, '1') using ($1 > 1e9 ? NaN : $1):2 with points pt 7 ps 0.7 lc rgb shade[3]
            } else {
                eval rising('y', floor(log10(least(costs, sprintf('%d', c), 'v($'.sprintf('%d', c).') > 0', 1))), ceil(log10(greatest(costs, sprintf('%d', c), '1', 1))))
                plot rows(costs, k + 1, c, 'v($'.sprintf('%d', c).') > 0') using ($1 > 1e9 ? NaN : $1):(log10($2)) with points pt 7 ps 0.7 lc rgb shade[4]
            }
        }
        unset logscale
        set xtics autofreq
    }
    eval key_strip
    plot for [c=1:m] NaN with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c) title in_key(c, m) ? curve_name(c) : ''
    eval figure_done
}
