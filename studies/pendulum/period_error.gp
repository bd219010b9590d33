# period_error: for one energy or two, the error of T* against the order, with its bounds and its rate; otherwise
# against the energy, and towards the separatrix on either side.
load scripts.'/style.gp'
figure = 'period_error'
table = data.'/period_error.csv'
eval seen('energies', table, 'energy', '1')
eval energy_names(table)
kind_by = 'method'; kinds = 'series resummed'
kind_name(m) = approximation_name(m)
y_name = 'log_{10} (|error of T*| / (ℓ/g)^{1/2})'
if (words(energies) <= 2) {
    title_text = 'Convergence of T* by the series of K and by its resummation'
    below_text = 'm = E/2 below E = 2 and 2/E above it'
    panel_by = 'energy'; most_across = 2
    hue(k) = shade[k == 1 ? 5 : 4]
    # log10 of m, the parameter of K: E/2 below E = 2 and 2/E above; by the gap, as E may be a long decimal.
    parameter(e, g) = g[1:1] eq '-' ? log10(2 / (2 - number(g))) : log10(number(tidy(e)) / 2)
    prepare = "rate = parameter(this, gap_of(this)); panel_title = 'E = '.named_energy(this).sprintf(', rate m = %.4g', 10**rate)"
    x = 'order'; x_name = 'order N'; y_axis = "eval extent('y', table, 'log10_error', of_panel('1')); eval rising('y', y_low, y_high)"
    line = 'linespoints lw 2.2 dt 3 - k pt 7 ps 0.6 lc rgb hue(k)'
    layers = "x * rate with lines lw 1.2 dt 5 lc rgb '#444444', ".curves('log10_error', '1', line).', '.curves('log10_bound', '1', 'points pt 2 ps 0.7 lc rgb hue(k)')
    key = key_of_kinds(line).', '.key_entry('points pt 2 ps 0.7 lc rgb soft', "'proved bound'").', '.key_entry("lines lw 1.2 dt 5 lc rgb '#444444'", "'rate m^N'")
    entries = 4; letters = 12
} else {
    title_text = 'Error of T* from the series of K and from its resummation'
    hue_by = 'order'; hue_name(N) = 'N = '.N
    eval seen('hues', table, 'order', '1')
    n = words(hues)
    y_columns = 'log10_error'
    load scripts.'/shared/energies.gp'
    y_least = -40
    if (strstrt(panels, 'tion')) { below_text = 'bars on the right: 1/(8N + 7), where the resummation stays at E = 2' }
    limit(N) = log10(1.0 / (8 * N + 7))
    prepare = prepare."; if (this ne 'energy') { do for [i=1:n] { set arrow from graph 0.965, first limit(word(hues, i) + 0) to graph 1, first limit(word(hues, i) + 0) nohead lw 3.5 lc rgb colour(i, n) } }"
    line = (words(energies) > 20 ? 'lines' : 'linespoints pt 7 ps 0.5').' lw 2 dt 3 - k lc rgb colour(h, n)'
    # Of many energies the bounds of every fourth.
    crossed = words(energies) > 20 ? sprintf('int(column(0) / %d) %% 4 == 0', 2 * n) : '1'
    layers = curves('log10_error', '1', line).', '.curves('log10_bound', crossed, 'points pt 2 ps 0.6 lc rgb colour(h, n)')
    key = key_of_hues('lines lw 2.4 lc rgb colour(h, n)').', '.key_of_kinds('lines lw 2 dt 3 - k lc rgb soft') \
        .', '.key_entry('points pt 2 ps 0.6 lc rgb soft', "'proved bound'")
    entries = shown_in_key(n) + 3; letters = 12
}
load scripts.'/shared/panels.gp'
