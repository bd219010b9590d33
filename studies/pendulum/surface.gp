# surface: theta against time and energy, and the largest error over time of the paper's approximation at each energy.
load scripts.'/style.gp'
table = data.'/surface.csv'
eval seen('energies', table, 'energy', '1')
eval extent('energy', table, 'energy', '1')
eval extent('time', table, 'time', '1')
eval extent('theta', table, 'theta', '1')
eval seen('times', table, 'time', '1')
# The first way of each energy has all the angles: a line of the surface.
do for [e in energies] {
    eval first_cell('way', table, 'order', "is('energy', e)")
    eval first_cell('by', table, 'period_by', "is('energy', e)")
    set table $surface append
    plot table using (at('time')):(at('energy')):(at('theta')):(strcol('regime')) with table if (is('energy', e) && is('order', way) && is('period_by', by))
    unset table
    set print $surface append
    print ''
    set print
}
is_regime(name, y) = strcol(4) eq name ? y : NaN
set table $separatrix
plot table using (at('time')):(at('energy')):(at('theta')) with table if (is('regime', 'separatrix'))
unset table
# The order N of the approximations stands above the key, or in each entry if there are several.
eval seen_together('ways', table, 'order period_by', "has('order')")
eval seen('orders', table, 'order', '1')
order_of(w) = w[1:strstrt(w, ',') - 1]
way_name(w) = (words(orders) > 1 ? 'N = '.order_of(w).', ' : '').(w[strstrt(w, ',') + 1:*] eq 'agm' ? '' : 'T*: ').rule_name(w[strstrt(w, ',') + 1:*])
dash(i) = (i-1)%5+1
hue(i) = words(ways) <= 6 ? shade[(3+2*i)%6+1] : colour(i, words(ways))
errors = 'for [i=1:words(ways)] '.rows(table, 'energy', 'log10_norm', "strcol('order').','.strcol('period_by') eq word(ways, i) && at('time') == time_low")

do for [kind in terminals] {
    eval use_terminal(kind, target.'/surface', 1240, 620)
    set multiplot
    set label 1 'All motions of the pendulum, pushed from the bottom' at screen 0.5, 0.965 center font ',16'
    set origin -0.03, -0.06
    set size 0.67, 1.05
    set view 58, 328, 1.0, 1.15
    set xyplane 0
    set border 4095 lc rgb '#bbbbbb'
    set xlabel 't / (ℓ/g)^{1/2}' offset 0,-0.5
    set ylabel 'E / (m g ℓ)' offset 1,-0.5
    set zlabel 'angle θ / rad' rotate by 90 offset 1.5
    set zrange [-pi:smaller(larger(theta_high, 1.2 * pi), 12 * pi)]
    set ztics pi * step_of(smaller(larger(theta_high / pi, 1.2), 12) / 2)
    set format z '%.0Pπ'
    eval time_high > time_low ? sprintf('set xrange [%g:%g]', time_low, time_high) : rising('x', time_low, time_high)
    eval energy_high > energy_low ? sprintf('set yrange [%g:%g]', energy_low, energy_high) : rising('y', energy_low, energy_high)
    set key at screen 0.655, 0.91 right top noreverse Right
    set datafile nocolumnheaders
    set datafile separator whitespace
    if (words(times) > 1 && words(energies) > 1) { set hidden3d offset 1 }
    splot $surface using 1:2:3 with lines lw 0.7 lc rgb '#9ab8cc' notitle, \
          $surface using 1:2:(is_regime('libration', $3)) with lines lw 1.8 lc rgb shade[5] title 'libration, E < 2', \
          $surface using 1:2:(is_regime('rotation', $3)) with lines lw 1.8 lc rgb shade[1] title 'rotation, E > 2', \
          NaN with lines lw 4.5 dt 2 lc rgb shade[6] title 'separatrix, E = 2'
    unset hidden3d
    # As the paper draws it: dashed throughout, above the surface that would hide parts of it.
    set key off
    unset border; unset xtics; unset ytics; unset ztics; unset xlabel; unset ylabel; unset zlabel; unset label 1
    splot $separatrix using 1:2:3 with lines lw 4.5 dt 2 lc rgb shade[6] notitle
    set xtics nomirror out; set ytics nomirror out; set key on
    set datafile separator ','
    set datafile columnheaders
    set border 3 lc rgb '#444444'
    if (words(ways) > 0) {
        eval energy_high > energy_low ? sprintf('set xrange [%g:%g]', energy_low, energy_high) : rising('x', energy_low, energy_high)
        set yrange [*:*]
        set offsets 0, 0, 1, 1
        set origin 0.64, 0
        set size 0.36, 0.90
        set lmargin 8
        set xlabel e_axis offset 0, 0
        set ylabel norm_axis rotate by 90 offset 0
        set title 'Error of the resummation' offset 0,-0.5
        set key at graph 0.98, 0.03 right bottom noreverse Right title words(orders) > 1 ? '' : 'N = '.order_of(word(ways, 1))
        eval separatrix_on_x(energy_low, energy_high)
        eval 'plot '.errors." with linespoints lw 2 ps 0.8 pt i+3 dt dash(i) lc rgb hue(i) title in_key(i, words(ways)) ? way_name(word(ways, i)) : ''"
        eval energies_done
    }
    eval figure_done
}
