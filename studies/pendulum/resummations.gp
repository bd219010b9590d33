# resummations: error norm against the number of coefficients at three energies, and against the distance from E = 2 at one
# number. Columns: energy,gap,method,count,order,conditions,norm,time_of_maximum,rigour,bound,rate,log10_norm,log10_bound,
# log10_rate,log10_gap. Lines are drawn from the log10 columns and the gap column.
load scripts.'/style.gp'

file = data.'/resummations.csv'
methods = 'series resummed resummed_4 resummed_8 two_point pade uniform'
names = 'series|resummed, m = 2|m = 4|m = 8|two-point|Pade|uniform'
tones = '#999999 #E69F00 #D55E00 #56B4E9 #009E73 #0072B2 #000000'
signs = '1 4 6 8 12 2 7'
name(i) = system(sprintf("echo '%s' | cut -d'|' -f%d", names, i))

# The energies of the panels: of those in the table the middle one of each list.
listed(pattern, which) = system(sprintf("tail -n +2 '%s' | awk -F, '%s {print $1}' | awk '!seen[$0]++' | sed -n '%s'", file, pattern, which))
far = listed('$15 > -0.99 && $2 !~ /^-/', '$p')
near = listed('$15 < -5.5 && $15 > -6.5 && $2 !~ /^-/', '1p')
if (near eq '') { near = listed('$2 ~ /^-/', '1p') }
counts = system(sprintf("cut -d, -f4 '%s' | tail -n +2 | sort -nu", file))
drawn = int(system(sprintf("cut -d, -f4 '%s' | tail -n +2 | sort -nu | grep -cx 16 || true", file))) > 0 ? '16' : word(counts, words(counts))
gap_of(e) = system(sprintf("awk -F, '$1 == \"%s\" {print $2; exit}' '%s'", e, file))
closest = real(system(sprintf("cut -d, -f15 '%s' | tail -n +2 | sort -g | sed -n 1p", file)))
farthest = real(system(sprintf("cut -d, -f15 '%s' | tail -n +2 | sort -g | sed -n '$p'", file)))

# Rows that an awk condition picks, sorted by their x, with a blank line and a point out of sight behind them.
rows(from, to, which) = sprintf("< awk -F, 'NR > 1 && %s && $%d != \"\" {print $%d \",\" $%d}' '%s' | sort -t, -k1,1g | awk 'BEGIN {print \"x,y\"} {print} END {print \"\\n1e9,1e9\"}'", which, to, from, to, file)
of_energy(e, i) = sprintf('$1 == "%s" && $3 == "%s"', e, word(methods, i))
side(i, negative) = sprintf('$4 == %s && $3 == "%s" && $2 %s /^-/', drawn, word(methods, i), negative ? '~' : '!~')
panel(p) = p == 1 ? far : near
bounded(b) = int(word('1 2 7', b))

do for [kind in terminals] {
    eval use_terminal(kind, target.'/resummations', 1180, 900)
    set multiplot layout 2, 2 title 'Error norm on [0, T*] of the resummations (dotted: the bounds A, A2, U, which are proved)' font ',16' offset 0, -0.3
    set lmargin 9
    set rmargin 2
    do for [p=1:2] {
        set title sprintf('2 - E = %s', gap_of(panel(p))) offset 0, -0.5
        set xlabel 'coefficients that are not 0'
        set ylabel 'log_{10} max |error|, radians' offset 0.5
        set xrange [0:word(counts, words(counts)) + 1]
        set yrange [-36:4]
        if (p == 1) { set key at graph 0.03, 0.04 left bottom maxrows 7 } else { unset key }
        plot for [b=1:3] rows(4, 13, of_energy(panel(p), bounded(b))) using 1:2 with lines lw 1.6 dt 3 lc rgb word(tones, bounded(b)) notitle, \
             for [i=1:7] rows(4, 12, of_energy(panel(p), i)) using 1:2 with linespoints pt int(word(signs, i)) ps 0.7 lw 1.8 lc rgb word(tones, i) title name(i)
    }
    do for [p=1:2] {
        set title sprintf('%s coefficients, %s', drawn, p == 1 ? 'libration' : 'rotation') offset 0, -0.5
        set xlabel p == 1 ? 'log_{10}(2 - E): towards the separatrix' : 'log_{10}(E - 2): from the separatrix'
        if (p == 1) { set xrange [0.4:closest - 0.3] } else { set xrange [closest - 0.3:farthest + 0.2] }
        set yrange [-24:4]
        unset key
        plot for [b=1:3] rows(15, 13, side(bounded(b), p == 2)) using 1:2 with lines lw 1.6 dt 3 lc rgb word(tones, bounded(b)) notitle, \
             for [i=1:7] rows(15, 12, side(i, p == 2)) using 1:2 with linespoints pt int(word(signs, i)) ps 0.7 lw 1.8 lc rgb word(tones, i) notitle
    }
    unset multiplot
    unset output
}
