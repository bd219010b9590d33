# all_time: error against the number of periods; one panel per method for T*, and in a second figure per scalar.
# Columns: energy,period_by,periods,period_error,error,predicted,log10_periods,log10_error,log10_predicted; in the table
# _reduction: energy,scalar,reduction,periods,error,predicted,log10_periods,log10_error,log10_predicted.
load scripts.'/style.gp'

file = data.'/all_time.csv'
reduction = data.'/all_time_reduction.csv'
energies = seen(file, 1, '1')
rules = seen(file, 2, '1')
n = words(energies)
panels = smaller(words(rules), 9)
first = least(file, '7', '1', 0)
last = greatest(file, '7', '1', 1)
named(i) = 'E = '.number_name(word(energies, i))
periods_axis = 'log_{10} p'

eval grid(panels, 4)
panel_w = panels == 1 ? 800 : panels == 2 ? 520 : panels == 3 ? 400 : across == 2 ? 520 : 310
panel_h = 440
foot = foot_for(shown_in_key(n) + 1, 12)
low = larger(least(file, '8', '1', -16), -40); high = greatest(file, '8 9', '1', 0)
do for [kind in terminals] {
    eval figure_of(kind, 'all_time')
    eval heading('Error after p periods with an inexact T*', 'each panel: T* from N powers of its series or of the resummation'.(words(rules) > panels ? sprintf('; %d of %d sums', panels, words(rules)) : ''))
    eval rising('x', first, last)
    set yrange [low - room(low, high):high + room(low, high)]
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    set xlabel periods_axis
    do for [c=1:panels] {
        eval panel(c)
        set title rule_name(pick(rules, panels, c)) offset 0, -0.5
        if ((c - 1) % across == 0) { set ylabel norm_axis } else { unset ylabel }
        unset key
        plot for [i=1:n] rows_at(file, 7, 9, '1 2', word(energies, i).','.pick(rules, panels, c), '1') using 1:2 with lines lw 1.4 dt 3 lc rgb colour(i, n), \
             for [i=1:n] rows_at(file, 7, 8, '1 2', word(energies, i).','.pick(rules, panels, c), '1') using 1:2 with linespoints lw 1.8 pt mark_of(i) ps 0.9 lc rgb colour(i, n)
        eval no_heading
    }
    eval key_strip
    plot for [i=1:n] NaN with linespoints lw 1.8 pt mark_of(i) ps 0.9 lc rgb colour(i, n) title in_key(i, n) ? named(i) : '', \
         NaN with lines lw 1.4 dt 3 lc rgb soft title 'estimate'
    eval figure_done
}

scalars = seen(reduction, 2, '1')
panels = words(scalars)
eval grid(panels, 3)
panel_w = panels == 1 ? 800 : panels == 2 ? 590 : 400
foot = foot_for(shown_in_key(n) + 3, 12)
low = least(reduction, '8', '1', -16); high = greatest(reduction, '8 9', '1', 0)
do for [kind in terminals] {
    eval figure_of(kind, 'all_time_reduction')
    eval heading('The exact solution after p periods in each arithmetic', 'the time reduced by fmod in that arithmetic, or exactly')
    eval rising('x', first, last)
    set yrange [low - room(low, high):high + room(low, high)]
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    set xlabel periods_axis
    do for [c=1:panels] {
        s = word(scalars, c)
        eval panel(c)
        set title arithmetic_name(s) offset 0, -0.5
        if ((c - 1) % across == 0) { set ylabel norm_axis } else { unset ylabel }
        unset key
        plot for [i=1:n] rows_at(reduction, 7, 9, '1 2 3', word(energies, i).','.s.',fmod', '1') using 1:2 with lines lw 1.4 dt 3 lc rgb colour(i, n), \
             for [i=1:n] rows_at(reduction, 7, 8, '1 2 3', word(energies, i).','.s.',exact', '1') using 1:2 with linespoints lw 1.8 dt 2 pt mark_of(i) ps 0.6 lc rgb colour(i, n), \
             for [i=1:n] rows_at(reduction, 7, 8, '1 2 3', word(energies, i).','.s.',fmod', '1') using 1:2 with linespoints lw 1.8 pt mark_of(i) ps 0.9 lc rgb colour(i, n)
        eval no_heading
    }
    eval key_strip
    plot for [i=1:n] NaN with linespoints lw 1.8 pt mark_of(i) ps 0.9 lc rgb colour(i, n) title in_key(i, n) ? named(i) : '', \
         NaN with lines lw 1.8 lc rgb soft title 'by fmod', \
         NaN with lines lw 1.4 dt 3 lc rgb soft title 'its bound', \
         NaN with lines lw 1.8 dt 2 lc rgb soft title 'exactly'
    eval figure_done
}
