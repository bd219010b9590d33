# stiff: the proved digits, the seconds, and the quotient of explicit and used steps, against the time reached.
# Columns: problem,time,digits,steps,log10_explicit_steps,log10_ratio,rigour. stiff_time: problem,time,seconds.
load scripts.'/style.gp'

main = data.'/stiff.csv'
timed = data.'/stiff_time.csv'
problems = seen(main, 1, '1')
n = words(problems)
of(p) = sprintf('$1 == "%s"', p)
# Both coordinates by awk, as the times extend over many powers of 10.
curve(file, p, y) = parts_at(file, 'log(v($2))/log(10)', y, '1', p, '1')
seconds = '($3 > 0 ? log($3)/log(10) : -3)'
times = extremes(main, '2', '1')
left = floor(log10(extreme(times, 1, 1)))
right = ceil(log10(extreme(times, 2, 10)))

across = 3; down = 1
panel_w = 400
panel_h = 400
foot = foot_for(n, 16)
do for [kind in terminals] {
    eval figure_of(kind, 'stiff')
    eval heading('Stiff problems followed with proof', 'against the time that is reached, on a scale of powers of 10')
    set lmargin 8; set rmargin 2; set tmargin 2.6; set bmargin 3.6
    unset key
    set xlabel 'log_{10} of the time'
    set xrange [left:right]
    eval panel(1)
    set title 'proved digits' offset 0, -0.5
    set yrange [0:5 * ceil(greatest(main, '3', '1', 30) / 5 + 0.2)]
    plot for [i=1:n] curve(main, word(problems, i), '$3') using 1:2 with linespoints lw 1.8 pt mark_of(i) ps 0.7 lc rgb colour(i, n)
    eval no_heading
    eval panel(2)
    set title 'log_{10} of the seconds' offset 0, -0.5
    set yrange [-3:ceil(log10(larger(greatest(timed, '3', '1', 1), 1)) + 0.2)]
    plot for [i=1:n] curve(timed, word(problems, i), seconds) using 1:2 with linespoints lw 1.8 pt mark_of(i) ps 0.7 lc rgb colour(i, n)
    eval panel(3)
    set title 'log_{10} (explicit steps / steps)' offset 0, -0.5
    set yrange [-0.5:ceil(larger(greatest(main, '6', '1', 1), 1)) + 0.5]
    plot for [i=1:n] curve(main, word(problems, i), '$6') using 1:2 with linespoints lw 1.8 pt mark_of(i) ps 0.7 lc rgb colour(i, n)
    eval key_strip
    plot for [i=1:n] NaN with linespoints lw 1.8 pt mark_of(i) ps 0.7 lc rgb colour(i, n) title problem_name(word(problems, i))
    eval figure_done
}
