# sir_radius: the radius of convergence of SIR against the reproduction number, one curve per number of infected, with
# the time of the peak.
# Columns: reproduction,infected,radius,position_re,position_im,peak,lower,upper,verdict.
load scripts.'/style.gp'

main = data.'/sir_radius.csv'
starts = sorted(main, 2, '1')
n = words(starts)
at(i) = sprintf('$2 == "%s"', word(starts, i))
marks = sorted(main, 1, '1')
low = least(main, '1', '1', 1); high = greatest(main, '1', '1', 2)
top = greatest(main, '3', '1', 1); bottom = least(main, '3', '1', 0.1)

eval grid(1, 1)
panel_w = 900
panel_h = 520
foot = foot_for(n + 2, 22)
do for [kind in terminals] {
    eval figure_of(kind, 'sir_radius')
    eval heading('The radius of convergence of SIR', 'by quadrature, each point between proved bounds that agree to 8 digits')
    eval panel(1)
    set lmargin 10; set rmargin 4; set tmargin 1; set bmargin 3.6
    set logscale xy
    set xrange [low / 1.15:high * 1.15]
    set yrange [bottom / 1.5:top * 1.6]
    set xlabel 'reproduction number r S(0) / a'
    set ylabel 'time a t'
    set xtics (low low, high high); do for [k=1:words(marks)] { eval 'set xtics add ('.word(marks, k).')' }
    set ytics autofreq
    unset key
    plot for [i=1:n] rows(main, 1, 3, at(i)) using 1:2 with linespoints pt 7 ps 0.6 lw 1.8 lc rgb colour(i, n), \
         for [i=1:n] rows(main, 1, 6, at(i).' && v($6) > 0') using 1:2 with lines dt 2 lw 1.4 lc rgb colour(i, n)
    eval no_heading
    eval key_strip
    plot for [i=1:n] NaN with linespoints pt 7 ps 0.6 lw 1.8 lc rgb colour(i, n) title 'r I(0)/a = '.number_name(word(starts, i)), \
         NaN with lines lw 1.8 lc rgb soft title 'radius', NaN with lines dt 2 lw 1.4 lc rgb soft title 'time of the peak'
    eval figure_done
}
