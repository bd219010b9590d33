# proved_radius of any equation: the radius against the parameter with the most values, one curve per combination of the
# others, and the cost of a proof against its digits.
load scripts.'/shared/equation.gp'
costs = table_of('_cost')
eval equation_panels('digits')
eval longest_axis('digits')
eval extent('digits', main, 'digits', '1')
eval seen('all_digits', costs, 'digits', '1')
always = words(axes) ? "at('digits') == digits_high" : '1'
title_text = 'Radius of convergence of '.called.', proved'
below_text = sprintf('bounds about the start that agree to %d digits', int(digits_high))
panel_by = ''; panels = words(all_digits) > 1 ? '"radius" "discs of a proof" "time of a proof"' : '"radius"'; width = words(panels) > 1 ? 400 : 900; height = 420
eval other_axes('', '')
n = words(hues)
x = along
points = ' with points pt 7 ps 0.7 lc rgb shade[3]'
radii = by_hue('lower', '1', 'linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)')
discs = rows(costs, 'digits', 'discs', '1').points
seconds = rows(costs, 'digits', "log10(at('seconds'))", "at('seconds') > 0").points
x_axis = "if (p == 1) { eval rising('x', x_low, x_high); set xlabel along eq 'digits' ? 'digits D' : along_name } else { set logscale x; eval tics_at('x', all_digits, 6); set xrange [word(all_digits, 1) / 1.2:digits_high * 1.2]; set xlabel 'digits D' }"
prepare = "set offsets; panel_title = p == 1 ? '' : this; y_name = p == 1 ? 'radius R / unit of the variable' : p == 2 ? 'discs' : 'log_{10} (time / s)'; y_axis = p < 3 ? 'set yrange [0:*]' : ''; layers = p == 1 ? radii : p == 2 ? discs : seconds"
finish = 'unset logscale; set xtics autofreq'
key = hue_by eq '' ? '' : key_of_hues('linespoints lw 1.5 pt mark_of(h) ps 0.7 lc rgb tone(h)')
entries = shown_in_key(n); letters = 20
load scripts.'/shared/panels.gp'
