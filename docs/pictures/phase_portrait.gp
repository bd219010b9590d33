# The phase portrait: omega against theta at each energy level. Drawn by draw.sh.
set encoding utf8
set terminal svg size 640,600 dynamic enhanced font 'DejaVu Sans,13' background '#ffffff'
set output target
set datafile separator ','
set key below
set xrange [-pi:pi]
set yrange [-3.2:3.2]
set xlabel 'θ, radians'
set ylabel 'ω, in units of √(g/l)'
set xtics ('-π' -pi, '-π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set grid lc rgb '#dddddd'
levels = '0.1 0.5 1 1.5 1.9'
over = '2.1 2.5 3 4'
file(name) = work.'/'.name.'.csv'
set title 'Energy levels of the pendulum'
plot for [e in levels] file('libration_'.e) using 2:3 skip 1 with lines lw 1.8 lc rgb '#0b5cad' notitle, \
     file('separatrix_+') using 2:3 skip 1 with lines lw 2.6 lc rgb '#222222' title 'separatrix, E = 2', \
     file('separatrix_-') using 2:3 skip 1 with lines lw 2.6 lc rgb '#222222' notitle, \
     for [e in over] file('rotation_'.e.'+') using ($2 - 2*pi):($2 > pi ? $3 : NaN) skip 1 with lines lw 1.8 lc rgb '#a63a00' notitle, \
     for [e in over] file('rotation_'.e.'-') using ($2):($3) skip 1 with lines lw 1.8 lc rgb '#a63a00' notitle, \
     NaN with lines lw 1.8 lc rgb '#0b5cad' title 'libration: 0.1, 0.5, 1, 1.5, 1.9', \
     NaN with lines lw 1.8 lc rgb '#a63a00' title 'rotation: 2.1, 2.5, 3, 4'
