# stiff: the proved digits, the seconds, and the quotient of explicit and used steps, against the time reached.
load scripts.'/style.gp'
figure = 'stiff'
table = data.'/stiff.csv'
timed = data.'/stiff_time.csv'
title_text = 'Stiff problems followed with proof'
below_text = 'against the time that is reached'
hue_by = 'problem'; hue_name(p) = problem_name(p)
eval seen('hues', table, 'problem', '1')
panels = '"proved digits" "seconds" "log_{10} (explicit steps / steps)"'
eval extent('time', table, 'time', "at('time') > 0")
eval extent('time_', timed, 'seconds', '1')
x = 'time'; x_name = 'time'; x_axis = "set logscale x; set format x '10^{%T}'; set xrange [time_low / 2:time_high * 2]; if (time_high > 1e8 * time_low) { set xtics 1e4 }"
line = 'linespoints lw 1.8 pt mark_of(h) ps 0.7 lc rgb colour(h, words(hues))'
digits = by_hue('digits', '1', line)
ratios = by_hue('log10_ratio', '1', line)
seconds = 'for [h=1:words(hues)] '.rows(timed, x, "larger(at('seconds'), 1e-3)", of_hue('1')).' with '.line.' notitle'
prepare = "panel_title = this; layers = p == 1 ? digits : p == 2 ? seconds : ratios; y_axis = p == 1 ? 'set yrange [0:*]' : p == 2 ? 'set logscale y; set yrange [1e-3:*]' : 'set yrange [-0.5:*]'; if (p == 2) { set format y '10^{%T}'; set offsets }"
finish = "unset logscale; set format '%g'; set xtics autofreq"
key = key_of_hues(line)
entries = words(hues); letters = 16
load scripts.'/shared/panels.gp'
