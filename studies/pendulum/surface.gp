# surface: theta against time and energy, and the largest error over time of the paper's approximation at each energy.
# Columns: energy,time,theta,regime,method,order,period_by,approximation,error,log10_error,gap.
load scripts.'/style.gp'

file = data.'/surface.csv'
# Energies may be fractions as typed; the first method of each energy has all the angles.
number = "function number(s,f){return split(s,f,\"/\")==2?f[1]/f[2]:s+0} "
angles = "awk -F, '".number."NR>1{if($1!=e){if(NR>2)print \"\";e=$1;w=$5 FS $6 FS $7}if($5 FS $6 FS $7==w)print number($1) FS $2 FS $3 FS $4}' '".file."'"
worst(way) = "awk -F, '".number."NR>1&&$6\" \"$7==\"".way."\"&&$10!=\"-inf\"{if(!($1 in m)){o[++n]=$1;m[$1]=$10}if($10>m[$1])m[$1]=$10}END{for(i=1;i<=n;i++)print number(o[i]) FS m[o[i]]}' '".file."'"
ways = ask(sprintf("awk -F, 'NR>1&&$6!=\"\"{w=\"\\\"\" $6\" \"$7 \"\\\"\";if(!s[w]++)printf \"%%s \",w}' '%s'", file))
times = ask(sprintf("tail -n +2 '%s' | cut -d, -f2 | sort -u | wc -l", file)) + 0
energies = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | sort -u | wc -l", file)) + 0
highest = ask(angles." | awk -F, 'NF&&$3>h{h=$3}END{print h/3.14159265358979}'") + 0
edge(column, side) = ask(angles.sprintf(" | awk -F, 'NF{if(!n++||$%d>h)h=$%d;if(n==1||$%d<l)l=$%d}END{if(h==l){h+=0.5;l-=0.5}print %s}'", column, column, column, column, side)) + 0
first = edge(2, 'l'); last = edge(2, 'h')
low = edge(1, 'l'); high = edge(1, 'h')
top = highest > 12 ? 12 : (highest > 1.2 ? highest : 1.2)
# The order N of the approximations stands above the key, or in each entry if there are several.
orders = 1
do for [i=2:words(ways)] { if (word(word(ways, i), 1) ne word(word(ways, 1), 1)) { orders = 2 } }
way_name(w) = (orders > 1 ? 'N = '.word(w, 1).', ' : '').(word(w, 2) eq 'agm' ? '' : 'T*: ').rule_name(word(w, 2))
dash(i) = (i-1)%5+1
hue(i) = words(ways) <= 6 ? shade[(3+2*i)%6+1] : colour(i, words(ways))
is(regime, y) = strcol(4) eq regime ? y : NaN

do for [kind in terminals] {
    eval use_terminal(kind, target.'/surface', 1240, 620)
    set multiplot
    unset datafile columnheaders
    set label 1 'All motions of the pendulum, pushed from the bottom' at screen 0.5, 0.965 center font ',16'
    set origin -0.03, -0.06
    set size 0.67, 1.05
    set view 58, 328, 1.0, 1.15
    set xyplane 0
    set border 4095 lc rgb '#bbbbbb'
    set xlabel 't / (ℓ/g)^{1/2}' offset 0,-0.5
    set ylabel 'E / (m g ℓ)' offset 1,-0.5
    set zlabel 'angle θ / (π rad)' rotate by 90 offset 1.5
    set zrange [-1:top]
    set xrange [first:last]
    set yrange [low:high]
    set key at screen 0.655, 0.91 right top noreverse Right
    mesh = times > 1 && energies > 1
    if (mesh) { set hidden3d offset 1 } else { unset hidden3d }
    splot points_by(angles) using 2:1:($3/pi) with lines lw 0.7 lc rgb '#9ab8cc' notitle, \
          points_by(angles) using 2:1:(is('libration', $3/pi)) with lines lw 1.8 lc rgb shade[5] title 'libration, E < 2', \
          points_by(angles) using 2:1:(is('rotation', $3/pi)) with lines lw 1.8 lc rgb shade[1] title 'rotation, E > 2', \
          points_by(angles) using 2:1:(is('separatrix', $3/pi)) with lines lw 4.5 lc rgb shade[6] title 'separatrix, E = 2'
    unset hidden3d
    unset label 1
    set border 3 lc rgb '#444444'
    if (ways ne '') {
    set xrange [low:high]
    set yrange [*:*]
    if (energies < 2) { eval rising('y', floor(greatest(file, '10', '$6 != ""', 0)) - 2, floor(greatest(file, '10', '$6 != ""', 0)) + 2) }
    set origin 0.64, 0
    set size 0.36, 0.90
    set lmargin 8
    set xlabel e_axis
    set ylabel norm_axis rotate by 90 offset 0
    set title 'Error of the resummation' offset 0,-0.5
    set key at graph 0.98, 0.03 right bottom noreverse Right title orders > 1 ? '' : 'N = '.word(word(ways, 1), 1)
    if (low < 2 && high > 2) { set arrow 1 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3 }
    plot for [i=1:words(ways)] points_by(worst(word(ways, i))) using 1:2 with linespoints lw 2 ps 0.8 pt i+3 dt dash(i) lc rgb hue(i) title in_key(i, words(ways)) ? way_name(word(ways, i)) : ''
    unset arrow
    }
    eval figure_done
}
