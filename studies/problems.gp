# problems: small panels, one per problem of the catalogue: its solution, the size of its coefficients, and its nearest
# singularities around the initial point.
# Columns: problem,time,value,unknown; in _coefficients problem,n,log10_abs,unknown; in _singularities problem,radius,
# uncertainty,log10_relative_uncertainty,position_re,position_im,kind,exponent,count,note,unknown.
load scripts.'/style.gp'

main = data.'/problems.csv'
sizes = data.'/problems_coefficients.csv'
nearest = data.'/problems_singularities.csv'
names = seen(main, 1, '1')
count = words(names)
unknowns_of(name) = seen(nearest, 11, sprintf('$1 == "%s"', name))
of(name, c, u) = sprintf('$1 == "%s" && $%d == "%s"', name, c, u)
across = count < 6 ? count : 6
down = (count + across - 1) / across
panel_w = across < 3 ? 420 : 250
panel_h = across < 3 ? 300 : 190
foot = 26
small = "set lmargin 6; set rmargin 1.5; set tmargin 1.8; set bmargin 2; unset key; set xtics font ',9'; set ytics font ',9'; set grid ytics"
# At most six curves per panel.
shown(list) = smaller(words(list), 6)

do for [kind in terminals] {
    eval figure_of(kind, 'problems')
    eval heading('Solutions of the catalogue', 'each unknown from the start on, over its variable; six at most')
    do for [p=1:count] {
        name = word(names, p)
        list = unknowns_of(name)
        eval panel(p)
        eval small
        set title problem_name(name) font ',11' offset 0, -0.6
        eval rising('x', least(main, '2', sprintf('$1 == "%s"', name), 0), greatest(main, '2', sprintf('$1 == "%s"', name), 1))
        eval rising('y', least(main, '3', sprintf('$1 == "%s"', name), 0), greatest(main, '3', sprintf('$1 == "%s"', name), 1))
        set xtics autofreq; set xtics (least(main, '2', sprintf('$1 == "%s"', name), 0), greatest(main, '2', sprintf('$1 == "%s"', name), 1)) format '%.3g'
        set ytics format '%.2g'
        plot for [i=1:shown(list)] rows(main, 2, 3, of(name, 4, word(list, i))) using 1:2 with lines lw 1.5 lc rgb shade[i]
        eval no_heading
    }
    eval figure_done
    eval figure_of(kind, 'problems_coefficients')
    eval heading('Coefficients of the catalogue', 'log_{10} |a_n| over n, about the start')
    do for [p=1:count] {
        name = word(names, p)
        list = unknowns_of(name)
        eval panel(p)
        eval small
        set title problem_name(name) font ',11' offset 0, -0.6
        eval rising('x', 0, greatest(sizes, '2', sprintf('$1 == "%s"', name), 1))
        eval rising('y', least(sizes, '3', sprintf('$1 == "%s"', name), -1), greatest(sizes, '3', sprintf('$1 == "%s"', name), 1))
        plot for [i=1:shown(list)] rows(sizes, 2, 3, of(name, 4, word(list, i))) using 1:2 with points pt 7 ps 0.25 lc rgb shade[i]
        eval no_heading
    }
    eval figure_done
    eval figure_of(kind, 'problems_singularities')
    eval heading('Nearest singularities of the catalogue', 'in the complex plane of the distance from the start, by radius tests (heuristic); the circle is that of convergence')
    do for [p=1:count] {
        name = word(names, p)
        list = unknowns_of(name)
        r = least(nearest, '2', sprintf('$1 == "%s"', name), 0)
        eval panel(p)
        eval small
        set title problem_name(name) font ',11' offset 0, -0.6
        if (r > 0) {
            far = larger(r, smaller(3 * r, greatest(nearest, '2', sprintf('$1 == "%s"', name), r)))
            set size ratio -1
            set xrange [-1.25 * far:1.25 * far]
            set yrange [-1.25 * far:1.25 * far]
            set xtics (0) ; set xtics add (sprintf('%.3g', r) r)
            set ytics (0)
            set parametric
            set trange [0:2 * pi]
            plot r * cos(t), r * sin(t) with lines lw 1 lc rgb '#999999', \
                 for [i=1:shown(list)] for [side in '1 -1'] rows(nearest, 5, 6, of(name, 11, word(list, i))) using 1:($2 * (side + 0)) with points pt mark[i] ps 0.8 lw 1.2 lc rgb shade[i]
            unset parametric
            set size noratio
        } else {
            set xrange [-1:1]; set yrange [-1:1]; set xtics (0); set ytics (0)
            set label 7 'no radius seen' at 0, 0.3 center textcolor rgb soft font ',10'
            plot NaN
            unset label 7
        }
        eval no_heading
    }
    eval figure_done
}
