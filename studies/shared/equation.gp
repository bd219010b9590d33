# Tables of studies of any equation: the axes of --set come before the study's columns, and the column `unknown` has the
# name of the row's unknown. The scripts are called with `stem`, the name of the study's files, and `equation`, that of
# the problem, in addition to the variables of style.gp.
load scripts.'/style.gp'

# Whether a table has a column: has_column = 1 or 0.
column_in(table, c) = sprintf("has_column = 0; i_ = 1; header_ = ' '; while (header_ ne '') { stats '%s' every ::0::0 using (header_ = columnhead(i_), 0) nooutput; has_column = has_column || header_ eq '%s'; i_ = header_ eq '' ? i_ : i_ + 1 }", table, c)
called = equation eq 'typed' ? 'the given equation' : problem_name(equation)
table_of(suffix) = data.'/'.stem.suffix.'.csv'
main = table_of('')
# A panel for each unknown, six at most, and a colour for each combination of the axes, which come before column c.
header(i) = sprintf("stats main every ::0::0 using (header_ = columnhead(%d), 0) nooutput", i)
axes_before(c) = sprintf("axes = ''; axis_numbers = ''; i_ = 1; header_ = ''; eval header(1); while (header_ ne '%s' && header_ ne '') { axes = axes.' \"'.header_.'\"'; axis_numbers = axis_numbers.' '.i_; i_ = i_ + 1; eval header(i_) }", c)
case_name(v) = case_from(v, 1)
case_from(v, i) = (comma_ = strstrt(v, ',')) ? word(axes, i).' = '.tidy(v[1:comma_ - 1]).', '.case_from(v[comma_ + 1:*], i + 1) : word(axes, i).' = '.tidy(v)
hue_name(v) = hue_by eq '' ? '' : case_name(v)
tone(h) = words(hues) == 1 ? shade[5] : colour(h, words(hues))
equation_panels(c) = axes_before(c)."; figure = stem; table = main; panel_by = 'unknown'; most_panels = 6; eval seen('panels', main, 'unknown', '1'); width = words(panels) > 1 ? 520 : 900; y_name_everywhere = 1; hue_by = axis_numbers; hues = '-'; if (axes ne '') { eval seen_together('hues', main, axis_numbers, '1') }; cases = words(hues)"
# The same for the first combination of the axes alone.
first_case(c) = equation_panels(c)."; in_first = ''; if (axes ne '') { only = word(hues, 1); always = cells_of(axis_numbers).' eq only'; in_first = ', '.case_name(only) }; hues = ''; hue_by = ''"
# The axis with the most values, as the column `along` called `along_name`, or column c without axes; the numbers of
# values; then the other axes as colours, and a column c, or '', whose values are called NAME.
longest_axis(c) = "array values[words(axes) + 1]; longest = 1; do for [i=1:words(axes)] { eval seen('some', main, sprintf('%d', i), '1'); values[i] = words(some); longest = values[i] > values[longest] ? i : longest }; along = words(axes) ? sprintf('%d', longest) : '".c."'; along_name = words(axes) ? word(axes, longest) : '".c."'"
other_axes(c, name) = "hue_by = ''; names = ''; do for [i=1:words(axes)] { if (i != longest) { hue_by = hue_by.sprintf(' %d', i); names = names.' \"'.word(axes, i).'\"' } }; if ('".c."' ne '' && along ne '".c."') { hue_by = hue_by.' ".c."'; names = names.' ".name."' }; axes = names; hues = '-'; if (hue_by ne '') { eval seen_together('hues', main, hue_by, '1') }"
# Names of combinations in the key, if there are several.
key_of_cases(style) = hue_by eq '' ? key_entry('lines', "''") : key_of_hues(style)
# The rate of a series, the column of `radii`, as a line from the order 0 on.
rate_lines(radii, style) = sprintf("for [h=1:words(hues)] '%s' using (kept(%s, 0)):(shown_y(%s, 0)):(x_high):(x_high * log10(column('rate'))) with vectors nohead %s notitle", radii, of_hue("has('rate')"), of_hue("has('rate')"), style)
