# uniform: digits of the uniform resummation against the energy: E < 1, 1 < E < 2, E > 2.
# Columns: energy,gap,count,order,norm,time_of_maximum,scalar,rigour,bound,rate,log10_norm,log10_bound,log10_energy,log10_gap.
# Lines are drawn from the log10 columns and the gap column: neither 1e-100 nor 2 - 1e-100 passes through a double.
load scripts.'/style.gp'
tone(i) = shade[word('4 3 5 2 1 6', (i - 1)%6 + 1) + 0]     # neighbours far apart

exact = data.'/uniform.csv'
rounded = data.'/uniform_double.csv'
counts = system(sprintf("cut -d, -f3 '%s' | tail -n +2 | sort -nu", exact))
drawn = int(system(sprintf("cut -d, -f3 '%s' | tail -n +2 | sort -nu | grep -cx 16 || true", exact))) > 0 ? '16' : word(counts, 1)
energies = system(sprintf("cut -d, -f13 '%s' | tail -n +2 | sort -g | sed -n '1p;$p' | tr '\\n' ' '", exact))
lowest = floor(word(energies, 1) + 0)
# log10 |2 - E| of the smallest and largest gap on a side, '' where there is none.
of_side(sign, end) = system(sprintf("awk -F, 'NR > 1 && ($2 ~ /^-/) == %d {print $14}' '%s' | sort -g | sed -n '%s'", sign, exact, end))
below = of_side(0, '1p')
above = of_side(1, '1p')
farthest = of_side(1, '$p')
highest = real(system(sprintf("cut -d, -f11 '%s' | tail -n +2 | sort -g | sed -n 1p", exact)))
top = ceil(-highest/10.0)*10

# Columns `from` and minus `to` of the rows with n coefficients that an awk condition picks, with a blank line and a point out of sight behind them.
rows(file, from, to, n, which) = sprintf("< awk -F, 'BEGIN {print \"x,y\"} NR > 1 && $3 == %s && %s {print $%d \",\" (-$%d)} END {print \"\\n1e9,1e9\"}' '%s'", n, which, from, to, file)

do for [kind in terminals] {
    eval use_terminal(kind, target.'/uniform', 1180, 560)
    set multiplot
    set label 1 'Digits of the uniform resummation on [0, T*] by its number of coefficients (dotted: proved, theorem U)' at screen 0.5, 0.965 center font ',16'
    set yrange [0:top]
    set bmargin 4
    set tmargin 3.2
    do for [p=1:3] {
        present = p == 3 ? above ne '' : below ne ''
        if (present) {
            side = p == 1 ? '$13 <= 0' : p == 2 ? '$14 <= 0 && $2 !~ /^-/' : '$2 ~ /^-/'
            across = p == 1 ? 13 : 14
            set origin (p - 1)/3.0 + (p == 1 ? 0 : 0.005), 0
            set size 0.335, 0.95
            set lmargin (p == 1 ? 8 : 5)
            set rmargin 1.5
            if (p == 1) { set ylabel 'digits: -log_{10} max |error|, radians' offset 1 } else { unset ylabel }
            if (p == 1) { set key at graph 0.98, 0.98 right top maxrows 5 title 'coefficients' } else { unset key }
            if (p == 1) { set xrange [lowest-0.5:0.2]; set xlabel 'log_{10} E: towards rest' }
            if (p == 2) { set xrange [0.5:below-1]; set xlabel 'log_{10}(2 - E): towards the separatrix, libration' }
            if (p == 3) { set xrange [above-1:farthest+1]; set xlabel 'log_{10}(E - 2): from the separatrix, rotation' }
            plot for [i=1:words(counts)] rows(exact, across, 12, word(counts, i), side) using 1:2 with lines lw 1.5 dt 3 lc rgb tone(i) notitle, \
                 for [i=1:words(counts)] rows(exact, across, 11, word(counts, i), side) using 1:2 with linespoints pt 7 ps 0.35 lw 2.2 lc rgb tone(i) title word(counts, i), \
                 rows(rounded, across, 11, drawn, side) using 1:2 with points pt 6 ps 0.6 lc rgb '#333333' title drawn.', in double'
        }
    }
    unset multiplot
    unset output
}
