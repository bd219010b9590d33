# Digits against evaluations of the right-hand side, one panel per problem, for the studies `solvers` and
# `stiff_solvers`. Columns: problem,solver,version,method, tolerance,outcome,evaluations,error,digits,unknown,time,
# rounding,rigour. Called with `stem`, the name of the files, and `solvers_called` and `times_called` for the heading.
load scripts.'/style.gp'

main = data.'/'.stem.'.csv'
problems = seen(main, 1, '1')
n = words(problems)
libraries = seen(main, 2, '$9 != ""')
methods_of(s) = seen(main, 4, sprintf('$9 != "" && $2 == "%s"', s))
of(p, s, m) = sprintf('$1 == "%s" && $2 == "%s" && $4 == "%s" && $7 > 0', p, s, m)
# All methods, as library:method, with the index of their library.
curves = ''
do for [s in libraries] { do for [m in methods_of(s)] { curves = curves.' '.s.':'.m } }
library_of(c) = c[1:strstrt(c, ':') - 1]
method_of(c) = c[strstrt(c, ':') + 1:*]
place_of(s) = sum [i=1:words(libraries)] (word(libraries, i) eq s ? i : 0)
# The index of the method within its library.
turn_of(k) = sum [i=1:k] (library_of(word(curves, i)) eq library_of(word(curves, k)) ? 1 : 0)
rounding_of(p) = number('0'.first_of(main, 12, sprintf('$1 == "%s"', p)))  # empty for stiff problems
rounded_inputs = words(seen(main, 12, '$12 != ""')) > 0
least_count = least(main, '7', '$9 != ""', 10)
largest_count = greatest(main, '7', '$9 != ""', 1e5)

eval grid(n, 4)
panel_w = n == 1 ? 860 : n == 2 ? 590 : n == 3 ? 400 : 300
panel_h = n == 1 ? 520 : 290
foot = foot_for(words(curves) + 1, 22)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading(solvers_called, 'a point for each tolerance; errors from proved values at '.times_called.' times')
    set lmargin 7; set rmargin 2; set tmargin 2; set bmargin 3.6
    set logscale x
    set format x '10^{%T}'
    set xrange [least_count / 1.5:largest_count * 1.5]
    set yrange [-1:16.5]
    set ytics 0, 5
    do for [p=1:n] {
        name = word(problems, p)
        eval panel(p)
        set title problem_name(name) offset 0, -0.5
        if (p > n - across) { set xlabel 'evaluations' } else { unset xlabel }
        if ((p - 1) % across == 0) { set ylabel 'digits' } else { unset ylabel }
        unset key
        unset arrow 1
        if (rounding_of(name) > 0) { set arrow 1 from graph 0, first -log10(rounding_of(name)) to graph 1, first -log10(rounding_of(name)) nohead dt 3 lw 1.4 lc rgb soft }
        plot for [k=1:words(curves)] rows(main, 7, 9, of(name, library_of(word(curves, k)), method_of(word(curves, k)))) using 1:2 with linespoints lw 1.3 dt turn_of(k) pt mark[turn_of(k)] ps 0.5 lc rgb shade[place_of(library_of(word(curves, k)))]
        eval no_heading
    }
    eval key_strip
    plot for [k=1:words(curves)] NaN with linespoints lw 1.6 dt turn_of(k) pt mark[turn_of(k)] ps 0.7 lc rgb shade[place_of(library_of(word(curves, k)))] title library_of(word(curves, k)).' '.method_of(word(curves, k)), \
         NaN with lines dt 3 lw 1.4 lc rgb soft title (rounded_inputs ? 'inputs in double' : '')
    eval figure_done
}
