# radius_map: estimated and exact radius against the expansion point, and the relative error of the verdicts.
# Columns: energy,point,order,radius,uncertainty,exact,relative_error,log10_relative_error,log10_relative_uncertainty,
# position_re,position_im,position_error,log10_position_error,kind,count,rate,tstar,height,gap,log10_gap,note.
#
# For any equation: against one parameter the radius and its relative uncertainty, one row of panels per unknown and one
# curve per order (and combination of the other parameters); against two or more parameters the plane of the first two
# of them, coloured by the radius of the largest order.
# Columns: <axes>,order,radius,uncertainty,log10_relative_uncertainty,position_re,position_im,...,note,unknown.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    k = place(main, 'order') - 1
    orders = sorted(main, k + 1, '1')
    y = place(main, 'radius')
    e = place(main, 'log10_relative_uncertainty')
    values(i) = i <= k ? words(seen(main, i, '1')) : 1
    # The axis with the most values is x; the others make curves.
    along = 1
    do for [i=2:k] { if (values(i) > values(along)) { along = i } }
    planar = k >= 2 && values(1) > 2 && values(2) > 2
    # The combination of all axes except that along x, and the order, as "a,-,c,N".
    others(j) = j == along ? '"-"' : sprintf('$%d', j)
    key_cells = ''
    do for [j=1:k] { key_cells = key_cells.(j > 1 ? ' "," ' : '').others(j) }
    curve_cells = (k > 0 ? key_cells.' "," ' : '').sprintf('$%d', k + 1)
    curves = ask(sprintf("awk -F, 'NR > 1 { s = %s; if (!n[s]++) print s }' '%s'", curve_cells, main))
    m = words(curves)
    is_curve(c) = sprintf('(%s) == "%s"', curve_cells, word(curves, c))
    curve_name(c) = ask(sprintf("head -n 1 '%s' | cut -d, -f1-%d | awk -F, -v c=\"%s\" '{ split(c, v, \",\"); for (i = 1; i < NF; ++i) if (v[i] != \"-\") s = s $i \" = \" sprintf(\"%%.6g\", v[i]) \", \"; print s \"N = \" v[NF] }'", main, k + 1, word(curves, c)))
    abscissa = k > 0 ? along : k + 1
    xname = k > 0 ? header(main, along) : 'order N'

    if (planar) {
        eval grid(drawn, 3)
        foot = 40
        last = word(orders, words(orders))
        do for [kind in terminals] {
            eval figure_of(kind, stem)
            eval heading('Radius of convergence of '.called, 'from '.last.' powers about the start'.left_out)
            do for [p=1:drawn] {
                u = drawn_unknown(p)
                eval panel(p)
                set lmargin 9; set rmargin 12; set tmargin 2; set bmargin 3.6
                unset key
                set title 'R of '.u offset 0, -0.5
                set xlabel header(main, 1)
                set ylabel header(main, 2)
                a1 = span(main, header(main, 1), '1', 0, -1); b1 = span(main, header(main, 1), '1', 1, 1)
                a2 = span(main, header(main, 2), '1', 0, -1); b2 = span(main, header(main, 2), '1', 1, 1)
                set xrange [a1 - 0.5 * (b1 - a1) / (values(1) - 1):b1 + 0.5 * (b1 - a1) / (values(1) - 1)]
                set yrange [a2 - 0.5 * (b2 - a2) / (values(2) - 1):b2 + 0.5 * (b2 - a2) / (values(2) - 1)]
                eval quarters('x', a1, b1)
                eval quarters('y', a2, b2)
                set style fill solid noborder
                set palette defined (0 '#440154', 0.25 '#31688e', 0.5 '#218f8d', 0.75 '#35b779', 1 '#fde725')
                plot points_by(sprintf("awk -F, 'BEGIN { print \"x,y,z\" } NR > 1 && %s && $%d == %s && $%d != \"\" { print $1 \",\" $2 \",\" $%d } END { print \"\\n1e99,1e99,1\" }' '%s'", of_unknown(main, u), k + 1, last, y, y, main)) using 1:2:(0.5 * (b1 - a1) / (values(1) - 1)):(0.5 * (b2 - a2) / (values(2) - 1)):3 with boxxyerror lc palette
                eval no_heading
            }
            eval figure_done
        }
    } else {
        across = 2; down = drawn
        panel_w = 520; panel_h = 380
        foot = foot_for(shown_in_key(m), 20)
        tone(c) = m == 1 ? shade[5] : colour(c, m)
        do for [kind in terminals] {
            eval figure_of(kind, stem)
            eval heading('Radius of convergence of '.called, 'from coefficients about the start'.left_out)
            do for [p=1:drawn] {
                u = drawn_unknown(p)
                eval single_panel
                set xlabel xname
                eval rising('x', span(main, header(main, abscissa), '1', 0, -1), span(main, header(main, abscissa), '1', 1, 1))
                eval quarters('x', span(main, header(main, abscissa), '1', 0, -1), span(main, header(main, abscissa), '1', 1, 1))
                eval panel(2 * p - 1)
                set title u offset 0, -0.5
                set ylabel 'radius R / unit of the variable'
                set yrange [0:larger(1e-30, 1.1 * span(main, 'radius', of_unknown(main, u), 1, 1))]
                plot for [c=1:m] rows(main, abscissa, y, both(is_curve(c), of_unknown(main, u))) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
                eval no_heading
                eval panel(2 * p)
                set title u.': how certain' offset 0, -0.5
                set ylabel 'log_{10} (uncertainty/R)'
                eval rising('y', span(main, 'log10_relative_uncertainty', of_unknown(main, u), -1, -1), span(main, 'log10_relative_uncertainty', of_unknown(main, u), 0, 1))
                plot for [c=1:m] rows(main, abscissa, e, both(is_curve(c), of_unknown(main, u))) using 1:2 with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c)
            }
            eval key_strip
            plot for [c=1:m] NaN with linespoints lw 1.5 pt mark_of(c) ps 0.7 lc rgb tone(c) title in_key(c, m) ? curve_name(c) : ''
            eval figure_done
        }
    }
    exit
}

load scripts.'/style.gp'

file = data.'/radius_map.csv'
energies = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq", file))
orders = ask(sprintf("tail -n +2 '%s' | cut -d, -f3 | sort -nu", file))
shown = words(energies)
panels = smaller(words(orders), 3)
energy(j) = word(energies, j)
order(i) = pick(orders, 3, i)
named(j) = energy_name(energy(j), first_of(file, 19, sprintf('$1 == "%s"', energy(j))))
# "x,y" of an energy and an order if $k is not empty, where y is an expression of awk.
at(e, n, k, y) = parts_at(file, 'v($2)', y, '1 3', e.','.n, sprintf('$%d != ""', k))
height(e) = ask(sprintf("awk -F, '$1 == \"%s\" { printf \"%%.9g\", $18 / $17; exit }' '%s'", e, file)) + 0
array k[shown]
do for [j=1:shown] { k[j] = height(energy(j)) }
highest = 0
do for [j=1:shown] { highest = sqrt(1 + k[j]**2) > highest ? sqrt(1 + k[j]**2) : highest }
lowest = ask(sprintf("awk -F, 'BEGIN { l = -4 } NR > 1 && $8 != \"\" && $8 !~ /inf/ && $8 + 0 < l { l = $8 + 0 } END { print int(l) - 2 }' '%s'", file)) + 0
radius(x, h) = sqrt((1 - x)**2 + h**2)
rate(x, h) = (x > 0.5 ? x : 1 - x) / radius(x, h)
fastest = 1.2
do for [j=1:shown] { fastest = larger(fastest, larger(rate(0, k[j]), rate(1, k[j]))) }

# One row of panels per order: radius, rate and error.
across = 3; down = panels
panel_w = 407; panel_h = 350
foot = foot_for(shown_in_key(shown), 12)
do for [kind in terminals] {
    eval figure_of(kind, 'radius_map')
    eval heading('Radius of convergence about each point of the way from the top to the bottom', 'exactly (lines) and from coefficients alone (marks)')
    set xrange [-0.02:1.02]
    set samples 201
    set xlabel 'expansion point, fraction x of T*'
    set lmargin 8; set rmargin 2; set tmargin 2.2; set bmargin 3.6
    unset key
    do for [i=1:panels] {
        n = order(i)
        eval panel(3 * i - 2)
        set title 'N = '.n.': radius'
        set ylabel 'R/T*' offset 1.5
        set yrange [0:highest * 1.15]
        plot for [j=1:shown] [0:1] radius(x, k[j]) with lines lw 1.8 dt line_of(j) lc rgb colour(j, shown) notitle, \
             for [j=1:shown] at(energy(j), n, 4, '$4 / $17') using 1:2 with points pt mark_of(j) ps 0.8 lw 1.3 lc rgb colour(j, shown) notitle
        eval no_heading
        eval panel(3 * i - 1)
        set title 'N = '.n.': rate on [0, T*]'
        set ylabel 'max(x, 1 − x) T*/R' offset 1
        set yrange [0:1.07 * fastest]
        set arrow 1 from 0.5, graph 0 to 0.5, graph 1 nohead lc rgb '#888888' dt 3
        set label 2 'above 1: diverges at an end' at graph 0.03, graph 0.95 textcolor rgb soft
        set arrow 2 from graph 0, first 1 to graph 1, first 1 nohead lc rgb '#888888' lw 1
        plot for [j=1:shown] [0:1] rate(x, k[j]) with lines lw 1.8 dt line_of(j) lc rgb colour(j, shown) notitle, \
             for [j=1:shown] at(energy(j), n, 16, '$16') using 1:2 with points pt mark_of(j) ps 0.8 lw 1.3 lc rgb colour(j, shown) notitle
        unset arrow; unset label 2
        eval panel(3 * i)
        set title 'N = '.n.': relative error of R'
        set ylabel 'log_{10} |R estimated/R − 1|' offset 0
        set yrange [lowest:1]
        plot for [j=1:shown] at(energy(j), n, 8, sprintf('$8 ~ /inf/ ? %g : $8', lowest)) using 1:2 with points pt mark_of(j) ps 0.8 lw 1.3 lc rgb colour(j, shown) notitle
    }
    eval key_strip
    plot for [j=1:shown] NaN with linespoints lw 1.8 dt line_of(j) pt mark_of(j) ps 0.8 lc rgb colour(j, shown) title in_key(j, shown) ? 'E = '.named(j) : ''
    eval figure_done
}
