# singularities: the complex t-plane of each energy to scale, and the convergence of the Pade poles.
load scripts.'/style.gp'
figure = 'singularities'
table = data.'/singularities.csv'
eval energy_names(table)
eval seen('hues', table, 'order', "is('kind', 'pade_pole')")
n = words(hues)
eval seen('energies', table, 'energy', '1')
all_energies = words(energies)
title_text = 'Singularities of θ(t), and poles of Padé approximants of ω from N coefficients'
panel_by = 'energy'; most_panels = 6; most_across = all_energies > 4 ? 3 : 2; height = 430
width = all_energies > 2 ? 540 : all_energies > 1 ? 610 : 760
hue_by = 'order'; hue_name(N) = 'Padé, N = '.N
# As in the paper's figures: t = 0 at the top of a libration and at the bottom of a rotation, whose top is at T*.
x = "origin + at('re')"; x_name = 'Re t / (ℓ/g)^{1/2}'; y_name = 'Im t / (ℓ/g)^{1/2}'; y_name_everywhere = 1
from_top(name, c) = sprintf("eval first_cell('cell', table, '%s', of_panel(\"is('kind', 'expansion_top')\")); %s = number(cell); ", c, name)
# The CSV contains the lattice up to 4 T* and 4 K~', or 1.5 R. A panel is not higher than wide.
size = "w = larger(3.6 * tstar, 1.2 * R); h_ = larger(1.2 * R, smaller(3.6 * above, w)); h_ = smaller(larger(h_, 0.62 * w), larger(3.99 * above, 1.49 * R)); "
# Beside their marks and clear of the circles, which all pass through T* + i K~' of the top.
place(i, name, re, im, where) = sprintf("set label %d (%s) at %s, %s %s point pt 13 ps 0.9 lc rgb '#555555' front font ',11'; ", i, name, re, im, where)
labels = place(1, "origin > 0 ? '2T*' : 'T*'", 'origin + tstar', '0', 'right offset -0.4, -0.8').place(2, "origin > 0 ? '0' : '−T*'", 'origin - tstar', '0', 'left offset 0.4, -0.8').place(3, "'i K̃′'", '0', 'above', 'left offset (origin > 0 ? -3.1 : 0.4), (origin > 0 ? 0.7 : 0.6)').place(4, "origin > 0 ? 'T*' : '0'", 'origin', '0', 'right offset -0.4, -0.8')
# The radius, drawn where no singularity is on the circle, with its name above the middle of it.
radius_line = "set arrow 3 from origin, 0 to origin - 0.5 * R, 0.866 * R nohead lc rgb '#0072B2' lw 1.2; set label 5 'R' at origin - 0.25 * R, 0.433 * R right offset -0.6, 0.5 textcolor rgb '#0072B2' front; "
prepare = from_top('tstar', 'tstar').from_top('above', 'height').from_top('R', 'radius')."origin = substr(gap_of(this), 1, 1) eq '-' ? tstar : 0.0; ".size.labels.radius_line."set xlabel x_name.(origin > 0 ? ', t = 0 at the bottom' : ', t = 0 at the top'); panel_title = 'E = '.named_energy(this).(substr(gap_of(this), 1, 1) eq '-' ? ': rotation' : ': libration'); unset grid; set size ratio -1; set samples 361; set arrow 1 from origin - w, 0 to origin + w, 0 nohead lc rgb '#888888' lw 0.8 back; set arrow 2 from origin, -h_ to origin, h_ nohead lc rgb '#888888' lw 0.8 dt 3 back"
x_axis = 'set xrange [origin - w:origin + w]; set yrange [-h_:h_]'
finish = 'do for [i=1:5] { unset label i }; set size noratio'
circle(re, r, style) = sprintf("'+' using (%s + %s * cos(2 * pi * $0 / 360)):(%s * sin(2 * pi * $0 / 360)) with lines lw 2 %s", re, r, r, style)
about_top = "lc rgb '#0072B2'"; about_bottom = "dt 2 lc rgb '#D55E00'"
layers = circle('origin', 'R', about_top).', '.circle('origin + tstar', 'above', about_bottom).', '.circle('origin - tstar', 'above', about_bottom) \
    .', '.once('im', "is('kind', 'singularity')", "points pt 7 ps 0.9 lc rgb '#000000'")
pole = 'points pt mark_of(h) ps 0.9 + 0.35 * ((h - 1) % 6 + 1) lw 1.4 lc rgb colour(h, n)'
# The lattice is symmetric about both axes.
do for [s in '1 -1'] {
    x = 'origin + '.s." * at('re')"
    do for [t in '1 -1'] { if (n > 0) { layers = layers.', '.by_hue(t." * at('im')", "is('kind', 'pade_pole')", pole) } }
}
key = key_entry('lines lw 2 '.about_top, "'circle about top'").', '.key_entry('lines lw 2 '.about_bottom, "'circle about bottom'") \
    .', '.key_entry("points pt 7 ps 0.9 lc rgb '#000000'", "'singularities'").(n > 0 ? ', '.key_of_hues(pole) : '')
entries = 3 + shown_in_key(n)
load scripts.'/shared/panels.gp'

# The accuracy of the first singularity as found from the coefficients.
figure = 'singularities_convergence'
table = data.'/singularities_convergence.csv'
title_text = all_energies > 2 ? 'The Padé pole nearest to T* + i K̃′, from N coefficients' : 'The first singularity, T* + i K̃′, from N coefficients'
hue_by = 'energy'; hue_name(E) = 'E = '.named_energy(E)
eval seen('hues', table, 'energy', '1')
tone(h) = all_energies <= 6 ? shade[(h+2)%6+1] : colour(h, all_energies)
x = 'order'; x_name = 'order N, last power of the series'; y_name = 'log_{10} (|error| / (ℓ/g)^{1/2})'
layers = by_hue('log10_distance', '1', 'linespoints lw 2 pt mark_of(h) ps 0.8 lc rgb tone(h)') \
    .', '.by_hue('log10_root_error', '1', 'linespoints lw 2 dt 2 pt 2 ps 0.5 lc rgb tone(h)')
key = key_of_hues('linespoints lw 2 pt mark_of(h) ps 0.8 lc rgb tone(h)').', '.key_entry('lines lw 2 lc rgb soft', "'pole of the Padé approximant'") \
    .', '.key_entry('lines lw 2 dt 2 lc rgb soft', "'root test, its radius'")
entries = shown_in_key(all_energies) + 2; letters = 28
load scripts.'/shared/panels.gp'
