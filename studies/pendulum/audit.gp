# Correct digits against the gap, one panel per time; called by audit_boost.gp and audit_gsl.gp with `name`, `library`
# (as in the CSV) and `called` (its usual name).
# Columns: gap,time,library,theta,reference,error,error_ulp,correct_digits,condition,input_ulp,own_ulp,time_in_double,
# energy, and time_typed if a time is not a decimal: then a panel is a time as typed (T/16 differs from gap to gap).
load scripts.'/style.gp'

file = data.'/'.name.'.csv'
typed = ask("head -n 1 '".file."' | tr , '\\n' | grep -nx time_typed | cut -d: -f1")
place = strlen(typed) > 0 ? int(typed + 0) : 2
times = seen(file, place, '1')
panels = smaller(words(times), 9)
# log10 of the gap and y of the rows of a library at a time, followed by a point outside the range.
digits(who, t, y) = points_by("awk -F, 'BEGIN { print \"x,y\" } NR > 1 && $".place." == \"".t."\" && $3 == \"".who."\" { y = ".y."; print log($1) / log(10) \",\" (y > 20 ? 20 : y) } END { print \"\\n1e99,1e99\" }' '".file."'")
# The digits lost by rounding k, before the library is called.
told = '($10 > 0 ? -log($10*2^-52)/log(10) : 20)'
nearest = number(ask("awk -F, 'NR > 1 { x = log($1) / log(10); if (!n++ || x < m) m = x } END { print m }' '".file."'"))
farthest = number(ask("awk -F, 'NR > 1 { x = log($1) / log(10); if (!n++ || x > m) m = x } END { print m }' '".file."'"))

eval grid(panels, 3)
panel_w = panels == 1 ? 860 : panels == 2 ? 590 : 400
panel_h = panels == 1 ? 520 : 350
foot = foot_for(4, 28)
do for [kind in terminals] {
    eval figure_of(kind, name)
    eval heading('Correct digits of θ in double, from the rounded modulus k and from the exact gap', 't = 0 at the top'.(words(times) > panels ? sprintf('; %d of %d times', panels, words(times)) : ''))
    eval falling('x', nearest, farthest)
    if (across == 3 && farthest - nearest > 10) { set xtics 5 } # steps of 2 would overlap
    set yrange [0:19]
    set ytics 0, 5
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    do for [p=1:panels] {
        t = pick(times, panels, p)
        eval panel(p)
        set title sprintf('t = %s', t).(strstrt(t, 'T') ? '' : ' (ℓ/g)^{1/2}') offset 0, -0.5
        set xlabel gap_axis
        if ((p - 1) % across == 0) { set ylabel 'correct digits' } else { unset ylabel }
        unset key
        plot 15.653559774527 with lines lw 1.3 dt 3 lc rgb '#666666', \
             digits(library, t, told) using 1:2 with linespoints lw 2 dt 2 pt 0 lc rgb shade[6], \
             digits(library, t, '$8') using 1:2 with points pt 7 ps 0.5 lc rgb shade[4], \
             digits('libration', t, '$8') using 1:2 with points pt 6 ps 0.6 lc rgb shade[5]
        eval no_heading
    }
    eval key_strip
    plot NaN with points pt 6 lc rgb shade[5] title 'Libration, from the exact gap', \
         NaN with points pt 7 lc rgb shade[4] title called.', from k rounded to double', \
         NaN with lines lw 2 dt 2 lc rgb shade[6] title 'limit due to the rounding of k', \
         NaN with lines lw 1.3 dt 3 lc rgb '#666666' title 'ε of double'
    eval figure_done
}
