# resummations: error norm against the number of coefficients, at one energy or two, and against the distance from E = 2
# on each side at one number. Columns: energy,gap,method,count,order,conditions,norm,time_of_maximum,rigour,bound,rate,
# log10_norm,log10_bound,log10_rate,log10_gap. Lines are drawn from the log10 columns and the gap column.
load scripts.'/style.gp'

file = data.'/resummations.csv'
methods = 'series resummed resummed_4 resummed_8 two_point pade uniform'
names = '"series" "resummation, m = 2" "m = 4" "m = 8" "two-point" "Padé (gaps: poles)" "uniform"'
tones = '#999999 #E69F00 #D55E00 #56B4E9 #009E73 #0072B2 #000000'
signs = '1 4 6 8 12 2 7'
energies = seen(file, 1, '1')
counts = sorted(file, 4, '1')
last = word(counts, words(counts))
drawn = count_of(file, '$4 == 16') > 0 ? '16' : last
bounded(b) = int(word('1 2 7', b))

# Panels against the number of coefficients: the middle energy of those away from E = 2, and one near it; or the first.
listed(where) = seen(file, 1, where)
middle(list) = word(list, (words(list) + 1) / 2)
far = word(listed('$15 > -0.99 && $2 !~ /^-/'), words(listed('$15 > -0.99 && $2 !~ /^-/')))
if (far eq '') { far = middle(listed('$15 > -0.99')) }
close_to = '$15 < -5.5 && $15 > -6.5'
near = word(listed(close_to.' && $2 !~ /^-/'), 1)
if (near eq '') { near = word(listed(close_to), 1) }
if (near eq '') { near = middle(listed('$15 <= -0.99')) }
chosen = words(energies) <= 2 ? energies : far.' '.near
if (words(counts) == 1 && words(energies) > 2) { chosen = '' }
# Panels against the distance from E = 2.
side(k) = k == 1 ? '$2 !~ /^-/' : '$2 ~ /^-/'
sides = ''
do for [k=1:2] { if (words(energies) > 2 && words(listed(side(k))) > 1) { sides = sides.' '.k } }
panels = words(chosen) + words(sides)
key_entries = 8

# Columns of the rows of a method, sorted by the first of them. A Pade approximant with a pole in the interval has no
# norm: there its line has a gap.
by(c) = points_by(sprintf("sort -t, -s -k%d,%dg '%s'", c, c, file))
curve(from, to, keys, values, where) = parts_at(by(from), sprintf('v($%d)', from), sprintf('$7 == "inf" ? "inf" : $%d', to), keys, values, sprintf('(%s) && ($%d != "" || $7 == "inf")', where, to))
of_energy(from, to, e, i) = curve(from, to, '1 3', e.','.word(methods, i), '1')
of_side(from, to, k, i) = curve(from, to, '4 3', drawn.','.word(methods, i), side(k))

eval grid(panels, 2)
panel_w = panels == 1 ? 900 : 590
panel_h = panels == 1 ? 540 : 430
foot = foot_for(8, 16)
do for [kind in terminals] {
    eval figure_of(kind, 'resummations')
    eval heading('Error norm of the resummations on [0, T*]', 'by their number of coefficients; m: number of conditions at the bottom')
    set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 3.6
    do for [p=1:panels] {
        eval panel(p)
        if ((p - 1) % across == 0) { set ylabel norm_axis } else { unset ylabel }
        unset key
        if (p <= words(chosen)) {
            e = word(chosen, p)
            which = sprintf('$1 == "%s"', e)
            set title 'E = '.energy_name(e, first_of(file, 2, which)) offset 0, -0.5
            set xlabel 'coefficients that are not 0'
            set xrange [0:last * 1.06]
            low = least(file, '12', which, -1); high = greatest(file, '12', which, 0)
            set yrange [low - room(low, high):smaller(high + room(low, high), 4)]
            plot for [b=1:3] of_energy(4, 13, e, bounded(b)) using 1:2 with lines lw 1.6 dt 3 lc rgb word(tones, bounded(b)), \
                 for [i=1:7] of_energy(4, 12, e, i) using 1:2 with linespoints pt int(word(signs, i)) ps 0.7 lw 1.8 dt dash_of(word(methods, i)) lc rgb word(tones, i)
        } else {
            k = word(sides, p - words(chosen)) + 0
            which = '$4 == '.drawn.' && '.side(k)
            set title drawn.' coefficients, '.(k == 1 ? 'libration' : 'rotation') offset 0, -0.5
            set xlabel gap_axis
            eval falling('x', least(file, '15', which, 0), greatest(file, '15', which, 0))
            low = least(file, '12', which, -1); high = greatest(file, '12', which, 0)
            set yrange [low - room(low, high):smaller(high + room(low, high), 4)]
            plot for [b=1:3] of_side(15, 13, k, bounded(b)) using 1:2 with lines lw 1.6 dt 3 lc rgb word(tones, bounded(b)), \
                 for [i=1:7] of_side(15, 12, k, i) using 1:2 with linespoints pt int(word(signs, i)) ps 0.7 lw 1.8 dt dash_of(word(methods, i)) lc rgb word(tones, i)
        }
        eval no_heading
    }
    eval key_strip
    plot for [i=1:7] NaN with linespoints pt int(word(signs, i)) ps 0.7 lw 1.8 dt dash_of(word(methods, i)) lc rgb word(tones, i) title word(names, i), \
         NaN with lines lw 1.6 dt 3 lc rgb soft title 'proved (A, A2, U)'
    eval figure_done
}
