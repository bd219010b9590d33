# Functions for the tables of studies of any equation: the axes of --set come before the study's columns, and the column
# `unknown` has the name of the row's unknown. The scripts are called with `stem`, the name of the study's files, and
# `equation`, that of the problem, in addition to the variables of style.gp.
load scripts.'/style.gp'

called = equation eq 'typed' ? 'the given equation' : problem_name(equation)
table_of(suffix) = data.'/'.stem.suffix.'.csv'
main = table_of('')
place(f, c) = ask(sprintf("head -n 1 '%s' | tr ',' '\\n' | grep -nxF -- '%s' | cut -d: -f1", f, c)) + 0
header(f, i) = ask(sprintf("head -n 1 '%s' | cut -d, -f%d", f, i))
# The values of the first k columns, one word "a,b," each; '-' if there is no axis.
cases(f, k) = k == 0 ? '-' : ask(sprintf("awk -F, 'NR > 1 { s = \"\"; for (i = 1; i <= %d; ++i) s = s $i \",\"; if (!n[s]++) print s }' '%s'", k, f))
# The number k of axes, which come before column c, and all their combinations, n of them.
axes_before(c) = sprintf("k = place(main, '%s') - 1; all = cases(main, k); n = words(all)", c)
in_case(c) = c eq '-' ? '1' : sprintf('index($0, "%s") == 1', c)
case_name(f, k, c) = c eq '-' ? '' : ask(sprintf("head -n 1 '%s' | cut -d, -f1-%d | awk -F, -v c=\"%s\" '{ split(c, v, \",\"); for (i = 1; i <= NF; ++i) s = s (i > 1 ? \", \" : \"\") $i \" = \" sprintf(\"%%.6g\", v[i]); print s }'", f, k, c))
of_unknown(f, u) = sprintf('$%d == "%s"', place(f, 'unknown'), u)
with_word(f, c, w) = sprintf('$%d == "%s"', place(f, c), w)
both(a, b) = '('.a.') && ('.b.')'
# The unknowns that are drawn, six at most, and a grid with one panel per unknown.
all_unknowns = seen(main, place(main, 'unknown'), '1')
drawn = smaller(words(all_unknowns), 6)
drawn_unknown(i) = word(all_unknowns, i)
left_out = words(all_unknowns) > 6 ? sprintf(' (the first 6 of %d unknowns)', words(all_unknowns)) : ''
unit_name(u) = 'unit of '.u
panel_w = drawn == 1 ? 900 : 520
panel_h = 440
# A figure with one panel per unknown. Curves are combinations of the parameters; without parameters, of the other
# distinguishing column.
text_of_column(f, c) = sprintf('%d', place(f, c))
span(f, c, where, otherwise, sign) = sign < 0 ? least(f, text_of_column(f, c), where, otherwise) : greatest(f, text_of_column(f, c), where, otherwise)
# Few tics for the values of a parameter.
quarters(which, a, b) = b > a ? sprintf("set %stics %.15g, %.15g, %.15g format '%%.4g'", which, a, (b - a) / 4.0, b) : ''
single_panel = 'set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6; unset key'
panel_of_unknown(p) = sprintf('u = drawn_unknown(%d); ', p).panel(p).'; '.single_panel.'; set title u offset 0, -0.5'
