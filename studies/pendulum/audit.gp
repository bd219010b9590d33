# Correct digits against the gap, one panel a time; called by audit_boost.gp and audit_gsl.gp with `name`, `library` (as
# in the CSV) and `called` (as people say it).
# Columns: gap,time,library,theta,reference,error,error_ulp,correct_digits,condition,input_ulp,own_ulp,time_in_double,
# energy, and time_typed where a time was no decimal: then a panel is a time as typed (T/16 is another time at each gap).
load scripts.'/style.gp'

file = data.'/'.name.'.csv'
typed = system(sprintf("head -n 1 '%s' | tr , '\\n' | grep -nx time_typed | cut -d: -f1", file))
place = strlen(typed) > 0 ? typed : '2'
times = system(sprintf("cut -d, -f%s '%s' | tail -n +2 | awk '!seen[$0]++'", place, file))
smallest = real(system(sprintf("cut -d, -f1 '%s' | tail -n +2 | sort -g | sed -n 1p | awk '{printf \"%%.3e\", $1}'", file)))
largest = real(system(sprintf("cut -d, -f1 '%s' | tail -n +2 | sort -g | tail -n 1 | awk '{printf \"%%.3e\", $1}'", file)))
panels = words(times)
across = panels < 3 ? panels : 3
down = (panels + across)/across       # one cell more than panels, for the key
wide(x) = 360*x + (x == 1 ? 200 : 40)

# -log10 of the gap and y of the rows of a library at a time, behind a blank line a point out of sight: gnuplot warns of a file without
# points.
rows(who, t, y) = sprintf("< awk -F, 'BEGIN {print \"x,y\"} NR > 1 && $%s == \"%s\" && $3 == \"%s\" {y = %s; print -log($1)/log(10) \",\" (y > 20 ? 20 : y)} END {print \"\\n1e9,1e9\"}' '%s'", place, t, who, y, file)
# The digits that the rounded k has lost before the library begins.
told = '($10 > 0 ? -log($10*2^-52)/log(10) : 20)'

do for [kind in terminals] {
    eval use_terminal(kind, target.'/'.name, wide(across), 330*down + 40)
    set xtics 5 nomirror out textcolor rgb '#222222'
    set ytics nomirror out textcolor rgb '#222222'
    set multiplot layout down, across title 'Correct digits of {/Symbol q} in double, from the nearest k and from the exact gap' font ',15' offset 0, -0.3
    set xrange [-log10(largest) - 0.5:-log10(smallest) + 0.5]
    set yrange [0:19]
    set lmargin 8
    do for [p=1:panels] {
        set title sprintf('t = %s', word(times, p)) offset 0, -0.5
        set xlabel '-log_{10} (2 - E)' offset 0, 0.3
        set ylabel 'correct digits' offset 0.7
        unset key
        plot 15.653559774527 with lines lw 1.3 dt 3 lc rgb '#666666', \
             rows(library, word(times, p), told) using 1:2 with lines lw 2 dt 2 lc rgb shade[6], \
             rows(library, word(times, p), '$8') using 1:2 with points pt 7 ps 0.5 lc rgb shade[4], \
             rows('libration', word(times, p), '$8') using 1:2 with points pt 6 ps 0.6 lc rgb shade[5]
    }
    unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics
    set xrange [0:1]
    set key at graph 0.95, 0.9 right top
    plot NaN with points pt 6 lc rgb shade[5] title 'ours, from the exact gap', \
         NaN with points pt 7 lc rgb shade[4] title called.', from the nearest k', \
         NaN with lines lw 2 dt 2 lc rgb shade[6] title 'what the nearest k still tells', \
         NaN with lines lw 1.3 dt 3 lc rgb '#666666' title 'one unit of double'
    set border 3 lc rgb '#444444'
    unset multiplot
    unset output
}
