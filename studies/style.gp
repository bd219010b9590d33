# The common style of all figures, and the functions by which their scripts read tables. A script is called with `data`
# (directory of the CSV), `tables` (the names of all CSV), `target` (of the drawings) and `scripts` (this directory), loads
# this file, and draws once for each name in `terminals`. Axes, panels and keys follow from the tables: no script depends
# on the default parameters.
#
# Conventions: energies, times and orders increase to the right; log10 |2 - E| decreases to the right, towards the
# separatrix; errors are log10 of radians and increase upwards. The series is dashed, its resummation solid, proved or
# predicted quantities dotted, as listed in the key.

# The initial settings of every figure; `eval restart` between two. A row that was filtered out does not break a line.
restart = "reset; set encoding utf8; set minussign; set datafile separator ','; set datafile missing NaN; set datafile columnheaders; set border 3 lc rgb '#444444'; set tics nomirror out textcolor rgb '#222222'; set grid ytics lc rgb '#dddddd' lw 0.7; set key textcolor rgb '#222222' samplen 2.2 spacing 1.1"
eval restart
# The end of a figure of several panels.
figure_done = 'unset multiplot; unset output; '.restart

if (!exists('terminals')) { terminals = 'svg pdf png' }
# Lengths are in points of the screen, 160 per inch on paper: a figure of 1180 points is as wide as a page, with letters
# of 6.3 points in print. PNG has 300 dots per inch.
per_inch = 160.0
if (!exists('dots')) { dots = 300 / per_inch }
print = 72 / per_inch
# use_terminal(kind, file, width, height)
use_terminal(kind, file, w, h) = kind eq 'svg' \
    ? sprintf("set terminal svg size %d,%d dynamic enhanced font 'Helvetica,14' background 'white'; set output '%s.svg'", w, h, file) \
    : kind eq 'pdf' \
    ? sprintf("set terminal pdfcairo size %.4fin,%.4fin enhanced font 'DejaVu Sans,13' fontscale %.4f linewidth %.4f pointscale %.4f dashlength 1.2 background 'white'; set output '%s.pdf'", w / per_inch, h / per_inch, print, 1.9 * print, 1.9 * print, file) \
    : sprintf("set terminal pngcairo size %d,%d enhanced font 'DejaVu Sans,13' fontscale %.4f linewidth %.4f pointscale %.4f background 'white'; set output '%s.png'", w * dots, h * dots, dots, dots, dots, file)

# Okabe and Ito's colours in an order that also darkens in grey, so that neighbours differ without colour.
array shade[6] = ['#E69F00', '#56B4E9', '#009E73', '#D55E00', '#0072B2', '#000000']
array mark[6] = [4, 6, 8, 2, 12, 10]

soft = '#555555'

# --- curves: up to six have distinct colours; more of them a scale from light green to dark violet, of which the key
# names eight.
ramp_red(k) = word('143 53 33 49 68 68', k) + 0
ramp_green(k) = word('200 183 144 104 57 1', k) + 0
ramp_blue(k) = word('60 121 141 142 131 84', k) + 0
between(a, b, t) = int(a + (b - a) * t + 0.5)
ramp_at(x, k) = sprintf('#%02x%02x%02x', between(ramp_red(k), ramp_red(k + 1), x - k), between(ramp_green(k), ramp_green(k + 1), x - k), between(ramp_blue(k), ramp_blue(k + 1), x - k))
ramp(t) = ramp_at(1 + 5 * t, t >= 1 ? 5 : 1 + int(5 * t))
colour(i, n) = n <= 6 ? shade[i] : ramp((i - 1.0) / (n - 1))
mark_of(i) = mark[(i - 1) % 6 + 1]
in_key(i, n) = n <= 8 || i == 1 || i == n || int((i - 1) * 7.0 / (n - 1)) != int((i - 2) * 7.0 / (n - 1))
# Few curves have distinct dashes.
line_of(h) = words(hues) <= 6 ? h : 1

# --- cells of a table. Scripts select rows by conditions of gnuplot, such as is('method', 'series'), and list the values
# of columns; they compute no data: what is drawn is in the tables.
# gnuplot reads 1e-6 as an integer 1 followed by other characters.
number(s) = (strstrt(s, 'e') > 0 && strstrt(s, '.') == 0 ? s[1:strstrt(s, 'e') - 1].'.0'.s[strstrt(s, 'e'):*] : s) + 0.0
quotient(s) = number(s[1:strstrt(s, '/') - 1]) / number(s[strstrt(s, '/') + 1:*])
# The number in column c, which may be a fraction; whether its cell is this word; whether it has one.
at(c) = strstrt(strcol(c), '/') ? quotient(strcol(c)) : column(c)
is(c, word) = strcol(c) eq word
has(c) = strlen(strcol(c)) > 0
finite(v) = v > -1e300 && v < 1e300 ? v : NaN
visible(v) = v == v ? v : 1e999
# x and y of a row that is drawn or not; the first row is an invisible point if it is not drawn, because gnuplot warns of
# curves without points.
kept(drawn, v) = drawn || column(0) == 0 ? v : NaN
shown_y(drawn, v) = drawn ? finite(v) : column(0) == 0 ? 1e999 : NaN
broken_y(drawn, v) = drawn ? (finite(v) == v ? v : 1e999) : column(0) == 0 ? 1e999 : NaN
column_text(c) = strstrt('123456789', c[1:1]) ? c : "'".c."'"
in_row(c) = strstrt(c, '(') ? c : sprintf('at(%s)', column_text(c))
# A column is named, or counted from 1. The rows of a file with a condition, as the first part of an element of plot: columns or expressions x and y. A row
# without y does not break a line, or it does.
rows(file, x, y, where) = sprintf("'%s' %s using (kept(%s, %s)):(shown_y(%s, %s))", file, row_range, where, in_row(x), where, in_row(y))
broken_rows(file, x, y, where) = sprintf("'%s' %s using (kept(%s, %s)):(broken_y(%s, %s))", file, row_range, where, in_row(x), where, in_row(y))
# Whether a table has a column c.
has_column(name, file, c) = sprintf("stats '%s' every ::0::0 using (%s = sum [i_=1:60] (columnhead(i_) eq '%s'), 0) nooutput", file, name, c)
# Where only some of the rows are read: 'every ::FIRST::LAST'.
row_range = ''
both(a, b) = a eq '1' ? b : b eq '1' ? a : '('.a.') && ('.b.')'
# Commands, to be run by eval. The values of a column as quoted words in the order of the table: list = '"a" "b"'.
listed(list, word) = strstrt(list.' ', ' "'.word.'" ')
every_row(file, what) = sprintf("stats '%s' %s using (%s, 0) nooutput", file, row_range, what)
seen(list, file, c, where) = sprintf("%s = ''; ", list).every_row(file, sprintf("(%s) && has(%s) && !listed(%s, strcol(%s)) ? (%s = %s.' \"'.strcol(%s).'\"') : 0", where, column_text(c), list, column_text(c), list, list, column_text(c)))
# Whether a table exists: `tables` are the names of all.
exists_file(file) = strstrt(' '.tables.' ', ' '.file[strlen(data) + 2:*].' ') > 0
# The first cell of a column, or the last; the number of rows; the least and the greatest number of columns 'c c ...' as
# NAME_low and NAME_high, which are 0 and 1 if there is none.
first_cell(name, file, c, where) = sprintf("%s = ''; ", name).every_row(file, sprintf("%s eq '' && (%s) ? (%s = strcol(%s)) : 0", name, where, name, column_text(c)))
last_cell(name, file, c, where) = sprintf("%s = ''; ", name).every_row(file, sprintf("(%s) && has(%s) ? (%s = strcol(%s)) : 0", where, column_text(c), name, column_text(c)))
count_of(name, file, where) = sprintf("%s = 0; ", name).every_row(file, sprintf("(%s) ? (%s = %s + 1) : 0", where, name, name))
extent(name, file, cs, where) = sprintf("%s_low = 1e300; %s_high = -1e300; do for [c in '%s'] { ", name, name, cs).every_row(file, sprintf("(%s) ? (cell_ = finite(at(strstrt('123456789', c[1:1]) ? int(c) : c)), cell_ < %s_low ? (%s_low = cell_) : 0, cell_ > %s_high ? (%s_high = cell_) : 0) : 0", where, name, name, name, name)).sprintf(" }; if (%s_low > %s_high) { %s_low = 0.0; %s_high = 1.0 }", name, name, name, name)
pick(list, most, j) = words(list) <= most ? word(list, j) : word(list, 1 + int((j - 1) * (words(list) - 1) / (most - 1.0) + 0.5))
smaller(a, b) = a < b ? a : b
larger(a, b) = a > b ? a : b

# --- numbers in mathematical notation: 2e-7 is 2·10^{-7}, a long decimal has five digits; 1.99999999999999999999 is
# 2 - 10^{-20} by its gap.
tens(m, e) = (m eq '1' ? '' : m.'·').'10^{'.(e[1:1] eq '-' ? '−'.e[2:*] : e).'}'
in_powers(s) = s[1:1] eq '-' ? '−'.in_powers(s[2:*]) : strstrt(s, 'e') ? tens(s[1:strstrt(s, 'e') - 1], s[strstrt(s, 'e') + 1:*]) : s
swapped(s, a, b) = (at_ = strstrt(s, a)) ? s[1:at_ - 1].b.swapped(s[at_ + strlen(a):*], a, b) : s
unpadded(s) = strlen(s) > 1 && s[1:1] eq '0' ? unpadded(s[2:*]) : s
trimmed(s) = s[strlen(s):*] eq '0' ? trimmed(s[1:strlen(s) - 1]) : s[strlen(s):*] eq '.' ? s[1:strlen(s) - 1] : s
exponent_of(s) = (s[1:1] eq '-' ? '-' : '').unpadded(s[2:*])
shortened(s) = (at_ = strstrt(s, 'e')) ? s[1:at_].exponent_of(s[at_ + 1:*]) : s
printed(form, s) = shortened(sprintf(form, number(s)))
scientific(s) = (at_ = strstrt(s, 'e'), trimmed(s[1:at_ - 1]).'e'.exponent_of(s[at_ + 1:*]))
tidy(s) = printed('%.6g', s)
number_name(s) = in_powers(strlen(s) > 9 && !strstrt(s, 'e') ? printed('%.5g', s) : s)
small_number_name(s) = in_powers(abs(number(s)) < 1e-3 ? scientific(sprintf('%.5e', number(s))) : tidy(s))
from_two(g) = g[1:1] eq '-' ? '2 + '.small_number_name(g[2:*]) : '2 − '.small_number_name(g)
energy_name(e, g) = strlen(e) <= 9 && !strstrt(e, 'e') ? e : strlen(g) > 0 && abs(number(g)) < 0.1 ? from_two(g) : number_name(e)

# --- words of the tables as a reader writes them: arithmetics, sums for T*, tests of the radius and problems.
arithmetic_name(s) = s eq 'long-double' ? 'long double' : s[1:5] eq 'mpfr:' ? s[6:*].' digits' : s[1:5] eq 'ball:' ? 'proved, '.s[6:*].' digits' : s
in_arithmetic(s) = s[1:5] eq 'mpfr:' ? 'with '.arithmetic_name(s) : s[1:5] eq 'ball:' ? 'proved' : 'in '.arithmetic_name(s)
approximation_name(m) = m eq 'resummed' ? 'resummation' : m eq 'pade' ? 'Padé' : m eq 'asymptotic' ? 'asymptotic approximant' : m
rule_name(r) = r eq 'agm' ? 'exact T*' : (r[1:1] eq 's' ? 'series' : 'resummation').', N = '.r[strstrt(r, ':') + 1:*]
test_name(m) = swapped(swapped(swapped(swapped(swapped(m, 'domb-sykes', 'Domb~Sykes'), 'mercer-roberts', 'Mercer~Roberts'), 'hunter-guerrieri', 'Hunter~Guerrieri'), '-', ' '), '~', '-')
# Problems of the catalogue with the names of persons and abbreviations as they are written.
pairs = 'falkner_skan=Falkner-Skan fitzhugh_nagumo=FitzHugh-Nagumo henon_heiles=Hénon-Heiles lane_emden=Lane-Emden lotka_volterra=Lotka-Volterra thomas_fermi=Thomas-Fermi flierl_petviashvili=Flierl-Petviashvili'
persons = 'arenstorf=Arenstorf blasius=Blasius duffing=Duffing kepler=Kepler lorenz=Lorenz rayleigh=Rayleigh riccati=Riccati robertson=Robertson sakiadis=Sakiadis toda=Toda van_der_pol=van_der_Pol weierstrass=Weierstrass chazy=Chazy painleve=Painlevé brusselator=Brusselator oregonator=Oregonator'
abbreviations = 'pollu=POLLU hires=HIRES seir=SEIR sir=SIR japan=Japan detest_a=DETEST_A detest_b=DETEST_B detest_c=DETEST_C detest_d=DETEST_D detest_e=DETEST_E stiff_a=stiff_A stiff_b=stiff_B stiff_c=stiff_C stiff_d=stiff_D stiff_e=stiff_E stiff_f=stiff_F'
as_written(name, pair) = swapped(name, pair[1:strstrt(pair, '=') - 1], pair[strstrt(pair, '=') + 1:*])
as_listed(name, list) = (name_ = name, sum [i_=1:words(list)] (name_ = as_written(name_, word(list, i_)), 0), name_)
problem_name(p) = swapped(as_listed(p, pairs.' '.persons.' '.abbreviations), '_', ' ')
# A text is shown as it is.
heading_of(p) = strstrt(p, '=') || strstrt(p, ' ') ? p : problem_name(p)

# --- a figure of panels: `across` by `down`, each panel_w by panel_h, with a heading above and the key below them.
head = 62
foot = 70
grid(n, most) = sprintf("across = %d; down = %d", n <= most ? n : n == 4 ? 2 : most, n <= most ? 1 : n == 4 ? 2 : (n + most - 1) / most)
wide = 0; tall = 0
figure_of(kind, name) = sprintf("wide = larger(across * panel_w, 620.0); tall = head + down * panel_h + foot + 0.0; eval use_terminal('%s', target.'/%s', wide, tall); set multiplot", kind, name)
panel(p) = sprintf("set origin %.6f, %.6f; set size %.6f, %.6f", ((p - 1) % across) / (across + 0.0), 1 - (head + panel_h * ((p - 1) / across + 1.0)) / tall, 1.0 / across, panel_h / tall)
# The heading, smaller if it would not fit, and a line below it.
font_for(text, most) = smaller(most, int(1.5 * wide / strlen(text)))
heading(text, below) = sprintf("set label 1001 \"%s\" at screen 0.5, %.6f center font ',%d'; set label 1002 \"%s\" at screen 0.5, %.6f center font ',%d' textcolor rgb soft", text, 1 - 20 / tall, font_for(text, 17), below, 1 - 44 / tall, font_for(below.' ', 13))
no_heading = 'unset label 1001; unset label 1002'
# Two panels above each other share the axis of x.
upper_panel = "set format x ''; unset xlabel; set bmargin 1"
lower_panel = "unset title; set format x '%g'; set bmargin 3.6"
# The strip of the key: only the names of the curves are drawn in it.
key_strip = "unset title; unset xlabel; unset ylabel; unset tics; unset border; unset grid; unset arrow; unset label; unset logscale; unset format; set xrange [0:1]; set yrange [0:1]; set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0; set origin 0, 0; set size 1, foot / tall; set key inside center center horizontal Left reverse samplen 2.6 width 1"
# --- panels: a figure of equal panels, which shared/panels.gp draws. A script sets, unless a default is right:
# `figure`, `title_text`, `below_text`: the name of the file, and its headings;
# `table`, `panel_by`, `hue_by`, `kind_by`: a file, and the columns whose values make panels, colours, and dashes or
#     marks, in the rows with the condition `always`; `panels`, `hues`, `kinds`: these values. hue_by may be several
#     columns, 'c c', with the values "v,v";
# `x`, `x_name`, `x_axis`: column or expression, its name, and commands that set the range; `y_name`, `y_axis`; or
#     `y_together`: the columns that have a common range;
# `prepare`, `finish`: commands before and after each panel, with its number `p`, its value `this` and, with
#     `rows_down` of them, its `row`, and may set any of these and `panel_title`;
# `layers`: elements of plot; `key`: those of the key, with `entries` of `letters` letters.
panel_defaults = "panel_by = ''; hue_by = ''; kind_by = ''; panels = ''; hues = ''; kinds = ''; always = '1'; title_text = ''; below_text = ' '; x = ''; x_name = ''; x_axis = ''; y_name = ''; y_axis = ''; y_together = ''; y_where = '1'; y_name_everywhere = 0; prepare = ''; finish = ''; layers = ''; key = ''; entries = 0; letters = 16; rows_down = 1; most_panels = 9; most_across = 3; width = 0; height = 0"
eval panel_defaults
cells_of(columns) = (cells_text = '', sum [i_=1:words(columns)] (cells_text = cells_text.(i_ > 1 ? ".','." : '').sprintf('strcol(%s)', column_text(word(columns, i_))), 0), cells_text)
seen_together(list, file, columns, where) = sprintf("%s = ''; ", list).every_row(file, sprintf("(%s) && !listed(%s, %s) ? (%s = %s.' \"'.%s.'\"') : 0", where, list, cells_of(columns), list, list, cells_of(columns)))
of_panel(where) = both(both(always, panel_by eq '' ? '1' : sprintf("is('%s', this)", panel_by)), where)
of_hue(where) = both(hue_by eq '' ? '1' : sprintf("%s eq word(hues, h)", cells_of(hue_by)), of_panel(where))
of_kind(where) = both(kind_by eq '' ? '1' : sprintf("is('%s', word(kinds, k))", kind_by), of_hue(where))
# The names of the energies of a table, some of which are known by their gap: named_energy(E) after eval energy_names(file).
energy_names(file) = seen_together('energies_and_gaps', file, 'energy gap', '1')
gap_of(E) = (at_ = strstrt(energies_and_gaps, '"'.E.','), rest_ = energies_and_gaps[at_ + strlen(E) + 2:*], rest_[1:strstrt(rest_, '"') - 1])
named_energy(E) = energy_name(E, gap_of(E))
# Layers: a curve for each colour and kind in the panel, for each colour, and one; with the conditions of their rows.
curves(y, where, style) = 'for [h=1:words(hues)] for [k=1:words(kinds)] '.rows(table, x, y, of_kind(where)).' with '.style.' notitle'
by_hue(y, where, style) = 'for [h=1:words(hues)] '.rows(table, x, y, of_hue(where)).' with '.style.' notitle'
once(y, where, style) = rows(table, x, y, of_panel(where)).' with '.style.' notitle'
# Entries of the key, whose titles are expressions.
key_entry(style, title) = sprintf('NaN with %s title %s', style, title)
key_of_kinds(style) = 'for [k=1:words(kinds)] '.key_entry(style, 'kind_name(word(kinds, k))')
key_of_hues(style) = 'for [h=1:words(hues)] '.key_entry(style, "in_key(h, words(hues)) ? hue_name(word(hues, h)) : ''")
# --- axes
# The condition of rows with E > 2, whose gap may be beyond the range of double.
rotates = "substr(strcol('gap'), 1, 1) eq '-'"
e_axis = 'energy E / (m g ℓ)'
norm_axis = 'log_{10} (max |error| / rad)'
error_axis = 'log_{10} (|error| / rad)'
gap_axis = 'log_{10} |2 − E / (m g ℓ)| → E = 2'
# Between tics, for at most seven of them from -r to r.
times_decade(x, decade) = decade * (x < 1.5 * decade ? 1 : x < 3.5 * decade ? 2 : x < 7.5 * decade ? 5 : 10)
step_of(r) = times_decade(r / 2.2, 10**floor(log10(r / 2.2)))
# Tics at these values alone, at most `most` of them, on the axis x or y.
tics_at(which, list, most) = (tics_text = '', sum [tic=1:smaller(words(list), most)] (tics_text = tics_text.(tic > 1 ? ', ' : '').pick(list, most, tic), 0), sprintf('set %stics (%s)', which, tics_text))
# Few tics for the values of a parameter.
quarters(which, a, b) = b > a ? sprintf("set %stics %.15g, %.15g, %.15g format '%%.4g'", which, a, (b - a) / 4.0, b) : ''
# An axis from a to b, with margins at both ends; a single value is in the middle.
room(a, b) = b > a ? 0.04 * (b - a) : larger(0.5, 0.1 * abs(a))
rising(which, a, b) = sprintf("set %srange [%.15g:%.15g]", which, a - room(a, b), b + room(a, b))
# Angles from y_low to y_high, with tics at multiples of pi.
rising_in_pi = "eval rising('y', y_low, y_high); set ytics pi * step_of((y_high - y_low) / (1.5 * pi)); set format y '%.1Pπ'; set ytics add ('0' 0)"
falling(which, a, b) = sprintf("set %srange [%.15g:%.15g]", which, b + room(a, b), a - room(a, b))
# Energies from a to b: from 0 if a is near it, in powers of ten if b is large.
energies_on_x(a, b) = b > 30 && a > 0 && b > 3 * a ? sprintf("set logscale x; set format x '10^{%%T}'; set xrange [%.9g:%.9g]", a / 1.2, b * 1.2) : a > 0 && a < 0.1 * b ? sprintf("set xrange [0:%.15g]", b) : rising('x', a, b)
# A mark at E = 2 if it is between them.
separatrix_on_x(a, b) = a < 2 && b > 2 ? "set arrow 1001 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3; set label 1003 'E = 2' at 2, graph 0.975 offset 0.6, 0 textcolor rgb soft" : ''
energies_done = "unset arrow 1001; unset label 1003; unset logscale x; set format x '%g'"
# Space for a key with this number of entries and letters: eval it when across and panel_w are known.
shown_in_key(n) = n > 8 ? 8 : n
foot_for(entries, letters) = 30 + 24 * ceil(entries / floor(larger(across * panel_w, 620.0) / (12 * letters + 95)))
