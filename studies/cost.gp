# cost: multiplications and time of each route against the order, and the differences between the routes.
#
# For any equation: multiplications and seconds against the order, for the first combination of the parameters.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval first_case('order')
    times = table_of('_time')
    title_text = 'Cost of the coefficients of '.called
    below_text = 'all unknowns up to the order'.in_first
    panel_by = ''; panels = 'multiplications time'; width = 520
    kind_by = 'route'; kind_name(r) = 'about the '.r
    eval seen('kinds', main, 'route', '1')
    eval seen('scalars', times, 'scalar', '1')
    x = 'order'; x_name = 'order N'
    eval seen('orders', main, 'order', '1')
    x_axis = "set logscale x; set xtics (); do for [N in orders] { set xtics add (N N + 0) }; set xrange [x_low / 1.2:x_high * 1.2]"
    prepare = "set offsets; panel_title = this; if (p == 1) { y_name = 'multiplications / N^2'; y_axis = 'set yrange [0:*]'; layers = products } else { y_name = 'log_{10} (time / s)'; y_axis = ''; layers = seconds }"
    finish = 'unset logscale; set xtics autofreq'
    line = 'linespoints lw 1.8 dt k pt mark[k] ps 0.8 lc rgb '
    products = curves("at('multiplications') / at('order')**2", '1', line."'#000000'")
    table = times
    hue_by = 'scalar'; hues = scalars; hue_name(s) = arithmetic_name(s)
    seconds = curves('log10_seconds', '1', line.'shade[h + 2]')
    table = main
    key = key_of_kinds(line."'#000000'").', '.key_of_hues('lines lw 2.4 lc rgb shade[h + 2]')
    entries = 1 + words(hues) * words(kinds); letters = 18
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
table = data.'/cost.csv'
timed = data.'/cost_time.csv'
# The energy with the most routes, the first if there are several.
eval seen('energies', table, 'energy', "has('multiplications')")
energy = word(energies, 1)
most_routes = 0
do for [e in energies] {
    eval seen('some', table, 'route', "is('energy', e) && has('multiplications')")
    if (words(some) > most_routes) { most_routes = words(some); routes = some; energy = e }
}
always = "is('energy', energy)"
eval seen('multiplying', table, 'route', always." && at('multiplications') > 0")
eval seen('losing', table, 'route', always." && has('expected_growth')")
keeping = ''
do for [r in routes] { keeping = keeping.(listed(losing, r) ? '' : ' "'.r.'"') }
# Number of products of each route in units of N^2.
constant(r) = r eq 'direct' ? 1 : r eq 'direct_parity' ? 0.5 : r eq 'arcsine' ? 1.5 : r eq 'arcsine_parity' ? 0.375 : r eq 'convolution' ? 0.5 : (r eq 'speed' || r eq 'symmetric_squares') ? 0.1875 : NaN
hue(r) = r[1:6] eq 'direct' ? shade[4] : r[1:7] eq 'arcsine' ? shade[2] : r eq 'speed' ? shade[3] : r eq 'symmetric_squares' ? shade[5] : r eq 'convolution' ? shade[1] : shade[6]
dash(r) = (strstrt(r, 'parity') || r eq 'running_sums') ? 2 : 1
sign(r) = r eq 'direct' ? 4 : r eq 'direct_parity' ? 5 : r eq 'arcsine' ? 8 : r eq 'arcsine_parity' ? 9 : r eq 'speed' ? 6 : r eq 'symmetric_squares' ? 2 : r eq 'convolution' ? 12 : r eq 'running_sums' ? 10 : 1
hue_name(r) = r eq 'direct' ? 'direct recurrence' : r eq 'direct_parity' ? 'direct recurrence, parity' : r eq 'arcsine' ? 'arcsine of Jacobi' : r eq 'arcsine_parity' ? 'arcsine of Jacobi, parity' : r eq 'speed' ? 'ω alone' : r eq 'symmetric_squares' ? 'symmetric squares' : r eq 'convolution' ? 'resummation: convolution' : r eq 'running_sums' ? 'resummation: running sums' : 'resummation: α, β'
line = 'linespoints lw 2 dt dash(word(hues, h)) pt sign(word(hues, h)) lc rgb hue(word(hues, h))'

figure = 'cost'
title_text = 'What the coefficients up to the order N cost (E = '.number_name(energy).')'
below_text = 'thin lines: constant · N^2'
panels = 'multiplications time'; y_name_everywhere = 1; height = 470
hue_by = 'route'; hues = routes; eval seen('orders', table, 'order', '1')
x = 'order'; x_name = 'order N'
x_axis = "set logscale xy; set xtics (); do for [i=1:words(orders):(words(orders) + 7) / 8] { set xtics add (word(orders, i) word(orders, i) + 0) }; set xrange [x_low / 1.3:x_high * 1.3]"
prepare = "set offsets; panel_title = ''; if (p == 1) { y_name = 'multiplications of two numbers, count'; set format y '10^{%T}'; y_axis = 'set yrange [1:*]'; layers = products } else { y_name = 'time / that of the direct recurrence'; set format y '%g'; y_axis = 'set yrange [*:4]'; layers = times }"
finish = 'unset logscale; set xtics autofreq'
products = 'for [r in multiplying] constant(r) * x**2 with lines lw 1 dt 3 lc rgb hue(r), '.by_hue('multiplications', "at('multiplications') > 0", line)
table = timed
times = by_hue('ratio', '1', line)
table = data.'/cost.csv'
key = 'for [h=1:words(hues)] '.key_entry(line, "hue_name(word(hues, h)).(listed(multiplying, word(hues, h)) ? '' : ' (no products)')")
entries = words(hues); letters = 26
load scripts.'/shared/panels.gp'

# Differences between the routes: left those that lose digits with the order, right the stable ones.
figure = 'cost_difference'
title_text = 'Rounding errors of the routes (E = '.number_name(energy).')'
below_text = 'the largest difference of a coefficient from its value with 30 digits more'
always = "is('energy', energy)"
panels = (words(losing) > 0 ? 'unstable ' : '').(words(keeping) > 0 ? 'stable' : '')
hue_by = 'route'; hues = routes
x = 'order'; x_name = 'order N'; y_name = 'log_{10} (largest difference)'; most_across = 2
in_this = "(this eq 'unstable') == (listed(losing, strcol('route')) > 0)"
y_axis = "eval extent('y', table, 'log10_difference', both(always, in_this)); eval rising('y', y_low, y_high)"
prepare = "panel_title = this; layers = differences.(this eq 'unstable' ? growth : '')"
differences = by_hue('log10_difference', in_this, line)
eval first_cell('start', table, 'log10_difference', always." && has('expected_growth')")
eval first_cell('growth_start', table, 'expected_growth', always." && has('expected_growth')")
growth = ', '.once("at('expected_growth') + number(start) - number(growth_start)", "is('route', word(losing, 1))", "lines lw 1.5 dt 3 lc rgb '#000000'")
key = key_of_hues(line).', '.key_entry("lines lw 1.5 dt 3 lc rgb '#000000'", "words(losing) > 0 ? '(R/K̃′)^N' : ''")
entries = words(hues) + 1; letters = 24
load scripts.'/shared/panels.gp'
