# The common style of all figures, and the functions by which their scripts read tables. A script is called with `data`
# (directory of the CSV), `target` (of the drawings), `scratch` (of temporary files) and `scripts` (this directory),
# loads this file, and draws once for each name in `terminals`. Axes, panels and keys follow from the tables: no script
# depends on the default parameters.
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
line_of(j) = shown <= 6 ? j : 1
dash_of(method) = method eq 'series' ? 2 : 1

# --- results of shell commands. Each command is run once, because a process costs more than a curve and every terminal
# needs the same: command and output k of `shell_knows`, the last one at `shell_at`, which is followed by the next in
# the same order.
array shell_asked[20000]
array shell_said[20000]
shell_knows = 0
shell_at = 0
is_known(q) = shell_at < shell_knows && shell_asked[shell_at + 1] eq q ? (shell_at = shell_at + 1) \
    : (shell_at = 0, shell_knows > 0 ? sum [k=1:shell_knows] (shell_asked[k] eq q ? (shell_at = k) : 0) : 0, shell_at)
learnt(q, answer) = (shell_knows = shell_knows + 1, shell_at = shell_knows, shell_asked[shell_at] = q, shell_said[shell_at] = answer)
# The shell is replaced by awk if the command is awk alone.
at_once(command) = (command[1:4] eq 'awk ' ? 'exec ' : '').command
ask(command) = is_known(command) ? shell_said[shell_at] : learnt(command, system(at_once(command)))
# The file in `scratch` of the rows that a command prints.
points_by(command) = is_known('> '.command) ? shell_said[shell_at] : points_in(sprintf('%s/%d.csv', scratch, shell_knows + 1), command)
points_in(file, command) = (system(at_once(command)." > '".file."'"), learnt('> '.command, written(file)))
# An incomplete file of points ends the script, because this function is undefined.
written(file) = GPVAL_SYSTEM_ERRNO == 0 ? file : points_could_not_be_written_to(file)

# --- contents of a table. `where` is a condition of awk on the cells $1, $2, ...; v() reads a number or a fraction.
awk_v = 'BEGIN { CONVFMT = OFMT = "%.15g" } function v(s, f) { return split(s, f, "/") == 2 ? f[1] / f[2] : s + 0 } '
# key() joins the cells of a row in the columns 'c c ...' to "v,v,...".
awk_key(columns) = awk_v."function key(i, k) { k = $of[1]; for (i = 2; i <= parts; ++i) k = k \",\" $of[i]; return k } BEGIN { parts = split(\"".columns."\", of, \" \") } "
# gnuplot reads 1e-6 as an integer 1 followed by other characters.
number(s) = (strstrt(s, 'e') > 0 && strstrt(s, '.') == 0 ? s[1:strstrt(s, 'e') - 1].'.0'.s[strstrt(s, 'e'):*] : s) + 0.0
exists_file(file) = ask("test -f '".file."' && echo 1 || echo 0") + 0
# The values of a column as written, in the order of the table; or by size.
seen(file, c, where) = ask("awk -F, '".awk_v."NR > 1 && (".where.") && $".c." != \"\" && !s[$".c."]++ { print $".c." }' '".file."'")
sorted(file, c, where) = ask("awk -F, '".awk_v."NR > 1 && (".where.") && $".c." != \"\" && !s[$".c."]++ { print v($".c."), $".c." }' '".file."' | sort -g | cut -d' ' -f2")
count_of(file, where) = ask("awk -F, '".awk_v."NR > 1 && (".where.") { ++n } END { print n + 0 }' '".file."'") + 0
first_of(file, c, where) = ask("awk -F, '".awk_v."NR > 1 && (".where.") { print $".c."; exit }' '".file."'")
# The last cell of a column in the rows selected by `where` whose columns 'c c ...' of `keys` have the values "v,v,...";
# '' if there is none. One command for all values.
cells(file, c, keys, where) = ask("awk -F, '".awk_key(keys)."NR > 1 && (".where.") && $".c." != \"\" { cell[key()] = $".c." } END { for (k in cell) print k, cell[k] }' '".file."'")
second_of_pair(lines, first) = (shell_found = strstrt("\n".lines, "\n".first.' '), shell_found ? word(lines[shell_found:*], 2) : '')
cell_at(file, c, keys, values, where) = second_of_pair(cells(file, c, keys, where), values)
or_0(cell) = cell eq '' ? 0 : cell + 0
# The least and the greatest finite number of the columns 'c c ...'; `otherwise` if there is none.
extremes(file, cs, where) = ask("awk -F, '".awk_v."BEGIN { k = split(\"".cs."\", c, \" \") } NR > 1 && (".where.") { for (i = 1; i <= k; ++i) if ($c[i] != \"\" && $c[i] !~ /inf|nan/) { y = v($c[i]); if (!n++) m = M = y; if (y < m) m = y; if (y > M) M = y } } END { if (n) print m, M }' '".file."'")
extreme(both, i, otherwise) = both eq '' ? otherwise + 0.0 : number(word(both, i))
least(file, cs, where, otherwise) = extreme(extremes(file, cs, where), 1, otherwise)
greatest(file, cs, where, otherwise) = extreme(extremes(file, cs, where), 2, otherwise)
# Columns x and y of the rows selected by a condition, then a blank line and a point outside the range: gnuplot warns of
# a file without points, and runs for [i=1:0] once.
rows(file, x, y, where) = points_by("awk -F, '".awk_v."BEGIN { print \"x,y\" } NR > 1 && (".where.") && $".y." != \"\" && $".y." !~ /inf|nan/ { print v($".x.") \",\" $".y." } END { print \"\\n1e99,1e99\" }' '".file."'")
# The same for many curves by reading the table once: of the rows selected by `where` those whose columns 'c c ...' of
# `keys` have the values "v,v,...". x and y are expressions of awk in parts_at, columns in rows_at. awk prints the
# common prefix of its files' names and the key of each file, from 1 on; file 0 is empty. If there are many files, some
# are closed between two rows: a process may have about a thousand open.
parts(file, x, y, keys, where) = parts_asked('parts '.file.' '.x.' '.y.' '.keys.' '.where, file, x, y, keys, where)
parts_asked(question, file, x, y, keys, where) = is_known(question) ? shell_said[shell_at] \
    : learnt(question, parts_in(sprintf('%s/%d', scratch, shell_knows + 1), file, x, y, keys, where))
parts_in(stem, file, x, y, keys, where) = (shell_words = system("exec awk -F, '".awk_key(keys)."function put(i, s) { if (i < 400) print s > name[i]; else { print s >> name[i]; close(name[i]) } } function head(i) { name[i] = \"".stem."-\" i \".csv\"; put(i, \"x,y\") } BEGIN { head(0) } NR > 1 && (".where.") { k = key(); if (!(k in at)) { at[k] = ++n; words = words \" \" k; head(n) } put(at[k], (".x.") \",\" (".y.")) } END { for (i = 0; i <= n; ++i) put(i, \"\\n1e99,1e99\"); print words }' '".file."'"), written(stem).shell_words)
part_of(answer, values) = (shell_found = strstrt(answer.' ', ' '.values.' '), sprintf('%s-%d.csv', word(answer, 1), shell_found ? words(answer[1:shell_found]) : 0))
parts_at(file, x, y, keys, values, where) = part_of(parts(file, x, y, keys, where), values)
rows_at(file, x, y, keys, values, where) = parts_at(file, sprintf('v($%d)', x), sprintf('$%d', y), keys, values, sprintf('(%s) && $%d != "" && $%d !~ /inf|nan/', where, y, y))
# The same with a gap in the line where y is not finite.
broken_at(file, x, y, keys, values) = parts_at(file, sprintf('v($%d)', x), sprintf('$%d', y), keys, values, sprintf('$%d != ""', y))
pick(list, most, j) = words(list) <= most ? word(list, j) : word(list, 1 + int((j - 1) * (words(list) - 1) / (most - 1.0) + 0.5))
smaller(a, b) = a < b ? a : b
larger(a, b) = a > b ? a : b

# --- numbers in mathematical notation: 2e-7 is 2·10^{-7}, a long decimal has five digits; 1.99999999999999999999 is
# 2 - 10^{-20} by its gap.
tens(m, e) = (m eq '1' ? '' : m.'·').'10^{'.(e[1:1] eq '-' ? '−'.e[2:*] : e).'}'
in_powers(s) = s[1:1] eq '-' ? '−'.in_powers(s[2:*]) : strstrt(s, 'e') ? tens(s[1:strstrt(s, 'e') - 1], s[strstrt(s, 'e') + 1:*]) : s
printed(form, s) = ask("printf '".form."' '".s."' | sed 's/e\\([+-]\\)0*/e\\1/; s/e+/e/'")
tidy(s) = printed('%.6g', s)
number_name(s) = in_powers(strlen(s) > 9 && !strstrt(s, 'e') ? printed('%.5g', s) : s)
small_number_name(s) = in_powers(abs(number(s)) < 1e-3 ? ask("printf '%.5e' '".s."' | sed 's/0*e/e/; s/\\.e/e/; s/e\\([+-]\\)0*/e\\1/'") : tidy(s))
from_two(g) = g[1:1] eq '-' ? '2 + '.small_number_name(g[2:*]) : '2 − '.small_number_name(g)
energy_name(e, g) = strlen(e) <= 9 && !strstrt(e, 'e') ? e : strlen(g) > 0 && abs(number(g)) < 0.1 ? from_two(g) : number_name(e)

# --- words of the tables as a reader writes them: arithmetics, sums for T*, tests of the radius and problems.
arithmetic_name(s) = s eq 'long-double' ? 'long double' : s[1:5] eq 'mpfr:' ? s[6:*].' digits' : s[1:5] eq 'ball:' ? 'proved, '.s[6:*].' digits' : s
in_arithmetic(s) = s[1:5] eq 'mpfr:' ? 'with '.arithmetic_name(s) : s[1:5] eq 'ball:' ? 'proved' : 'in '.arithmetic_name(s)
rule_name(r) = r eq 'agm' ? 'exact T*' : (r[1:1] eq 's' ? 'series' : 'resummation').', N = '.r[strstrt(r, ':') + 1:*]
test_name(m) = ask("echo '".m."' | sed 's/domb-sykes/Domb-Sykes/; s/mercer-roberts/Mercer-Roberts/; s/hunter-guerrieri/Hunter-Guerrieri/; s/\\([a-z]\\)-\\([a-z0-9]\\)/\\1 \\2/g'")
# Problems of the catalogue with the names of persons and abbreviations as they are written.
surnames = 'Arenstorf Blasius Brusselator Oregonator Duffing Falkner Skan Nagumo Heiles Kepler Lane Emden Lorenz Lotka Volterra Rayleigh Riccati Robertson Sakiadis Thomas Fermi Toda Pol Weierstrass Flierl Petviashvili Chazy'
pairs = 'Falkner-Skan FitzHugh-Nagumo Hénon-Heiles Lane-Emden Lotka-Volterra Thomas-Fermi Flierl-Petviashvili'
capital_rules = "s/^detest \\(.*\\)$/DETEST \\U\\1/; s/^stiff \\([a-f][1-6]\\)/stiff \\U\\1/; s/pollu/POLLU/; s/fitzhugh/FitzHugh/; s/henon/Hénon/; s/painleve/Painlevé/; s/hires/HIRES/; s/^se\\?ir/\\U&/; s/japan/Japan/"
do for [each in surnames] { capital_rules = capital_rules.sprintf('; s/\<%s\>/\u&/I', each) }
do for [each in pairs] { capital_rules = capital_rules.sprintf('; s/%s/%s/', each[1:strstrt(each, '-') - 1].' '.each[strstrt(each, '-') + 1:*], each) }
problem_name(p) = ask("printf '%s' '".p."' | tr '_' ' ' | sed '".capital_rules."'")

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
# --- axes
e_axis = 'energy E / (m g ℓ)'
t_axis = 'time t / (ℓ/g)^{1/2}'
norm_axis = 'log_{10} (max |error| / rad)'
error_axis = 'log_{10} (|error| / rad)'
gap_axis = 'log_{10} |2 − E / (m g ℓ)| → E = 2'
# Between tics, for at most seven of them from -r to r.
times_decade(x, decade) = decade * (x < 1.5 * decade ? 1 : x < 3.5 * decade ? 2 : x < 7.5 * decade ? 5 : 10)
step_of(r) = times_decade(r / 2.2, 10**floor(log10(r / 2.2)))
# Tics at these values alone, at most `most` of them, on the axis x or y.
tics_at(which, list, most) = (tics_text = '', sum [tic=1:smaller(words(list), most)] (tics_text = tics_text.(tic > 1 ? ', ' : '').pick(list, most, tic), 0), sprintf('set %stics (%s)', which, tics_text))
# An axis from a to b, with margins at both ends; a single value is in the middle.
room(a, b) = b > a ? 0.04 * (b - a) : larger(0.5, 0.1 * abs(a))
rising(which, a, b) = sprintf("set %srange [%.15g:%.15g]", which, a - room(a, b), b + room(a, b))
falling(which, a, b) = sprintf("set %srange [%.15g:%.15g]", which, b + room(a, b), a - room(a, b))
# Energies from a to b: from 0 if a is near it, in powers of ten if b is large.
energies_on_x(a, b) = b > 30 && a > 0 && b > 3 * a ? sprintf("set logscale x; set format x '10^{%%T}'; set xrange [%.9g:%.9g]", a / 1.2, b * 1.2) : a > 0 && a < 0.1 * b ? sprintf("set xrange [0:%.15g]", b) : rising('x', a, b)
# A mark at E = 2 if it is between them.
separatrix_on_x(a, b) = a < 2 && b > 2 ? "set arrow 1001 from 2, graph 0 to 2, graph 1 nohead lc rgb '#888888' dt 3; set label 1003 'E = 2' at 2, graph 0.975 offset 0.6, 0 textcolor rgb soft" : ''
energies_done = "unset arrow 1001; unset label 1003; unset logscale x; set format x '%g'"
# Space for a key with this number of entries and letters: eval it when across and panel_w are known.
shown_in_key(n) = n > 8 ? 8 : n
foot_for(entries, letters) = 30 + 24 * ceil(entries / floor(larger(across * panel_w, 620.0) / (12 * letters + 95)))
