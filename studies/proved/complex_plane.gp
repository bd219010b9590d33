# complex_plane: the argument of an unknown as a colour over the complex t-plane, its modulus as shades, with
# singularities, the proved circle of convergence and the discs that prove it.
load scripts.'/style.gp'
figure = 'complex_plane'
table = data.'/complex_plane.csv'
places = data.'/complex_plane_singularities.csv'
proofs = data.'/complex_plane_proofs.csv'
title_text = 'Solutions in the complex plane of time'
below_text = 'from the start; colour: argument of the first unknown, shade: modulus, a factor of 10 from dark to light'
x = 're'; panel_by = 'problem'; most_panels = 40; most_across = 4
eval seen('panels', table, 'problem', '1')
width = words(panels) < 3 ? 460 : 300; height = words(panels) < 3 ? 440 : 300
# White where the solution has no value.
shade_of(m) = 0.62 + 0.38 * (m - floor(m))
colour_here(c) = has('argument') && has('log10_abs') ? hsv2rgb((at('argument') + pi) / (2 * pi), 0.45, shade_of(at('log10_abs'))) : 0xffffff
channel(shift) = sprintf('(int(colour_here(0)) >> %d) & 255', shift)
prepare = "eval extent('reach', table, 're', of_panel('1')); reach = reach_high; eval first_cell('u', table, 'unknown', of_panel('1')); panel_title = problem_name(this).': '.u; eval first_cell('R', proofs, 'radius', of_panel(\"is('part', 'lower')\")); set lmargin 6; set rmargin 2; set bmargin 2.6; unset grid; set size ratio -1; set style fill transparent solid 0 border lc rgb '#777777'; set object 1 circle at 0, 0 size (strlen(R) ? number(R) : 0) fs empty border lc rgb '#000000' lw 2 front; set title font ',12'"
x_axis = "set xrange [-reach:reach]; set yrange [-reach:reach]; set xtics step_of(reach) format '%.3g' font ',10'; set ytics step_of(reach) format '%.3g' font ',10'"
finish = 'unset object 1; set size noratio'
pixels = sprintf("'%s' using (%s ? at('re') : NaN):(at('im')):(%s):(%s):(%s) with rgbimage", table, of_panel('1'), channel(16), channel(8), channel(0))
discs = rows(proofs, 're', 'im', of_panel("is('part', 'disc')")).":(at('radius')) with circles lc rgb '#777777' lw 0.4 fs empty border"
layers = pixels.', '.discs.', '.rows(places, 're', 'im', of_panel('1'))." with points pt 2 ps 1.1 lw 2 lc rgb '#000000'"
key = key_entry("points pt 2 ps 1.1 lw 2 lc rgb '#000000'", "'singularity'").', '.key_entry("lines lw 2 lc rgb '#000000'", "'radius of convergence, proved'") \
    .', '.key_entry("lines lw 1 lc rgb '#777777'", "'discs of the proof'")
entries = 3; letters = 30
load scripts.'/shared/panels.gp'
