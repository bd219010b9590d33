# domb_sykes: the plots in the power of t that symmetry leaves, and the results of radius tests for the same lists.
#
# For any equation: ratios of the coefficients against 1/n, one panel per unknown, one colour per combination of the
# parameters; the intercept and the straight line that follow from the verdict of the longest list.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    load scripts.'/shared/ratio_fit.gp'
    intercepts = table_of('_intercepts')
    eval equation_panels('power')
    always = "at('n') >= 4"
    title_text = 'Domb-Sykes plot of '.called
    below_text = 'ratios of coefficients about the start'
    x = 'inverse_n'; x_name = '1/n'; x_axis = 'set xrange [0:0.26]'; height = 490
    # The fit of each combination, from the last verdict of its unknown, and what the panel states about the first.
    verdict = "is('method', 'verdict') && is('unknown', this)".(hue_by eq '' ? '' : ' && '.cells_of(hue_by).' eq word(hues, h)')
    array level[cases]
    array slope[cases]
    array half_width[cases]
    fit_here = "eval first_cell('q', table, 'power', of_hue('1')); q = larger(1, number('0'.q)); do for [c in 'radius uncertainty position_re position_im count exponent'] { eval last_cell('v_'.c, intercepts, c, verdict) }; level[h] = fit_of(q, v_radius, v_position_re, v_position_im, v_count); slope[h] = fit_slope(q, level[h], v_exponent); half_width[h] = fit_uncertainty(q, level[h], v_radius, v_uncertainty); if (level[h] != level[h] && strlen(v_radius)) { scattered = larger(scattered, number(v_radius) ** -q) }; if (h == 1) { y_name = sprintf('a_n/a_{n−%d}', int(q)); panel_title = this.\"\\n{/*0.8 \".(cases > 1 ? case_name(word(hues, 1)).': ' : '').fit_in_words(v_radius, v_uncertainty, v_exponent).\"}\\n{/*0.8 \".intercept_in_words(level[1], v_radius, v_uncertainty).'}' }"
    prepare = "set tmargin 5; set lmargin 11; scattered = 0; do for [h=1:cases] { eval fit_here }; eval extent('y', table, 'ratio', of_panel('1'))"
    y_axis = "if (scattered > 0) { set yrange [-2.5 * scattered:2.5 * scattered] } else { eval rising('y', larger(y_low, -1e30), smaller(y_high, 1e30)) }"
    layers = "for [h=1:cases] level[h] * (1 + slope[h] * x) with lines lw 1.5 lc rgb cases < 2 ? '#999999' : tone(h)" \
        .', '.by_hue('ratio', '1', 'points pt mark_of(h) ps 0.6 lc rgb tone(h)') \
        .", for [h=1:cases] '+' using (0):(visible(level[h])):(half_width[h]) every ::0::0 with yerrorbars pt 7 ps 0.9 lw 2 lc rgb '#D55E00'"
    key = key_entry('points pt mark_of(1) ps 0.8 lc rgb cases < 2 ? tone(1) : soft', "'ratio'") \
        .', '.key_entry("lines lw 1.5 lc rgb '#999999'", "'line of radius and exponent'") \
        .', '.key_entry("points pt 7 ps 0.9 lc rgb '#D55E00'", "'intercept with its interval'").', '.key_of_cases('points pt mark_of(h) ps 0.8 lc rgb tone(h)')
    entries = shown_in_key(cases) + 3; letters = 26
    load scripts.'/shared/proved_line.gp'
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
figure = 'domb_sykes'
table = data.'/domb_sykes.csv'
lists = data.'/domb_sykes_lists.csv'
title_text = 'Domb-Sykes plots: ratios of coefficients times the exact R^p, in t^p'
below_text = 'in t itself every other ratio is 0 or not defined where the solution is odd or even'
# The plots in the largest power of each energy and point, whose marks at the left edge are the exact intercepts.
panel_by = 'point'; most_panels = 6; most_across = 2; height = 450
hue_by = 'energy'
eval seen('hues', table, 'energy', '1')
eval energy_names(table)
# Where a symmetry leaves another power than in the rest of the panel, it is in the key.
hue_name(E) = 'E = '.named_energy(E).(power_of_list(E) == 2 ? '' : sprintf(', in t^%d', power_of_list(E)))
about(p) = p eq '0' ? 'About the top' : p eq '1' ? 'About the bottom' : 'About '.p.' T*'
n = words(hues)
array power[n]
array limit[n]
array top_power[n]
power_of_list(E) = (found_ = 2, sum [i_=1:n] (word(hues, i_) eq E ? (found_ = top_power[i_]) : 0, 0), found_)
do for [h=1:n] { eval last_cell('cell', lists, 'power', "is('energy', word(hues, h)) && is('point', '0')"); top_power[h] = cell eq '' ? 2 : cell + 0 }
x = 'inverse_n'; x_name = '1/n'; y_name = 'a_n/a_{n−p} · R^p'
eval extent('n', table, 'n', '1')
widest = n_high >= 12 ? 0.21 : 0.55
x_axis = 'set xrange [0:widest]'
edge = 2.95               # ratios beyond it are not drawn, but counted in the panel
beyond(h) = of_hue(sprintf("column('power') == %d && has('scaled_ratio') && at('inverse_n') > 0 && at('log10_scaled_ratio') > %g", power[h], log10(edge)))
plot_here = "eval last_cell('cell', lists, 'power', of_hue('1')); power[h] = cell + 0; eval last_cell('cell', lists, 'limit', of_hue('1')); limit[h] = cell eq '' ? NaN : cell + 0; if (limit[h] == limit[h] && limit[h] != 0) { straight = straight + 1; total = total + limit[h]; set label 10 + h '' at 0, limit[h] point pt 13 ps 1.8 lc rgb '#D55E00' front } else { limit[h] = NaN }; eval last_cell('cell', lists, 'undefined', of_hue('1')); undefined = undefined + cell"
prepare = "straight = 0; total = 0; undefined = 0; outside = 0; do for [h=1:n] { eval plot_here; eval count_of('cell', table, beyond(h)); outside = outside + cell }; set tmargin 3.2; panel_title = about(this).', '.(power[1] == 1 ? 'in t' : sprintf('in t^%d', power[1])).\"\\n{/*0.85 \".(straight == n ? '' : straight == 0 ? 'a pair is nearest: no intercept' : 'a pair is nearest where there is no intercept').(undefined ? (straight == n ? '' : '; ').'× at the lower edge: not defined, divided by 0' : '').(outside ? sprintf('; %d ratios beyond ±3 are not drawn', outside) : '').' }'"
y_axis = "if (straight == n && abs(total) == n && !undefined) { set yrange [total < 0 ? -1.25 : -0.25:total < 0 ? 0.25 : 1.25] } else { set yrange [-3:3] }"
finish = 'do for [h=1:n] { unset label 10 + h }'
clipped = sprintf("(at('log10_scaled_ratio') > %g ? NaN : at('scaled_ratio'))", log10(edge))
in_power = "column('power') == power[h] && has('scaled_ratio')"
layers = "1 with lines lc rgb '#bbbbbb' lw 0.8, -1 with lines lc rgb '#bbbbbb' lw 0.8" \
    .", for [h=1:n] limit[h] * (1 - power[h] * x) with lines lw 5 lc rgb '#dddddd'" \
    .', '.by_hue(clipped, in_power, 'points pt mark_of(h) ps 0.9 lw 1.3 lc rgb colour(h, n)') \
    .', '.by_hue('(-2.55 - smaller(0.09, 0.4 / n) * (h - 1))', "column('power') == power[h] && !has('scaled_ratio')", 'points pt 2 ps 0.35 lw 1 lc rgb colour(h, n)')
key = key_of_hues('points pt mark_of(h) ps 0.9 lw 1.3 lc rgb colour(h, n)').', '.key_entry("points pt 13 ps 1.6 lc rgb '#D55E00'", "'exact: ±1'") \
    .', '.key_entry("lines lw 5 lc rgb '#dddddd'", "'slope of a logarithm'")
entries = shown_in_key(n) + 2
load scripts.'/shared/panels.gp'

# The results of the tests for the same lists.
figure = 'domb_sykes_intercepts'
table = data.'/domb_sykes_intercepts.csv'
listed_methods = 'ratio-in-power domb-sykes mercer-roberts verdict'
title_text = 'Relative error of R by the tests, from N coefficients'
with_uncertainties = 0
load scripts.'/shared/test_results.gp'
