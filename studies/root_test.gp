# root_test: error of |a_n|^(-1/n) and of |n a_n|^(-1/n) against n, and the results of the tests by size.
#
# For any equation: the roots of the coefficients against 1/n, one panel per unknown, one colour per combination of the
# parameters; lines at the verdict of the longest list.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('n')
    always = "at('n') >= 4"
    title_text = 'Root test of '.called
    below_text = 'roots of the coefficients about the start'
    x = 'inverse_n'; x_name = '1/n'; x_axis = 'set xrange [0:0.26]'; y_name = 'radius / unit of the variable'
    # The verdict of the longest list, as the last of its rows is drawn on top.
    estimates = table_of('_estimates')
    eval extent('orders', estimates, 'order', '1')
    always_of_rows = always
    always = "is('method', 'verdict') && at('order') == orders_high"
    levels = sprintf("for [h=1:words(hues)] '%s' using (kept(%s, 0)):(shown_y(%s, at('radius'))):(0.26):(0)", estimates, of_hue('1'), of_hue('1')).' with vectors nohead lw 1.5 lc rgb '."cases < 2 ? '#888888' : tone(h) notitle"
    always = always_of_rows
    layers = levels.', '.by_hue('root', '1', 'points pt 6 ps 0.6 lc rgb tone(h)').', '.by_hue('corrected', '1', 'points pt 2 ps 0.5 lc rgb tone(h)')
    key = key_entry('points pt 6 ps 0.8 lc rgb soft', "'|a_n|^{−1/n}'").', '.key_entry('points pt 2 ps 0.8 lc rgb soft', "'|n a_n|^{−1/n}'") \
        .', '.key_entry("lines lw 1.5 lc rgb '#888888'", "'verdict of all tests'").', '.key_of_cases('lines lw 2.4 lc rgb tone(h)')
    entries = shown_in_key(cases) + 3; letters = 20
    # With --prove: the radius of the law, and the roots that it predicts.
    eval column_in(main, 'proved_radius')
    if (has_column) {
        layers = layers.', '.by_hue('proved_radius', "has('proved_radius')", "lines lw 2 lc rgb cases < 2 ? '#D55E00' : tone(h)") \
            .', '.by_hue('law_root', "has('law_root')", 'points pt 6 ps 1.1 lc rgb tone(h)')
        key = key.', '.key_entry("lines lw 2 lc rgb '#D55E00'", "'proved radius'").', '.key_entry('points pt 6 ps 1.1 lc rgb soft', "'root by the law alone'")
        entries = entries + 2
    }
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
figure = 'root_test'
table = data.'/root_test.csv'
title_text = 'The root test, plain and corrected, against the exact radius'
panel_by = 'point'; most_panels = 4; rows_down = 2; height = 350
hue_by = 'energy'
eval seen('hues', table, 'energy', '1')
eval energy_names(table)
hue_name(E) = 'E = '.named_energy(E)
x = 'n'; x_name = 'n'
eval extent('x', table, 'n', '1')
x_axis = "set logscale x; set xtics (2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000); set xrange [2:x_high * 1.15]; set samples 600"
eval extent('errors', table, 'log10_root_error log10_corrected_error', '1')
y_name = 'log_{10} |relative error|'
y_axis = 'set yrange [row == 1 ? -4 : -5 : larger(errors_high, 0.2) + 0.3]'
about(p) = p eq '0' ? 'About the top' : p eq '1' ? 'About the bottom' : 'About '.p.' T*'
log10_of(y) = y == 0 ? NaN : log10(abs(y))
prepare = "eval first_cell('cell', table, 'amplitude', of_panel('1')); A = int(number(cell)); panel_title = about(this).(row == 1 ? ': |a_n|^{−1/n}' : ': |n a_n|^{−1/n}'); set label 2 row == 1 ? 'grey: ln n/n' : sprintf('grey: ln A/n, A = %d', A) at graph 0.98, 0.94 right textcolor rgb soft; set label 3 row == 1 ? sprintf('dotted: (n/A)^{1/n} − 1, A = %d', A) : 'dotted: 1 − A^{−1/n}' at graph 0.98, 0.855 right textcolor rgb soft; layers = grey.', '.points_of_row"
finish = 'unset label; unset logscale; set xtics autofreq'
grey = "log10_of(row == 1 ? log(x) / x : log(A) / x) with lines lw 5 lc rgb '#dddddd', log10_of(row == 1 ? (x / A)**(1 / x) - 1 : 1 - A**(-1 / x)) with lines lw 1.2 dt 3 lc rgb '#555555'"
points_of_row = by_hue("row == 1 ? at('log10_root_error') : at('log10_corrected_error')", '1', 'points pt mark_of(h) ps 0.7 lw 1.2 lc rgb colour(h, words(hues))')
key = key_of_hues('points pt mark_of(h) ps 0.7 lw 1.2 lc rgb colour(h, words(hues))')
entries = shown_in_key(words(hues)); letters = 14
load scripts.'/shared/panels.gp'

# The results of the tests by size: lines are errors, thin ones uncertainties.
figure = 'root_test_estimates'
table = data.'/root_test_estimates.csv'
listed_methods = 'root root-corrected top-line verdict'
title_text = 'Relative error (marks) and uncertainty (thin lines) of R, from N coefficients'
with_uncertainties = 1
load scripts.'/shared/test_results.gp'
