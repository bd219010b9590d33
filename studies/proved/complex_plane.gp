# complex_plane: the argument of an unknown as a colour over the complex t-plane, its modulus as shades, with
# singularities, the proved circle of convergence and the discs that prove it.
# Columns: problem,re,im,log10_abs,argument,unknown; in _singularities problem,re,im,uncertainty,kind,unknown; in
# _proofs problem,part,re,im,radius.
load scripts.'/style.gp'

main = data.'/complex_plane.csv'
places = data.'/complex_plane_singularities.csv'
proofs = data.'/complex_plane_proofs.csv'
names = seen(main, 1, '1')
count = words(names)
of(name) = sprintf('$1 == "%s"', name)
part_of(name, part) = sprintf('$1 == "%s" && $2 == "%s"', name, part)
grid_of(name) = points_by("awk -F, 'NR > 1 && $1 == \"".name."\" { print $2 \",\" $3 \",\" ($4 == \"\" ? 0 : $4) \",\" ($5 == \"\" ? 9 : $5) }' '".main."'")
three(name, part) = points_by("awk -F, 'BEGIN { print \"x,y,r\" } NR > 1 && $1 == \"".name."\" && $2 == \"".part."\" { print $3 \",\" $4 \",\" $5 } END { print \"1e99,1e99,0\" }' '".proofs."'")
shade_of(m) = 0.62 + 0.38 * (m - floor(m))
colour_of(m, a) = a > 8 ? 0xffffff : hsv2rgb((a + pi) / (2 * pi), 0.45, shade_of(m))
red(m, a) = int(colour_of(m, a)) >> 16
green(m, a) = (int(colour_of(m, a)) >> 8) & 255
blue(m, a) = int(colour_of(m, a)) & 255

eval grid(count, 4)
panel_w = count < 3 ? 460 : 300
panel_h = count < 3 ? 440 : 300
foot = foot_for(3, 30)
do for [kind in terminals] {
    eval figure_of(kind, 'complex_plane')
    eval heading('Solutions in the complex plane of time', 'from the start; colour: argument of the first unknown, shade: modulus, a factor of 10 from dark to light')
    do for [p=1:count] {
        name = word(names, p)
        reach = greatest(main, '2', of(name), 1)
        eval panel(p)
        set lmargin 6; set rmargin 2; set tmargin 2; set bmargin 2.6; unset key; unset grid
        set size ratio -1
        set title problem_name(name).': '.first_of(main, 6, of(name)) font ',12' offset 0, -0.6
        set xrange [-reach:reach]; set yrange [-reach:reach]
        set xtics step_of(reach) format '%.3g' font ',10'; set ytics step_of(reach) format '%.3g' font ',10'
        set datafile nocolumnheaders
        set style fill transparent solid 0 border lc rgb '#777777'
        radius = first_of(proofs, 5, part_of(name, 'lower'))
        set object 1 circle at 0, 0 size (strlen(radius) ? number(radius) : 0) fs empty border lc rgb '#000000' lw 2 front
        plot grid_of(name) using 1:2:(red($3, $4)):(green($3, $4)):(blue($3, $4)) with rgbimage, \
             three(name, 'disc') every ::1 using 1:2:3 with circles lc rgb '#777777' lw 0.4 fs empty border, \
             rows(places, 2, 3, of(name)) every ::1 using 1:2 with points pt 2 ps 1.1 lw 2 lc rgb '#000000'
        unset object 1
        set datafile columnheaders
        set size noratio
        eval no_heading
    }
    eval key_strip
    plot NaN with points pt 2 ps 1.1 lw 2 lc rgb '#000000' title 'singularity', \
         NaN with lines lw 2 lc rgb '#000000' title 'radius of convergence, proved', \
         NaN with lines lw 1 lc rgb '#777777' title 'discs of the proof'
    eval figure_done
}
