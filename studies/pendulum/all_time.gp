# all_time: error against the number of periods; a panel for each way to T*, and in a second figure for each scalar.
# Columns: energy,period_by,periods,period_error,error,predicted,log10_periods,log10_error,log10_predicted; in the table
# _reduction: energy,scalar,reduction,periods,error,predicted,log10_periods,log10_error,log10_predicted.
load scripts.'/style.gp'

file = data.'/all_time.csv'
reduction = data.'/all_time_reduction.csv'
distinct(name, column) = system(sprintf("tail -n +2 '%s' | cut -d, -f%d | awk '!seen[$0]++'", name, column))
edge(name, column, side) = system(sprintf("awk -F, 'NR>1&&$%d!~/inf/&&$%d!=\"\"{if(!n++||$%d>h)h=$%d;if(n==1||$%d<l)l=$%d}END{if(h==l){h+=1;l-=1}print n ? %s : 0}' '%s'", column, column, column, column, column, column, side, name)) + 0
energies = distinct(file, 1)
rules = distinct(file, 2)
panels = words(rules) < 4 ? words(rules) : 4
first = edge(file, 7, 'l')
last = edge(file, 7, 'h')
low = edge(file, 8, 'l')
low = low < -32 ? -32 : floor(low) - 2
high = ceil(edge(file, 8, 'h')) + 2
of(e, way, y) = strcol(1) eq e && strcol(2) eq way ? y : NaN
by(e, way, how, y) = strcol(3) eq how ? of(e, way, y) : NaN
colour(i) = shade[(i-1)%6+1]
shape(i) = word('7 5 9 11 13 6', (i-1)%6+1) + 0

do for [kind in terminals] {
    eval use_terminal(kind, target.'/all_time', 200 + 280*panels, 560)
    wide = 200.0 + 280*panels
    set multiplot
    set label 1 'Error after p periods with an inexact T*'.(words(rules) > panels ? sprintf(' (%d of %d ways)', panels, words(rules)) : '') at screen 0.5, 0.955 center font ',16'
    set xrange [first-0.3:last+0.3]
    set yrange [low:high]
    set tmargin at screen 0.85
    set bmargin at screen 0.13
    set xlabel 'log_{10} p, periods'
    do for [c=1:panels] {
        set lmargin at screen (75 + (c-1)*280)/wide
        set rmargin at screen (75 + c*280 - 22)/wide
        set title 'T* by '.word(rules, c) offset 0,-0.4
        if (c == 1) { set ylabel 'log_{10} max |error|, radians' offset 0.5; set format y '%g' } else { unset ylabel; set format y '' }
        if (c == panels) { set key at screen 1 - 12/wide, 0.83 right top title 'energy E' } else { unset key }
        plot for [i=1:words(energies)] file using 7:(of(word(energies, i), word(rules, c), column(9))) with lines lw 1.4 dt 3 lc rgb colour(i) notitle, \
             for [i=1:words(energies)] file using 7:(of(word(energies, i), word(rules, c), column(8))) with linespoints lw 1.8 pt shape(i) ps 0.9 lc rgb colour(i) title word(energies, i), \
             NaN with lines lw 1.4 dt 3 lc rgb '#555555' title 'estimate'
        unset label 1
    }
    unset multiplot
    unset output
}

scalars = distinct(reduction, 2)
n = words(scalars)
low = floor(edge(reduction, 8, 'l')) - 1
high = ceil(edge(reduction, 9, 'h')) + 1
do for [kind in terminals] {
    eval use_terminal(kind, target.'/all_time_reduction', 200 + 340*n, 560)
    wide = 200.0 + 340*n
    set multiplot
    set label 1 'The exact solution after p periods in each scalar' at screen 0.5, 0.955 center font ',16'
    set xrange [first-0.3:last+0.3]
    set yrange [low:high]
    do for [c=1:n] {
        set lmargin at screen (75 + (c-1)*340)/wide
        set rmargin at screen (75 + c*340 - 22)/wide
        set title word(scalars, c) offset 0,-0.4
        if (c == 1) { set ylabel 'log_{10} max |error|, radians' offset 0.5; set format y '%g' } else { unset ylabel; set format y '' }
        if (c == n) { set key at screen 1 - 12/wide, 0.83 right top title 'energy E' } else { unset key }
        plot for [i=1:words(energies)] reduction using 7:(by(word(energies, i), word(scalars, c), 'fmod', column(9))) with lines lw 1.4 dt 3 lc rgb colour(i) notitle, \
             for [i=1:words(energies)] reduction using 7:(by(word(energies, i), word(scalars, c), 'exact', column(8))) with linespoints lw 1.8 dt 2 pt shape(i) ps 0.6 lc rgb colour(i) notitle, \
             for [i=1:words(energies)] reduction using 7:(by(word(energies, i), word(scalars, c), 'fmod', column(8))) with linespoints lw 1.8 pt shape(i) ps 0.9 lc rgb colour(i) title word(energies, i), \
             NaN with lines lw 1.8 lc rgb '#555555' title 'fmod', \
             NaN with lines lw 1.4 dt 3 lc rgb '#555555' title 'its bound', \
             NaN with lines lw 1.8 dt 2 lc rgb '#555555' title 'exact'
        unset label 1
    }
    unset multiplot
    unset output
}
