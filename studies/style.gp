# The one style of all figures. A script is called with `data` (folder of the CSV), `target` (folder for the drawings) and
# `scripts` (this folder), loads this file, and draws once for each name in `terminals`.

set datafile separator ','
set datafile missing NaN          # a filtered-out row does not break a line
set datafile columnheaders

terminals = 'svg png'
# use_terminal(kind, file, width, height)
use_terminal(kind, file, w, h) = kind eq 'svg' \
    ? sprintf("set terminal svg size %d,%d dynamic enhanced font 'Helvetica,13' background 'white'; set output '%s.svg'", w, h, file) \
    : sprintf("set terminal pngcairo size %d,%d enhanced font 'DejaVu Sans,12' background 'white'; set output '%s.png'", w, h, file)

# Okabe and Ito's colours in an order that also darkens in grey, so that neighbours differ without colour.
array shade[6] = ['#E69F00', '#56B4E9', '#009E73', '#D55E00', '#0072B2', '#000000']

set border 3 lc rgb '#444444'
set tics nomirror out textcolor rgb '#222222'
set grid ytics lc rgb '#dddddd' lw 0.7
set key textcolor rgb '#222222' samplen 2.2 spacing 1.1
