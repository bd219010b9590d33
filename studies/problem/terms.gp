# terms: the least order for D digits against the distance of E from 2, libration left and rotation right.
# Columns: energy,gap,digits,method,order,terms,predicted,proved_order,norm,norm_before,log10_norm,log10_gap.
load scripts.'/style.gp'
tone(i) = shade[word('4 6 2 3 5 1', (i - 1)%6 + 1) + 0]     # neighbours far apart

file = data.'/terms.csv'
digits = system(sprintf("cut -d, -f3 '%s' | tail -n +2 | sort -nu", file))
rotations = int(system(sprintf("cut -d, -f2 '%s' | grep -c '^-' || true", file)))
librations = int(system(sprintf("cut -d, -f2 '%s' | tail -n +2 | grep -vc '^-' || true", file)))
highest = real(system(sprintf("cut -d, -f8 '%s' | tail -n +2 | sort -gr | sed -n 1p", file)))
closest = real(system(sprintf("cut -d, -f12 '%s' | tail -n +2 | sort -gr | tail -n 1", file)))
farthest = real(system(sprintf("cut -d, -f12 '%s' | tail -n +2 | sort -gr | sed -n 1p", file)))

of(d, method, y) = (column(3) == d && strcol(4) eq method) ? y : NaN
side(s, y) = (strcol(2)[1:1] eq '-') == (s == 2) ? y : NaN
positive(y) = y > 0 ? y : NaN
sides = (librations > 0) + (rotations > 0)
name(s) = s == 1 ? 'libration, E < 2' : 'rotation, E > 2'

do for [kind in terminals] {
    eval use_terminal(kind, target.'/terms', sides == 2 ? 1180 : 760, 600)
    set multiplot layout 1, sides title 'Powers for D digits on [0, T*]: series (dashed), resummation (solid)' font sides == 2 ? ',16' : ',14' offset 0, -0.3
    set logscale y
    set yrange [3:highest*2]
    set xrange [farthest + 0.2:closest - 0.4]
    set lmargin 11
    do for [s=1:2] {
        if ((s == 1 ? librations : rotations) > 0) {
            set title name(s) offset 0, -0.5
            set xlabel 'log_{10} |2 - E|: towards the separatrix'
            set ylabel 'order N' offset 1.5
            set key at graph 0.97, 0.04 right bottom maxrows 4
            plot for [i=1:words(digits)] file using (side(s, column(12))):(of(word(digits, i) + 0, 'series', positive(column(7)))) with lines lw 1.5 dt 3 lc rgb tone(i) notitle, \
                 for [i=1:words(digits)] file using (side(s, column(12))):(of(word(digits, i) + 0, 'series', positive(column(5)))) with linespoints pt 7 ps 0.5 lw 2 dt 2 lc rgb tone(i) notitle, \
                 for [i=1:words(digits)] file using (side(s, column(12))):(of(word(digits, i) + 0, 'resummed', positive(column(5)))) with linespoints pt 7 ps 0.5 lw 2 lc rgb tone(i) title 'D = '.word(digits, i), \
                 for [i=1:words(digits)] file using (side(s, column(12))):(of(word(digits, i) + 0, 'series', column(8))) with points pt 1 ps 0.8 lc rgb tone(i) notitle, \
                 for [i=1:words(digits)] file using (side(s, column(12))):(of(word(digits, i) + 0, 'resummed', column(8))) with points pt 2 ps 0.7 lc rgb tone(i) notitle, \
                 NaN with points pt 1 ps 0.8 lc rgb '#444444' title 'proved, series', \
                 NaN with points pt 2 ps 0.7 lc rgb '#444444' title 'proved, resummed', \
                 NaN with lines lw 1.5 dt 3 lc rgb '#444444' title 'D ln 10/ln(R/T*)'
        }
    }
    unset multiplot
    unset output
}
