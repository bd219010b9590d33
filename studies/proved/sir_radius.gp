# sir_radius: the radius of convergence of SIR against the reproduction number, one curve per number of infected, with
# the time of the peak.
load scripts.'/style.gp'
figure = 'sir_radius'
table = data.'/sir_radius.csv'
title_text = 'The radius of convergence of SIR'
below_text = 'by quadrature, each point between proved bounds that agree to 8 digits'
height = 520
hue_by = 'infected'; hue_name(I) = 'r I(0)/a = '.number_name(I)
eval seen('hues', table, 'infected', '1')
n = words(hues)
eval seen('marks', table, 'reproduction', '1')
eval extent('radius', table, 'radius', '1')
x = 'reproduction'; x_name = 'reproduction number r S(0) / a'; y_name = 'time a t'
x_axis = "set logscale xy; set xrange [x_low / 1.15:x_high * 1.15]; set yrange [radius_low / 1.5:radius_high * 1.6]; set xtics (x_low, x_high); do for [m in marks] { eval 'set xtics add ('.m.')' }"
layers = by_hue('radius', '1', 'linespoints pt 7 ps 0.6 lw 1.8 lc rgb colour(h, n)').', '.by_hue('peak', "at('peak') > 0", 'lines dt 2 lw 1.4 lc rgb colour(h, n)')
key = key_of_hues('linespoints pt 7 ps 0.6 lw 1.8 lc rgb colour(h, n)').', '.key_entry('lines lw 1.8 lc rgb soft', "'radius'") \
    .', '.key_entry('lines dt 2 lw 1.4 lc rgb soft', "'time of the peak'")
entries = n + 2; letters = 22
load scripts.'/shared/panels.gp'
