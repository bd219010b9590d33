# series: the accuracy of a list of coefficients as a function. Columns of errors: time,method,order,error,log10_error;
# of poles: kind,position_re,position_im,modulus,distance; of ratios:
# n,inverse_n,ratio,root,corrected_root,power,ratio_in_power,pair_ratio; of the radius: method,radius,uncertainty,...
load scripts.'/style.gp'

errors = data.'/errors.csv'
poles = data.'/poles.csv'
ratios = data.'/ratios.csv'
rows_in(file) = ask(sprintf("tail -n +2 '%s' | wc -l", file)) + 0
# "x,y" of the rows that satisfy a condition of awk; then a point outside the range, as gnuplot warns of empty files.
points(file, condition, x, y) = points_by(sprintf("awk -F, 'BEGIN {print \"x,y\"} NR > 1 && %s && $%d != \"\" && $%d !~ /inf/ {print $%d \",\" $%d} END {print \"\\n1e300,1e300\"}' '%s'", condition, y, y, x, y, file))
values_in(file, column) = ask(sprintf("tail -n +2 '%s' | cut -d, -f%d | awk '!seen[$0]++'", file, column))
extent(file, column) = ask(sprintf("awk -F, 'NR > 1 && $%d != \"\" { x = $%d < 0 ? -$%d : $%d; if (x + 0 > m) m = x + 0 } END { print (m > 0 ? m : 1) }' '%s'", column, column, column, column, file)) + 0.0
shorter(s) = number_name(s)
tint(j) = shade[(j - 1) % 6 + 1]

load scripts.'/shared/ratio_fit.gp'
test_cell(m, c) = ask(sprintf("awk -F, -v m='%s' -v c='%s' 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == c) k = i } NR > 1 && $1 == m { print $k; exit }' '%s/radius.csv'", m, c, data))
named = ''
pade_order = ''

do for [kind in terminals] {
    do for [part in 'ratios roots poles'] {
        drawn = part eq 'poles' ? rows_in(poles) > 0 : part eq 'roots' || count_of(ratios, '$7 != "" && v($7) != 0') > 0
        if (drawn) {
            eval use_terminal(kind, target.'/'.(part eq 'ratios' ? 'domb_sykes' : part), part eq 'poles' ? 700 : 720, part eq 'poles' ? 580 : 480)
            set lmargin 12; set rmargin 3; set bmargin 3.6
            load scripts.'/shared/coefficient_panel.gp'
            unset output
            eval restart
        }
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
            set ylabel 'log_{10} |value − reference|'
            plot for [j=1:shown] points(errors, sprintf('$2 == "%s" && $1 == "%s"', m, time_of(j)), 3, 5) using 1:2 with linespoints pt 6 ps 0.6 lw 1.5 lc rgb tint(j) title 't = '.shorter(time_of(j))
        }
        unset multiplot
        unset output
    }
}
