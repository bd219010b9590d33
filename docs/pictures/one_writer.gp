# Where one writer saturates: cells a second over the cores, by the time that a cell takes. Drawn by draw.sh from the
# table that ./run bench journal --model writes.
set encoding utf8
set terminal svg size 720,460 dynamic enhanced font 'DejaVu Sans,13' background '#ffffff'
set output target
set datafile separator ','
set key right bottom
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'cores that compute'
set ylabel 'finished cells a second'
set grid lc rgb '#dddddd'
file = work.'/one_writer.csv'
limit = real(system(sprintf("sed -n 2p '%s' | cut -d, -f4", file)))
set yrange [0.5:4*limit]
set title 'One writer, and cells of 0.1 ms to 1 s'
of(seconds) = sprintf("< awk -F, 'NR == 1 || $2 + 0 == %s' '%s'", seconds, file)
set arrow from graph 0, first limit to graph 1, first limit nohead lw 1.5 dt 2 lc rgb '#222222'
set label 'all that one writer takes' at graph 0.02, first 1.4*limit
plot of('0.0001') using 1:3 skip 1 with lines lw 2 lc rgb '#0b5cad' title '0.1 ms', \
     of('0.001') using 1:3 skip 1 with lines lw 2 lc rgb '#3f8f3f' title '1 ms', \
     of('0.01') using 1:3 skip 1 with lines lw 2 lc rgb '#c58b00' title '10 ms', \
     of('0.1') using 1:3 skip 1 with lines lw 2 lc rgb '#a63a00' title '0.1 s', \
     of('1') using 1:3 skip 1 with lines lw 2 lc rgb '#7a3fa0' title '1 s'
