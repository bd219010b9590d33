# uniform: error of the uniform resummation against the energy, for E < 1, 1 < E < 2 and E > 2, or for one energy or two
# against the number of coefficients.
load scripts.'/style.gp'
figure = 'uniform'
exact = data.'/uniform.csv'
rounded = data.'/uniform_double.csv'
eval seen('energies', exact, 'energy', '1')
eval energy_names(exact)
eval extent('exact', exact, 'log10_norm', '1')
eval extent('rounded', rounded, 'log10_norm', '1')
y_axis = "eval rising('y', smaller(exact_low, rounded_low), smaller(larger(exact_high, rounded_high), 2.5))"
y_name = norm_axis; height = 500
in_double(where, style) = rows(rounded, x, 'log10_norm', of_panel(where)).' with '.style." lc rgb '#333333'"
if (words(energies) <= 2) {
    eval first_cell('scalar', exact, 'scalar', '1')
    title_text = 'Convergence of the uniform resummation on [0, T*]'
    below_text = in_arithmetic(scalar).' and in double'
    table = exact; panel_by = 'energy'; most_across = 2
    prepare = "eval first_cell('rate', table, 'rate', of_panel('1')); panel_title = 'E = '.named_energy(this).sprintf(', rate %.4g a coefficient', number(rate)); set arrow from graph 0, first -15.65 to graph 1, first -15.65 nohead lc rgb '#888888' lw 1.2 dt 4"
    x = 'count'; x_name = 'coefficients that are not 0'
    line = 'linespoints pt 7 ps 0.6 lw 2.2 lc rgb shade[5]'
    layers = once('log10_bound', '1', 'lines lw 1.5 dt 3 lc rgb shade[5]').', '.once('log10_norm', '1', line).', '.in_double('1', 'points pt 6 ps 1 lw 1.3')
    key = key_entry(line, "'uniform'").', '.key_entry('lines lw 1.5 dt 3 lc rgb shade[5]', "'proved bound (U)'") \
        .', '.key_entry("points pt 6 ps 1 lw 1.3 lc rgb '#333333'", "'in double'").', '.key_entry("lines lw 1.2 dt 4 lc rgb '#888888'", "'ε of double'")
    entries = 4
} else {
    title_text = 'Error of the uniform resummation on [0, T*] by its number of coefficients'
    below_text = 'the same accuracy at every energy: from rest over the separatrix to fast rotation'
    table = exact
    part = "(".rotates." ? 'rotation' : at('log10_energy') > 0 ? 'libration' : 'rest')"
    do for [this in 'rest libration rotation'] {
        eval seen('some', exact, 'energy', part.' eq this')
        panels = panels.(words(some) > 1 ? ' '.this : '')
    }
    if (panels eq '') { panels = 'rest libration rotation' }
    always = part.' eq this'
    hue_by = 'count'; hue_name(count) = count.' coefficients'
    eval seen('hues', exact, 'count', '1')
    n = words(hues)
    drawn = listed(hues, '16') ? '16' : word(hues, 1)
    tone(h) = n <= 6 ? shade[word('4 3 5 2 1 6', h) + 0] : colour(h, n)     # neighbours far apart
    x = "this eq 'rest' ? at('log10_energy') : at('log10_gap')"
    x_axis = "eval extent('x', exact, this eq 'rest' ? 'log10_energy' : 'log10_gap', always); if (this eq 'rest') { eval rising('x', x_low, x_high); set xlabel 'log_{10} (E / (m g ℓ))' } else { eval falling('x', x_low, x_high); set xlabel gap_axis }"
    prepare = "panel_title = this eq 'rest' ? 'towards rest' : this eq 'libration' ? 'libration, E < 2' : 'rotation, E > 2'"
    layers = by_hue('log10_bound', '1', 'lines lw 1.5 dt 3 lc rgb tone(h)').', '.by_hue('log10_norm', '1', 'linespoints pt 7 ps 0.35 lw 2.2 lc rgb tone(h)') \
        .', '.in_double("is('count', drawn)", 'points pt 6 ps 0.6')
    key = key_of_hues('lines lw 2.4 lc rgb tone(h)').', '.key_entry("points pt 6 ps 0.8 lc rgb '#333333'", "drawn.', in double'") \
        .', '.key_entry('lines lw 1.5 dt 3 lc rgb soft', "'proved bound (U)'")
    entries = shown_in_key(n) + 2
}
load scripts.'/shared/panels.gp'
