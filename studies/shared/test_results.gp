# What radius tests make of lists of the pendulum's coefficients, against the order: one row per expansion point, one
# column per method, one curve per energy. Before it is loaded: `table` (energy,point,order,method,radius,uncertainty,
# exact,relative_error,log10_relative_error,log10_relative_uncertainty,note), `figure`, `listed_methods`, `title_text`
# `with_uncertainties`, and energy_names of a table with gaps.
eval seen('points', table, 'point', '1')
panels = ''
do for [m in listed_methods] {
    eval count_of('answers', table, sprintf("is('method', '%s') && has('log10_relative_error')", m))
    if (answers > 0) { panels = panels.' '.m }
}
panel_by = 'method'
rows_down = smaller(words(points), 6)
always = "is('point', point)"
point = word(points, 1)
hue_by = 'energy'
eval seen('hues', table, 'energy', '1')
about(p) = p eq '0' ? 'Top' : p eq '1' ? 'Bottom' : p.' T*'
x = 'order'; x_name = 'order N'; y_name = 'log_{10} (|error|/R)'; width = words(panels) < 3 ? 460 : 330; height = 300
x_axis = 'set xrange [0:orders_high * 1.04]; set xtics step_of(orders_high / 2)'
eval extent('orders', table, 'order', '1')
y_axis = "set yrange [low:with_uncertainties && this ne 'verdict' ? 1 : 2]"
low_of(cell) = int(smaller(with_uncertainties ? -3 : -4, cell)) - 2
# An error 0 is drawn at the lower edge.
error_drawn = "is('log10_relative_error', '-inf') ? low : at('log10_relative_error')"
prepare = "point = word(points, row); eval extent('y', table, 'log10_relative_error', with_uncertainties && this eq 'verdict' ? \"is('method', 'verdict')\" : with_uncertainties ? \"!is('method', 'verdict')\" : '1'); low = low_of(y_low); panel_title = about(point).': '.test_name(this); eval count_of('answers', table, of_panel(\"has('log10_relative_error')\")); if (!answers) { set label 2 \"does not apply\\nto these lists\" at graph 0.5, 0.55 center textcolor rgb soft }"
finish = 'unset label 2'
layers = by_hue(error_drawn, "has('log10_relative_error')", 'linespoints lw 1.8 dt line_of(h) pt mark_of(h) ps 0.8 lc rgb colour(h, words(hues))')
if (with_uncertainties) { layers = by_hue('log10_relative_uncertainty', '1', 'lines lw 1 dt 3 lc rgb colour(h, words(hues))').', '.layers }
key = key_of_hues('linespoints lw 1.8 dt line_of(h) pt mark_of(h) ps 0.8 lc rgb colour(h, words(hues))')
entries = shown_in_key(words(hues)); letters = 14
load scripts.'/shared/panels.gp'
