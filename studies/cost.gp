# cost: multiplications and time of each route against the order, and the differences between the routes.
# Columns: route,order,energy,multiplications,nonzero_multiplications,divisions,additions,by_integers,ratio,
# log10_difference,expected_growth,note. cost_time: route,order,energy,seconds,ratio.
#
# For any equation: multiplications and seconds against the order, for the first combination of the parameters.
# Columns: <axes>,order,route,multiplications,nonzero_multiplications,...; in _time order,route,scalar,seconds,...
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    times = table_of('_time')
    eval axes_before('order')
    routes = seen(main, k + 2, '1')
    scalars = seen(times, k + 3, '1')
    curve(f, r) = both(in_case(word(all, 1)), with_word(f, 'route', r))
    across = 2; down = 1
    panel_w = 520
    foot = foot_for(1 + words(scalars) * words(routes), 18)
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Cost of the coefficients of '.called, 'all unknowns up to the order'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))))
        eval single_panel
        set xlabel 'order N'
        set logscale x
        set xtics ()
        do for [N in sorted(main, k + 1, '1')] { set xtics add (N N + 0) }
        set xrange [span(main, 'order', '1', 1, -1) / 1.2:span(main, 'order', '1', 1, 1) * 1.2]
        eval panel(1)
        set title 'multiplications' offset 0, -0.5
        set ylabel 'multiplications / N^2'
        set yrange [0:1.2 * number(ask(sprintf("awk -F, 'NR > 1 { q = $%d / $%d ^ 2; if (q > m) m = q } END { print m + 1e-9 }' '%s'", k + 4, k + 1, main)))]
        plot for [i=1:words(routes)] rows(main, k + 1, k + 4, curve(main, word(routes, i))) using ($1 > 1e9 ? NaN : $1):($1 > 1e9 ? NaN : $2 / $1**2) with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb '#000000'
        eval no_heading
        eval panel(2)
        set title 'time' offset 0, -0.5
        set ylabel 'log_{10} (time / s)'
        set yrange [span(times, 'log10_seconds', '1', -6, -1) - 0.5:span(times, 'log10_seconds', '1', 0, 1) + 0.5]
        plot for [s=1:words(scalars)] for [i=1:words(routes)] rows(times, k + 1, place(times, 'log10_seconds'), both(curve(times, word(routes, i)), with_word(times, 'scalar', word(scalars, s)))) using 1:2 with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb shade[s + 2]
        eval key_strip
        plot for [i=1:words(routes)] NaN with linespoints lw 1.8 dt i pt mark[i] ps 0.8 lc rgb '#000000' title 'about the '.word(routes, i), \
             for [s=1:words(scalars)] NaN with lines lw 2.4 lc rgb shade[s + 2] title arithmetic_name(word(scalars, s))
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

file = data.'/cost.csv'
timed = data.'/cost_time.csv'
routes = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | awk '!seen[$0]++'", file))
# The energy with the most routes, the first if there are several.
energy = ask(sprintf("awk -F, 'NR > 1 && $4 != \"\" { if (!($3 in n)) e[++k] = $3; ++n[$3] } END { b = e[1]; for (i = 2; i <= k; ++i) if (n[e[i]] > n[b]) b = e[i]; print b }' '%s'", file))
first = real(ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | sort -n | head -n 1", file)))
last = real(ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | sort -n | tail -n 1", file)))
present = ask(sprintf("awk -F, '$3 == \"%s\" && $4 != \"\" { print $1 }' '%s' | awk '!seen[$0]++'", energy, file))
orders = ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | sort -nu", file))
# At most eight numbers on the axis.
at_axis = ''
stride = (words(orders) + 7) / 8
do for [i=1:words(orders):stride] { at_axis = at_axis.(i > 1 ? ', ' : '').word(orders, i) }
left = first > 1 ? first / 1.3 : 1
right = last > 1 ? last * 1.3 : 2
of(r, y) = (strcol(1) eq r && strcol(3) eq energy) ? y : NaN
positive(y) = y > 0 ? y : NaN
with_products = ask(sprintf("awk -F, '$3 == \"%s\" && $4 > 0 { print $1 }' '%s' | awk '!seen[$0]++'", energy, file))
# Number of products of each route in units of N^2.
constant(r) = r eq 'direct' ? 1 : r eq 'direct_parity' ? 0.5 : r eq 'arcsine' ? 1.5 : r eq 'arcsine_parity' ? 0.375 : r eq 'convolution' ? 0.5 : (r eq 'speed' || r eq 'symmetric_squares') ? 0.1875 : NaN
hue(r) = r[1:6] eq 'direct' ? shade[4] : r[1:7] eq 'arcsine' ? shade[2] : r eq 'speed' ? shade[3] : r eq 'symmetric_squares' ? shade[5] : r eq 'convolution' ? shade[1] : shade[6]
dash(r) = (strstrt(r, 'parity') || r eq 'running_sums') ? 2 : 1
mark(r) = r eq 'direct' ? 4 : r eq 'direct_parity' ? 5 : r eq 'arcsine' ? 8 : r eq 'arcsine_parity' ? 9 : r eq 'speed' ? 6 : r eq 'symmetric_squares' ? 2 : r eq 'convolution' ? 12 : r eq 'running_sums' ? 10 : 1
label_of(r) = r eq 'direct' ? 'direct recurrence' : r eq 'direct_parity' ? 'direct recurrence, parity' : r eq 'arcsine' ? 'arcsine of Jacobi' : r eq 'arcsine_parity' ? 'arcsine of Jacobi, parity' : r eq 'speed' ? 'ω alone' : r eq 'symmetric_squares' ? 'symmetric squares' : r eq 'convolution' ? 'resummation: convolution' : r eq 'running_sums' ? 'resummation: running sums' : 'resummation: α, β'
named = number_name(energy)

do for [kind in terminals] {
    eval use_terminal(kind, target.'/cost', 1180, 640)
    set multiplot
    set label 1 'What the coefficients up to the order N cost (E = '.named.')' at screen 0.5, 0.965 center font ',16'
    set logscale xy
    set format y '10^{%T}'
    set xlabel 'order N'
    eval 'set xtics ('.at_axis.')'
    set xrange [left:right]
    set origin 0, 0.17
    set size 0.5, 0.78
    set lmargin 9
    set ylabel 'multiplications of two numbers, count'
    set yrange [1:*]
    set key at screen 0.5, 0.15 center top vertical maxrows 3 samplen 2.5 font ',12'
    set label 2 'thin lines: constant · N^2' at graph 0.03, graph 0.96 textcolor rgb '#555555'
    plot for [r in with_products] file using 2:(of(r, positive(column(4)))) with linespoints lw 2 dt dash(r) pt mark(r) lc rgb hue(r) title label_of(r), \
         for [r in with_products] constant(r) * x**2 with lines lw 1 dt 3 lc rgb hue(r) notitle, \
         1/0 with linespoints lw 2 dt 2 pt 10 lc rgb hue('running_sums') title label_of('running_sums').' (none)'
    unset label 1
    unset label 2
    unset key
    set origin 0.5, 0.17
    set ylabel 'time / that of the direct recurrence'
    set format y '%g'
    set yrange [*:4]
    plot for [r in present] timed using 2:(of(r, column(5))) with linespoints lw 2 dt dash(r) pt mark(r) lc rgb hue(r)
    unset multiplot
    unset output
}

# Differences between the routes: left those that lose digits with the order, right the stable ones.
eval restart
unstable = ask(sprintf("awk -F, '$3 == \"%s\" && $11 != \"\" { print $1 }' '%s' | awk '!seen[$0]++'", energy, file))
stable = ''
is_unstable(r) = words(unstable) ? sum [i=1:words(unstable)] (word(unstable, i) eq r) : 0
do for [r in present] { if (!is_unstable(r)) { stable = stable.' '.r } }
sides = (words(unstable) > 0 ? '1 ' : '').(words(stable) > 0 ? '2' : '')
start = real(ask(sprintf("awk -F, '$3 == \"%s\" && $11 != \"\" { found = 1; print $10 - $11; exit } END { if (!found) print 0 }' '%s'", energy, file)))
eval grid(words(sides), 2)
panel_w = across == 1 ? 900 : 590
panel_h = 430
foot = foot_for(words(present) + 1, 24)
do for [kind in terminals] {
    eval figure_of(kind, 'cost_difference')
    eval heading('Rounding errors of the routes (E = '.named.')', 'the largest difference of a coefficient from its value with 30 digits more')
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    set xlabel 'order N'
    unset key
    do for [p=1:words(sides)] {
        eval panel(p)
        losing = word(sides, p) eq '1'
        listed = losing ? unstable : stable
        set title losing ? 'unstable' : 'stable' offset 0, -0.5
        if (p == 1) { set ylabel 'log_{10} (largest difference)' } else { unset ylabel }
        set xrange [0:1.04 * right / 1.3]
        which = '0'
        do for [r in listed] { which = which.sprintf(' || ($1 == "%s" && $3 == "%s")', r, energy) }
        low = least(file, '10', which, -1); high = greatest(file, '10', which, 1)
        eval rising('y', low, high)
        lines = "for [r in listed] file using 2:(of(r, column(10))) with linespoints lw 2 dt dash(r) pt mark(r) lc rgb hue(r) notitle"
        growth = ", for [r in word(unstable, 1)] file using 2:(of(r, column(11) + start)) with lines lw 1.5 dt 3 lc rgb '#000000' notitle"
        eval 'plot '.lines.(losing ? growth : '')
        eval no_heading
    }
    eval key_strip
    plot for [r in present] NaN with linespoints lw 2 dt dash(r) pt mark(r) lc rgb hue(r) title label_of(r), \
         NaN with lines lw 1.5 dt 3 lc rgb '#000000' title words(unstable) > 0 ? '(R/K̃′)^N' : ''
    eval figure_done
}
