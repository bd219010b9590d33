# What gap, T*, fundamental arc and lattice mean, at E = 1.71. Drawn by draw.sh.
set encoding utf8
set terminal svg size 1180,420 dynamic enhanced font 'DejaVu Sans,13' background '#ffffff'
set output target
set datafile separator ','
number(column) = real(system(sprintf("sed -n 2p '%s/constants.csv' | cut -d, -f%d", work, column)))
period = number(9)
tstar = number(10)
radius = number(11)
height = sqrt(radius**2 - tstar**2)
energy = 1.71
blue = '#0b5cad'
red = '#a63a00'
set multiplot layout 1,3
unset key
set grid lc rgb '#eeeeee'

set title 'E and the gap 2 - E'
set xrange [-1.15*pi:1.15*pi]
set yrange [0:2.3]
set xlabel 'θ'
set ylabel 'energy in m g l'
set xtics ('-π' -pi, '0' 0, 'π' pi)
set ytics 0.5
edge = acos(1 - energy)
set arrow 1 from -edge,energy to edge,energy nohead lw 3 lc rgb blue
set arrow 2 from 0,energy to 0,2 heads size 0.12,20 lw 1.5 lc rgb red
set label 1 'gap' at 0.2,1.86 tc rgb red
set label 2 'E = 1.71' at -0.55,1.58 tc rgb blue
set label 3 'E = 2, the separatrix' at -1.35,2.12
set label 4 '1 - cos θ' at 1.15,0.45
plot 1 - cos(x) with lines lw 2 lc rgb '#444444', 2 with lines dt 2 lc rgb '#444444'
unset arrow; unset label

set title 'The fundamental arc: from the top to the bottom'
set xrange [0:period]
set yrange [-2.9:3.4]
set xlabel 'time in √(l/g)'
set ylabel 'θ'
set xtics ('0' 0, 'T*' tstar, '2T*' 2*tstar, '3T*' 3*tstar, 'T' period)
set ytics 1
set arrow 1 from 0,2.85 to tstar,2.85 heads size 0.15,20 lw 1.5 lc rgb red
set label 1 'T* = T/4' at 0.45,3.12 tc rgb red
set label 2 'fundamental arc' at 1.7,1.6 tc rgb blue
set label 3 'top' at 0.85,2.4
set label 4 'bottom' at tstar + 0.2,0.2
plot work.'/swing.csv' using 1:2 skip 1 with lines lw 1.5 lc rgb '#888888', \
     work.'/swing.csv' using 1:($1 <= tstar ? $2 : NaN) skip 1 with lines lw 4 lc rgb blue
unset arrow; unset label

set title 'The lattice of singularities in complex time'
set size ratio -1
set xrange [-4*tstar:4*tstar]
set yrange [-4.2*height:4.2*height]
set xlabel 'Re t'
set ylabel 'Im t' offset 1
set xtics ('-3T*' -3*tstar, '-T*' -tstar, '0' 0, 'T*' tstar, '3T*' 3*tstar)
set ytics ("-K~'" -height, '0' 0, "K~'" height, "3K~'" 3*height) noenhanced
set arrow 1 from 0,0 to tstar,height nohead lw 1.5 lc rgb red
set label 1 'R' at 0.35*tstar,0.75*height tc rgb red
set object 1 circle at 0,0 size radius fs empty border lc rgb red
set arrow 2 from 0,0 to tstar,0 nohead lw 4 lc rgb blue
set samples 2
plot for [m=-2:1] for [j=-2:1] '+' using ((2*m + 1)*tstar):((2*j + 1)*height) with points pt 7 ps 0.6 lc rgb '#222222'
unset multiplot
