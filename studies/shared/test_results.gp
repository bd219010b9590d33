# What radius tests make of lists of the pendulum's coefficients, against the order: one row per expansion point, one
# column per method, one curve per energy. Before it is loaded: the table `answers` (energy,point,order,method,radius,
# uncertainty,exact,relative_error,log10_relative_error,log10_relative_uncertainty,note), `figure`, `listed` (methods),
# `results_title`, `results_axis`, floor_of(m) and top_of(m) for the panels of a method, `with_uncertainties`, and of the
# first figure `down`, `shown`, point(q), energy(j) and named(j).
eval restart
methods = ''
do for [m in listed] { if (count_of(answers, sprintf('$4 == "%s" && $9 != ""', m)) > 0) { methods = methods.' '.m } }
columns = words(methods)
brief(p) = p eq '0' ? 'Top' : p eq '1' ? 'Bottom' : p.' T*'
newest = greatest(answers, '3', '1', 0)
# Column k against the order, 0 drawn at the floor.
answer(m, p, e, k, low) = parts_at(answers, '$3', sprintf('($%d ~ /inf/ ? %g : $%d)', k, low, k), '1 2 4', e.','.p.','.m, sprintf('$%d != ""', k))
given(m, p) = cell_at(answers, 9, '2 4', p.','.m, '1') ne ''
# A step of 1, 2 or 5 times a power of ten for about four tics.
tic_step(most) = (d = 10.0**floor(log10(most / 4.0)), r = most / 4.0 / d, d * (r < 2 ? 1 : r < 5 ? 2 : 5))
uncertainties = 'for [j=1:shown] answer(m, p, energy(j), 10, low) using 1:2 with lines lw 1 dt 3 lc rgb colour(j, shown) notitle'
errors = 'for [j=1:shown] answer(m, p, energy(j), 9, low) using 1:2 with linespoints lw 1.8 dt line_of(j) pt mark_of(j) ps 0.8 lc rgb colour(j, shown) notitle'
across = columns
head = 62
panel_w = columns < 3 ? 460 : 330; panel_h = 300
foot = foot_for(shown_in_key(shown), 14)
do for [kind in terminals] {
    eval figure_of(kind, figure)
    eval heading(results_title, ' ')
    set xrange [0:newest * 1.04]
    set xtics tic_step(newest)
    set xlabel 'order N'
    set lmargin 8; set rmargin 1.5; set tmargin 2.2; set bmargin 3.6
    unset key
    do for [q=1:down] {
        p = point(q)
        do for [i=1:columns] {
            m = word(methods, i)
            low = floor_of(m)
            eval panel((q - 1) * columns + i)
            set yrange [low:top_of(m)]
            set title brief(p).': '.test_name(m)
            if (i == 1) { set ylabel results_axis } else { unset ylabel }
            if (!given(m, p)) { set label 2 "does not apply\nto these lists" at graph 0.5, 0.55 center textcolor rgb soft }
            eval 'plot '.(with_uncertainties ? uncertainties.', ' : '').errors
            eval no_heading
            unset label 2
        }
    }
    eval key_strip
    plot for [j=1:shown] NaN with linespoints lw 1.8 dt line_of(j) pt mark_of(j) ps 0.8 lc rgb colour(j, shown) title in_key(j, shown) ? 'E = '.named(j) : ''
    eval figure_done
}
