# resummations: error norm against the number of coefficients, at one energy or two, and against the distance from E = 2
# on each side at one number.
load scripts.'/style.gp'
figure = 'resummations'
table = data.'/resummations.csv'
title_text = 'Error norm of the resummations on [0, T*]'
below_text = 'by their number of coefficients; m: number of conditions at the bottom'
kind_by = 'method'; kinds = 'series resummed resummed_4 resummed_8 two_point pade uniform'
names = '"series" "resummation, m = 2" "m = 4" "m = 8" "two-point" "Padé (gaps: poles)" "uniform"'
tone(k) = word('#999999 #E69F00 #D55E00 #56B4E9 #009E73 #0072B2 #000000', k)
sign(k) = word('1 4 6 8 12 2 7', k) + 0
eval energy_names(table)
eval seen('energies', table, 'energy', '1')
eval seen('counts', table, 'count', '1')
drawn = listed(counts, '16') ? '16' : word(counts, words(counts))
# Panels against the number of coefficients: the last energy below 2 and away from it, and one near it; or the first two.
away = "at('log10_gap') > -0.99"
close_to = "at('log10_gap') < -5.5 && at('log10_gap') > -6.5"
eval last_cell('far', table, 'energy', away.' && !('.rotates.')')
eval first_cell('near', table, 'energy', close_to.' && !('.rotates.')')
if (near eq '') { eval first_cell('near', table, 'energy', close_to) }
panels = words(energies) <= 2 ? energies : words(counts) > 1 ? far.' '.near : ''
# Panels against the distance from E = 2.
eval seen('below', table, 'energy', '!('.rotates.')')
eval seen('above', table, 'energy', rotates)
if (words(energies) > 2) { panels = panels.(words(below) > 1 ? ' libration' : '').(words(above) > 1 ? ' rotation' : '') }
is_side(panel) = panel eq 'libration' || panel eq 'rotation'
always = "(is_side(this) ? is('count', drawn) && (this eq 'rotation') == (".rotates.") : is('energy', this))"
most_across = 2
x = "is_side(this) ? at('log10_gap') : at('count')"
x_axis = "eval extent('x', table, is_side(this) ? 'log10_gap' : 'count', always); if (is_side(this)) { eval falling('x', x_low, x_high); set xlabel gap_axis } else { set xrange [0:x_high * 1.06]; set xlabel 'coefficients that are not 0' }"
y_name = norm_axis; y_axis = "eval extent('y', table, 'log10_norm', always); set yrange [y_low - room(y_low, y_high):smaller(y_high + room(y_low, y_high), 4)]"
prepare = "panel_title = is_side(this) ? drawn.' coefficients, '.this : 'E = '.named_energy(this)"
line = 'linespoints pt sign(k) ps 0.7 lw 1.8 dt k == 1 ? 2 : 1 lc rgb tone(k)'
# A Pade approximant with a pole in the interval has no norm: there its line has a gap.
layers = curves('log10_bound', '1', 'lines lw 1.6 dt 3 lc rgb tone(k)') \
    .', for [k=1:7] '.broken_rows(table, x, "is('norm', 'inf') ? 1e999 : at('log10_norm')", of_kind("has('log10_norm') || is('norm', 'inf')")).' with '.line
key = 'for [k=1:7] '.key_entry(line, 'word(names, k)').', '.key_entry('lines lw 1.6 dt 3 lc rgb soft', "'proved (A, A2, U)'")
entries = 8
load scripts.'/shared/panels.gp'
