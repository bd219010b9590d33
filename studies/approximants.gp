# approximants: error of asymptotic approximants against the order, one panel per problem; last the digits that the
# Vandermonde system loses.
#
# approximants of any equation with a known asymptotic behaviour: left the error against the order, one curve per
# combination of the parameters; right the error of the largest order against the parameter with the most values, one
# curve per method.
of_asymptotic = "is('method', 'asymptotic')"
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('order')
    eval first_cell('u', main, 'unknown', '1')
    eval extent('orders', main, 'order', '1')
    eval longest_axis('order')
    title_text = 'Asymptotic approximants of '.called
    below_text = 'largest error of '.u.' up to where the solution has its asymptotic form'
    panel_by = ''; width = 520; height = 400
    panels = words(axes) && values[longest] > 1 ? 'orders parameter' : 'orders'
    kinds = 'series pade asymptotic'
    kind_name(m) = approximation_name(m)
    y_name = 'log_{10} (max |error| / unit of '.u.')'
    eval extent('y', main, 'log10_norm', of_asymptotic)
    y_axis = "if (this eq 'orders') { set yrange [y_low - 1:y_high + 1] } else { set yrange [y_low - 1:*] }"
    x = 'order'
    over_orders = by_hue('log10_predicted', of_asymptotic, 'lines lw 1 dt 3 lc rgb colour(h, cases)').', '.by_hue('log10_norm', of_asymptotic, 'linespoints lw 1.8 pt mark_of(h) ps 0.6 lc rgb colour(h, cases)')
    by_kind = "linespoints lw 1.8 dt k pt mark[k] ps 0.7 lc rgb '#444444'"
    x = along
    over_parameter = 'for [k=1:3] '.rows(main, along, 'log10_norm', "is('method', word(kinds, k)) && at('order') == orders_high").' with '.by_kind
    x_axis = "if (this eq 'orders') { eval rising('x', orders_low, orders_high); set xlabel 'order N' } else { eval rising('x', x_low, x_high); set xlabel along_name }"
    prepare = "panel_title = this eq 'orders' ? 'against the order' : sprintf('at the order %.0f', orders_high); layers = this eq 'orders' ? over_orders : over_parameter"
    key = key_of_kinds(by_kind).', '.key_entry('lines lw 1 dt 3 lc rgb soft', "'predicted by its form, up to a factor'") \
        .', '.key_of_cases('linespoints lw 1.8 pt mark_of(h) ps 0.6 lc rgb colour(h, cases)')
    entries = shown_in_key(cases) + 4; letters = 28
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
figure = 'approximants'
table = data.'/approximants.csv'
losses = data.'/approximants_digits.csv'
title_text = 'Asymptotic approximants'
below_text = 'largest error up to where the solution has its asymptotic form'
panel_by = 'problem'
eval seen('panels', table, 'problem', '1')
eval seen('with_losses', losses, 'problem', '1')
if (words(with_losses) > 0) { panels = panels.' digits' }
height = 330; most_panels = 20
x = 'order'; x_name = 'order N'; y_name = 'log_{10} of the error'
digits_here = "panel_title = 'digits lost in double'; layers = lost; set key top left reverse Left; set xlabel 'number of exponentials'; set ylabel 'digits'; y_axis = 'set yrange [-1:*]'"
errors_here = "eval first_cell('u', table, 'unknown', of_panel('1')); panel_title = problem_name(this).', '.u; eval extent('a', table, 'log10_norm', of_panel(of_asymptotic)); eval extent('y', table, 'log10_norm', of_panel('1')); y_axis = sprintf('set yrange [%g:%g]', larger(a_low, -40) - 1, smaller(y_high, a_high + 6) + 1)"
prepare = "if (this eq 'digits') { eval digits_here } else { eval errors_here }"
style_of(m) = m eq 'series' ? 'lines lw 2 dt 2 lc rgb shade[5]' : m eq 'pade' ? 'lines lw 1.5 dt 4 lc rgb shade[3]' : 'linespoints pt 7 ps 0.5 lw 2 lc rgb shade[4]'
predicted_style = "lines lw 1.8 dt 3 lc rgb '#444444'"
layers = once('log10_norm', "is('method', 'series')", style_of('series')).', '.once('log10_norm', "is('method', 'pade')", style_of('pade')) \
    .', '.once('log10_predicted', of_asymptotic, predicted_style).', '.once('log10_norm', of_asymptotic, style_of('asymptotic'))
errors_here = errors_here.'; layers = errors'
errors = layers
lost = 'for [i=1:words(with_losses)] '.rows(losses, 'terms', 'lost_digits', "is('problem', word(with_losses, i))").' with linespoints pt mark_of(i) ps 0.7 lw 1.8 lc rgb shade[i] title problem_name(word(with_losses, i))' \
    .", 15.95 with lines lw 1.2 dt 3 lc rgb soft title 'digits of double'"
key = key_entry(style_of('series'), "'series'").', '.key_entry(style_of('pade'), "'Padé'") \
    .', '.key_entry(style_of('asymptotic'), "'asymptotic approximant'").', '.key_entry(predicted_style, "'predicted by its form, up to a factor'")
entries = 4; letters = 28
load scripts.'/shared/panels.gp'
