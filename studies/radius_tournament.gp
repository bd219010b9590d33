# radius_tournament: correct digits by method, order and scalar, ranked; and the fraction of errors that are within the
# uncertainties. Columns: radius_tournament_ranking:
# order,scalar,rank,method,problems,answers,mean_digits,median_digits,
# covered,median_uncertainty_over_error,false_answers; radius_tournament_coverage: half,scalar,method,answers,covered,
# median_uncertainty_over_error.
#
# For any equation: the distance of each test from the proved radius, or from the verdict for a longer list, against the
# order; one panel per unknown, for the first combination of the parameters.
# Columns: <axes>,order,method,radius,uncertainty,difference,log10_difference,note,truth,unknown.
if (equation ne '') {
    load scripts.'/shared/panels.gp'

    eval axes_before('order')
    methods = seen(main, k + 2, '1')
    n = words(methods)
    y = place(main, 'log10_difference')
    curve(u, m) = both(both(in_case(word(all, 1)), of_unknown(main, u)), with_word(main, 'method', m))
    tone(i) = i == 1 ? '#000000' : colour(i, larger(n, 7))
    eval grid(drawn, 3)
    foot = foot_for(n, 26)
    bottom = span(main, 'log10_difference', '1', -1, -1)
    do for [kind in terminals] {
        eval figure_of(kind, stem)
        eval heading('Radius tests on '.called, '|R of the test/R − 1| over the order'.(word(all, 1) eq '-' ? '' : ', '.case_name(main, k, word(all, 1))).left_out)
        do for [p=1:drawn] {
            eval panel_of_unknown(p)
            set title u.': against R '.(count_of(main, both(of_unknown(main, u), with_word(main, 'truth', 'verdict'))) ? 'of a longer list' : first_of(main, place(main, 'truth'), both(of_unknown(main, u), '1'))) offset 0, -0.5
            set xlabel 'order N'
            set ylabel 'log_{10} |R of the test/R − 1|'
            eval rising('x', span(main, 'order', '1', 0, -1), span(main, 'order', '1', 1, 1))
            set yrange [bottom - 1:1]
            plot for [i=1:n] rows(main, k + 1, y, curve(u, word(methods, i))) using 1:2 with linespoints lw i == 1 ? 2.6 : 1.2 dt 1 pt mark_of(i) ps 0.6 lc rgb tone(i)
            eval no_heading
        }
        eval key_strip
        plot for [i=1:n] NaN with linespoints lw i == 1 ? 2.6 : 1.2 pt mark_of(i) ps 0.7 lc rgb tone(i) title test_name(word(methods, i))
        eval figure_done
    }
    exit
}

load scripts.'/style.gp'

ranking = data.'/radius_tournament_ranking.csv'
coverage = data.'/radius_tournament_coverage.csv'
scalars = ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | awk '!seen[$0]++'", ranking))
orders = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | sort -n | uniq", ranking))
last_scalar = word(scalars, words(scalars))
last_order = word(orders, words(orders))
# The methods from the best to the worst, by the last scalar and the largest order.
methods = ask(sprintf("awk -F, '$1 == \"%s\" && $2 == \"%s\" { print $3, $4 }' '%s' | sort -n | cut -d' ' -f2", last_order, last_scalar, ranking))
count = words(methods)
place(m) = sum [i=1:count] (word(methods, i) eq m ? count + 1 - i : 0)
of(s, n, y) = strcol(2) eq s && strcol(1) eq n ? y : NaN
half(s, y) = strcol(1) eq 'judged' && strcol(2) eq s && strcol(3) ne 'all' ? y : NaN
array mark[6] = [4, 8, 6, 12, 10, 2]
tint(k) = colour(k, words(orders))
panels = words(scalars) + 1
# Three strips: heading, key of the orders, and key of the right panel with the axis.
left = 0.2
wide_of_panel = (0.985 - left) / panels
middle = wide_of_panel * words(scalars) + left

do for [kind in terminals] {
    eval use_terminal(kind, target.'/radius_tournament', 1280, 90 + 38 * count + 130)
    set multiplot
    set label 1 'Radius of convergence from coefficients alone: a tournament of tests' at screen 0.5, 0.97 center font ',16'
    set yrange [0.4:count + 0.6]
    set border 1 lc rgb '#444444'
    set grid noxtics ytics lc rgb '#eeeeee' lw 1
    set tmargin at screen 0.87
    set bmargin at screen 0.21
    unset key
    do for [p=1:words(scalars)] {
        s = word(scalars, p)
        set lmargin at screen left + (p - 1) * wide_of_panel
        set rmargin at screen left + p * wide_of_panel - 0.02
        unset ytics
        if (p == 1) { do for [i=1:count] { set ytics add (test_name(word(methods, i)) count + 1 - i) scale 0 } }
        if (p > 1) { do for [i=1:count] { set ytics add ('' count + 1 - i) scale 0 } }
        most = real(ask(sprintf("awk -F, '$2 == \"%s\" { print $7 }' '%s' | sort -g | tail -n 1", s, ranking)))
        set xrange [0:most * 1.06 + 0.5]
        set xlabel 'correct digits, mean'
        set label 4 (p == 1 ? 'in ' : '').arithmetic_name(s) at graph 0, 1.03 left textcolor rgb '#222222'
        if (p == 1) { set key at screen left + wide_of_panel, 0.055 center horizontal samplen 1 width 1 font ',14' title '' }
        plot for [k=1:words(orders)] ranking using (of(s, word(orders, k), column(7))):(place(strcol(4))) with points pt mark_of(k) ps 1.1 lw 1.8 lc rgb tint(k) title in_key(k, words(orders)) ? 'N = '.word(orders, k) : ''
        unset label 1
        unset key
    }
    set lmargin at screen middle
    set rmargin at screen 0.985
    unset ytics
    do for [i=1:count] { set ytics add ('' count + 1 - i) scale 0 }
    set xrange [0.78:1.01]
    set xtics 0.8, 0.05, 1
    set xlabel 'errors within the uncertainty'
    set arrow 1 from 0.95, graph 0 to 0.95, graph 1 nohead lc rgb '#888888' dt 3
    set label 2 'required: 0.95' at 1.01, graph 1.03 right textcolor rgb '#555555' font ',13'
    set label 3 "median of\nuncertainty/error" at 0.785, graph 1.055 left textcolor rgb '#555555' font ',13'
    unset label 4
    near(x) = x < 0.825 ? 0.825 : x
    set key at screen (middle + 0.985) / 2, 0.055 center horizontal samplen 1 width 1 font ',14'
    plot for [p=1:words(scalars)] coverage using (half(word(scalars, p), near(column(5)))):(place(strcol(3))) with points pt (p == words(scalars) ? 7 : 6) ps (p == words(scalars) ? 1.1 : 1.6) lw 1.5 lc rgb shade[p == words(scalars) ? 5 : 4] title arithmetic_name(word(scalars, p)), \
         coverage using (half(last_scalar, 0.8)):(place(strcol(3))):(sprintf('%.3g', column(6))) with labels font ',13' textcolor rgb '#333333' notitle
    eval figure_done
}
