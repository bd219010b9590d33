# series: the accuracy of a list of coefficients as a function. Columns of errors: time,method,order,error,log10_error;
# of poles: kind,position_re,position_im,modulus,distance; of ratios:
# n,inverse_n,ratio,root,corrected_root,power,ratio_in_power.
load scripts.'/style.gp'

errors = data.'/errors.csv'
poles = data.'/poles.csv'
ratios = data.'/ratios.csv'
rows_in(file) = ask(sprintf("tail -n +2 '%s' | wc -l", file)) + 0
# "x,y" of the rows that satisfy a condition of awk; then a point outside the range, as gnuplot warns of empty files.
points(file, condition, x, y) = points_by(sprintf("awk -F, 'BEGIN {print \"x,y\"} NR > 1 && %s && $%d != \"\" && $%d !~ /inf/ {print $%d \",\" $%d} END {print \"\\n1e300,1e300\"}' '%s'", condition, y, y, x, y, file))
values_in(file, column) = ask(sprintf("tail -n +2 '%s' | cut -d, -f%d | awk '!seen[$0]++'", file, column))
extent(file, column) = ask(sprintf("awk -F, 'NR > 1 && $%d != \"\" { x = $%d < 0 ? -$%d : $%d; if (x + 0 > m) m = x + 0 } END { print (m > 0 ? m : 1) }' '%s'", column, column, column, column, file)) + 0.0
shorter(s) = strlen(s) > 10 ? s[1:10].'...' : s
tint(j) = shade[(j - 1) % 6 + 1]

do for [kind in terminals] {
    # If symmetry makes coefficients 0, in the power of t that it leaves.
    power = first_of(ratios, 6, '1') + 0
    if (count_of(ratios, '$7 != "" && v($7) != 0') > 0) {
        eval use_terminal(kind, target.'/domb_sykes', 720, 480)
        set title 'Ratios of '.(power > 1 ? sprintf('the coefficients in t^{%d}', power) : 'successive coefficients').' over 1/n: a straight line for a single nearest singularity'
        set xlabel '1/n'
        set ylabel power > 1 ? sprintf('a_n/a_{n-%d}', power) : 'a_n/a_{n-1}'
        set xrange [0:*]
        set autoscale y
        set offsets graph 0, graph 0, graph 0.05, graph 0.05
        unset key
        plot points_by('tail -n +2 '.ratios.' | awk -F, ''BEGIN {print "x,y"} $7 != "" {print $2 "," $7}''') using 1:2 with points pt 6 ps 0.7 lc rgb shade[5] notitle
        unset output
    }

    eval use_terminal(kind, target.'/roots', 720, 480)
    set title 'Roots of the coefficients over 1/n: they reach 1/R at 1/n = 0'
    set xlabel '1/n'
    set xrange [0:*]
    set autoscale y
    set offsets graph 0, graph 0, graph 0.05, graph 0.05
    set ylabel 'n-th root'
    set key top left
    plot points_by('tail -n +2 '.ratios.' | awk -F, ''BEGIN {print "x,y"} $4 != "" {print $2 "," $4}''') using 1:2 with points pt 6 ps 0.7 lc rgb shade[5] title '|a_n|^{1/n}', \
         points_by('tail -n +2 '.ratios.' | awk -F, ''BEGIN {print "x,y"} $5 != "" {print $2 "," $5}''') using 1:2 with points pt 4 ps 0.7 lc rgb shade[4] title '|n a_n|^{1/n}'
    unset output

    if (rows_in(poles) > 0) {
        # Up to four times the nearest nonzero pole or zero: distant ones are meaningless.
        near = 4 * least(poles, '4', 'v($4) > 0', 1)
        eval use_terminal(kind, target.'/poles', 620, 580)
        set title 'Poles and zeros of the Padé approximant'
        set xlabel 'Re t'
        set ylabel 'Im t'
        set xrange [-near:near]
        set yrange [-near:near]
        set size ratio -1
        set key top right
        plot points(poles, '$1 == "pole"', 2, 3) using 1:2 with points pt 2 ps 1 lw 1.5 lc rgb shade[4] title 'poles', \
             points(poles, '$1 == "pole" && $3 + 0 > 0', 2, 3) using 1:(-$2) with points pt 2 ps 1 lw 1.5 lc rgb shade[4] notitle, \
             points(poles, '$1 == "zero"', 2, 3) using 1:2 with points pt 6 ps 1 lw 1.5 lc rgb shade[5] title 'zeros', \
             points(poles, '$1 == "zero" && $3 + 0 > 0', 2, 3) using 1:(-$2) with points pt 6 ps 1 lw 1.5 lc rgb shade[5] notitle
        set size noratio
        unset output
    }

    if (rows_in(errors) > 0) {
        methods = values_in(errors, 2)
        # Six of the times with an error, from the first to the last.
        times = seen(errors, 1, '$5 !~ /inf/')
        shown = words(times) < 6 ? words(times) : 6
        time_of(j) = word(times, shown < 2 ? 1 : 1 + int((j - 1) * (words(times) - 1.0) / (shown - 1) + 0.5))
        eval use_terminal(kind, target.'/errors', 420 * words(methods) + 120, 480)
        set multiplot layout 1, words(methods)
        set xrange [0:extent(errors, 3) * 1.05]
        set yrange [*:*]
        low = ask(sprintf("awk -F, 'BEGIN { m = 0 } NR > 1 && $5 !~ /inf/ && $5 + 0 < m { m = $5 + 0 } END { print m - 1 }' '%s'", errors)) + 0.0
        high = ask(sprintf("awk -F, 'BEGIN { m = 0 } NR > 1 && $5 !~ /inf/ && $5 + 0 > m { m = $5 + 0 } END { print m + 1 }' '%s'", errors)) + 0.0
        set yrange [low:high]
        set xlabel 'order N'
        set key bottom left
        do for [m in methods] {
            set title 'Error of '.(m eq 'pade' ? 'Padé approximants' : m eq 'series' ? 'partial sums' : m.' approximants')
            set ylabel 'log_{10} |value - reference|'
            plot for [j=1:shown] points(errors, sprintf('$2 == "%s" && $1 == "%s"', m, time_of(j)), 3, 5) using 1:2 with linespoints pt 6 ps 0.6 lw 1.5 lc rgb tint(j) title 't = '.shorter(time_of(j))
        }
        unset multiplot
        unset output
    }
}
