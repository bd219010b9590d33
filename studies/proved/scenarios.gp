# scenarios: the nearest singularity of each problem in units of its radius of convergence, by its argument.
# Columns: problem,lower,upper,domain,scenario,position_re,position_im,kind,rigour,reason.
load scripts.'/style.gp'

main = data.'/scenarios.csv'
count = count_of(main, '1')
verdicts = 'larger equal within'
letters = 'larger than the domain|equal to it|within it'
# The argument of the nearest singularity in degrees, 0 ahead and 180 behind; -20 if there is none.
angles(v) = points_by("awk -F, 'BEGIN { print \"x,y\" } NR > 1 { ++n; if ($5 == \"".v."\") print ($6 == \"\" ? -20 : (atan2($7 < 0 ? -$7 : $7, $6) * 180 / 3.14159265358979)) \",\" n } END { print \"1e99,1e99\" }' '".main."'")
labels = points_by("awk -F, 'BEGIN { print \"y,name\" } NR > 1 { ++n; print n \",\" $1 (($5 == \"\") ? \" (no verdict)\" : \"\") }' '".main."'")

eval grid(1, 1)
panel_w = 900
panel_h = 110 + 17 * count
foot = foot_for(3, 26)
do for [kind in terminals] {
    eval figure_of(kind, 'scenarios')
    eval heading('The three scenarios', 'argument of the nearest singularity as seen from the start, in degrees: at 0 the solution ends there')
    set lmargin 34; set rmargin 4; set tmargin 2; set bmargin 3.6
    eval panel(1)
    set xrange [-35:190]
    set yrange [count + 1:0]
    set xtics ('none' -20, '0' 0, '45' 45, '90' 90, '135' 135, '180' 180)
    set xlabel 'argument of the nearest singularity / degrees'
    set ytics scale 0 noenhanced font ',10'
    unset key
    plot labels using (1e99):1:ytic(2) with points pt 0, \
         for [i=1:3] angles(word(verdicts, i)) using 1:2 with points pt mark[i] ps 1 lw 1.6 lc rgb shade[2 * i - 1]
    eval no_heading
    eval key_strip
    plot for [i=1:3] NaN with points pt mark[i] ps 1 lw 1.6 lc rgb shade[2 * i - 1] title 'radius '.ask(sprintf("printf '%%s' '%s' | cut -d'|' -f%d", letters, i))
    eval figure_done
}
