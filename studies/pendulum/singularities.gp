# singularities: the complex t-plane of each energy to scale, and the convergence of the Pade poles.
# Columns: energy,kind,order,re,im,radius,nearest_re,nearest_im,log10_distance,residue_re,residue_im,numerator_degree,
# denominator_degree,tstar,height,gap. singularities_convergence: energy,order,log10_distance,log10_root_error,degrees.
load scripts.'/style.gp'

file = data.'/singularities.csv'
energies = ask(sprintf("tail -n +2 '%s' | cut -d, -f1 | uniq", file))
orders = ask(sprintf("awk -F, '$2 == \"pade_pole\" { print $3 }' '%s' | sort -nu", file))
no_poles = words(orders) == 0
if (no_poles) { orders = '0' }  # gnuplot also runs the body of an empty loop
# Of many energies six planes, from the first to the last; the poles of every one below.
all_energies = words(energies)
count = smaller(all_energies, 6)
across = count > 4 ? 3 : count > 1 ? 2 : 1
down = (count + across - 1) / across
of(e, k) = real(ask(sprintf("awk -F, '$1 == \"%s\" && $2 == \"expansion_top\" { print $%d; exit }' '%s'", e, k, file)))
named(e) = energy_name(e, first_of(data.'/singularities.csv', 16, sprintf('$1 == "%s"', e)))
regime(e) = ask(sprintf("awk -F, '$1 == \"%s\" { print $16 ~ /^-/ ? \"rotation\" : \"libration\"; exit }' '%s'", e, file))
in_panel(e, kind, y) = (strcol(1) eq e && strcol(2) eq kind) ? y : NaN
far = 1e9                 # outside every panel: an order may have no pole at all
pole(e, n, y) = (strcol(1) eq e && strcol(2) eq 'pade_pole' && column(3) == n) ? y : far
high = 430                # of a panel, in points
head = 36                 # of the title above them
keys = words(orders) > 6 ? (words(orders) + 5) / 3 : 3
foot = 20 * keys + 20     # of the key below
wide = across > 2 ? 1600 : across > 1 ? 1220 : 760
all = high * down + head + foot + 0.0

do for [kind in terminals] {
    eval use_terminal(kind, target.'/singularities', wide, all)
    set multiplot
    set label 9 (count > 1 ? 'Singularities of θ(t) and poles of Padé approximants of ω from N coefficients' : 'Singularities of θ(t), and Padé poles from N coefficients') at screen 0.5, 1 - 20 / all center font ',16'
    set samples 361
    unset grid
    set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.3, 0.2
    set key at screen 0.5, (foot - 4) / all center top vertical maxrows keys samplen 2.5 width 1
    do for [p=1:count] {
        e = pick(energies, 6, p)
        tstar = of(e, 14); height = of(e, 15); radius = of(e, 6)
        # The CSV contains the lattice up to 4 T* and 4 K~', or 1.5 R. A panel is not higher than wide.
        w = larger(3.6 * tstar, 1.2 * radius)
        h = larger(1.2 * radius, smaller(3.6 * height, w))
        h = smaller(larger(h, 0.62 * w), larger(3.99 * height, 1.49 * radius))
        set origin ((p - 1) % across) / (across + 0.0), 1 - (head + high * ((p - 1) / across + 1)) / all
        set size 1.0 / across, high / all
        set size ratio -1
        set lmargin 8; set rmargin 2; set tmargin 2; set bmargin 3.6
        set xrange [-w:w]; set yrange [-h:h]
        set title 'E = '.named(e).': '.regime(e)
        set xlabel 'Re t / (ℓ/g)^{1/2}, t = 0 at the top'
        set ylabel 'Im t / (ℓ/g)^{1/2}'
        set arrow 1 from -w, 0 to w, 0 nohead lc rgb '#888888' lw 0.8 back
        set arrow 2 from 0, -h to 0, h nohead lc rgb '#888888' lw 0.8 dt 3 back
        # Beside their marks, with the paper behind them, and away from the circles, which all pass through T* + i K~'.
        set label 1 'T*' at tstar, 0 left offset 0.5, -0.8 boxed
        set label 2 '−T*' at -tstar, 0 right offset -0.5, -0.8 boxed
        set label 1 point pt 13 ps 0.9 lc rgb '#555555' front
        set label 2 point pt 13 ps 0.9 lc rgb '#555555' front
        set label 3 'i K̃′' at 0, height left offset 0.6, 0 point pt 13 ps 0.9 lc rgb '#555555' front boxed
        set label 4 '' at 0, 0 point pt 13 ps 0.9 lc rgb '#555555' front
        plot '+' using (radius * cos(2 * pi * $0 / 360)):(radius * sin(2 * pi * $0 / 360)) with lines lw 2 lc rgb '#0072B2' title 'circle about top', \
             '+' using (tstar + height * cos(2 * pi * $0 / 360)):(height * sin(2 * pi * $0 / 360)) with lines lw 2 dt 2 lc rgb '#D55E00' title 'circle about bottom', \
             '+' using (-tstar + height * cos(2 * pi * $0 / 360)):(height * sin(2 * pi * $0 / 360)) with lines lw 2 dt 2 lc rgb '#D55E00' notitle, \
             file using (in_panel(e, 'singularity', column(4))):5 with points pt 7 ps 0.9 lc rgb '#000000' title 'singularities', \
             for [i=1:words(orders)] for [s=0:3] file using (pole(e, word(orders, i) + 0, s % 2 ? -column(4) : column(4))):(s > 1 ? -column(5) : column(5)) \
                 with points pt mark_of(i) ps 0.9 + 0.35 * ((i-1)%6+1) lw 1.4 lc rgb colour(i, words(orders)) title s || no_poles ? '' : 'Padé, N = '.word(orders, i)
        unset label 9
        unset key
    }
    unset multiplot
    unset output
}

# The accuracy of the first singularity as found from the coefficients.
eval restart
file = data.'/singularities_convergence.csv'
at(e, y) = strcol(1) eq e ? y : NaN
place(e) = sum [i=1:all_energies] (word(energies, i) eq e ? i : 0)
hue(p) = all_energies <= 6 ? shade[(p+2)%6+1] : colour(p, all_energies)
with_poles = ask(sprintf("awk -F, 'NR > 1 && $3 != \"\" { print $1 }' '%s' | uniq", file))
last = real(ask(sprintf("tail -n 1 '%s' | cut -d, -f2", file)))
lowest = real(ask(sprintf("awk -F, 'NR > 1 { for (c = 3; c <= 4; ++c) if ($c != \"\" && $c + 0 < l) l = $c + 0 } END { print l - 2 }' '%s'", file)))
highest = real(ask(sprintf("awk -F, 'NR > 1 { for (c = 3; c <= 4; ++c) if ($c + 0 > l) l = $c + 0 } END { print l + 1 }' '%s'", file)))
do for [kind in terminals] {
    eval use_terminal(kind, target.'/singularities_convergence', 900, 560)
    set title (all_energies > 2 ? 'The Padé pole nearest to T* + i K̃′, from N coefficients' : 'The first singularity, T* + i K̃′, from N coefficients') font ',16'
    set xlabel 'order N, last power of the series'
    set ylabel 'log_{10} (|error| / (ℓ/g)^{1/2})'
    if (all_energies > 2) { set key outside right top title 'energy E' } else { set key bottom left title 'energy E' }
    set lmargin 9
    set xrange [0:last + 2]
    set yrange [lowest:highest]
    short = all_energies > 2
    roots = "for [p=1:all_energies] file using 2:(at(word(energies, p), column(4))) with linespoints lw 2 dt 2 pt 2 ps 0.5 lc rgb hue(p) title short ? (p == all_energies ? 'dashed: root test' : '') : named(word(energies, p)).': root test (its radius only)'"
    poles = "for [p=1:words(with_poles)] file using 2:(at(word(with_poles, p), column(3))) with linespoints lw 2 pt mark_of(p) ps 0.8 lc rgb hue(place(word(with_poles, p))) title short && !in_key(place(word(with_poles, p)), all_energies) ? '' : named(word(with_poles, p)).(short ? '' : ': nearest pole of the Padé approximant'), "
    eval 'plot '.(words(with_poles) > 0 ? poles : '').roots
    unset output
}
