# scenarios: the nearest singularity of each problem in units of its radius of convergence, by its argument.
load scripts.'/style.gp'
figure = 'scenarios'
table = data.'/scenarios.csv'
title_text = 'The three scenarios'
below_text = 'argument of the nearest singularity as seen from the start, in degrees: at 0 the solution ends there'
eval count_of('n', table, '1')
width = 900; height = 110 + 17 * n
kind_by = 'scenario'; kinds = 'larger equal within'
kind_name(s) = s eq 'larger' ? 'radius larger than the domain' : s eq 'equal' ? 'radius equal to it' : 'radius within it'
# 0 ahead and 180 behind; -20 if there is no singularity.
x = "has('position_re') ? atan2(abs(at('position_im')), at('position_re')) * 180 / pi : -20"; x_name = 'argument of the nearest singularity / degrees'
x_axis = "set xrange [-35:190]; set yrange [n + 1:0]; set xtics ('none' -20, '0' 0, '45' 45, '90' 90, '135' 135, '180' 180); set ytics scale 0 noenhanced font ',10'"
prepare = 'set lmargin 34'
style = 'points pt mark[k] ps 1 lw 1.6 lc rgb shade[2 * k - 1]'
layers = rows(table, '(1e99)', 'column(0) + 1', '1').":ytic(strcol('problem').(has('scenario') ? '' : ' (no verdict)')) with points pt 0" \
    .', for [k=1:3] '.rows(table, x, 'column(0) + 1', of_kind('1')).' with '.style
key = key_of_kinds(style)
entries = 3; letters = 26
load scripts.'/shared/panels.gp'
