# error_norm of any equation: the norms over the order, a panel for each unknown, a colour for each combination of the
# parameters, marks for the methods; thin the rate reach/R of the radius that the coefficients show.
# Columns: <axes>,order,method,norm,time_of_maximum,scalar,rigour,log10_norm,unknown; in _radius reach, rate, ...
load scripts.'/equation/panels.gp'

radii = table_of('_radius')
k = place(main, 'order') - 1
all = cases(main, k)
n = words(all)
N = place(main, 'order')
y = place(main, 'log10_norm')
scalar = first_of(main, place(main, 'scalar'), '1')
methods = 'series pade endpoint'
name_of(m) = m eq 'pade' ? 'Padé [N/2, N/2]' : m eq 'endpoint' ? 'endpoint' : 'series'
number_of(m) = m eq 'series' ? 1 : m eq 'pade' ? 2 : 3
tone(c, m) = n == 1 ? shade[m eq 'series' ? 4 : m eq 'pade' ? 5 : 3] : colour(c, n)
curve(c, u, m) = both(both(in_case(word(all, c)), of_unknown(main, u)), with_word(main, 'method', m))
rate_of(c, u) = ask(sprintf("awk -F, 'NR > 1 && %s && $%d != \"\" { print $%d; exit }' '%s'", both(in_case(word(all, c)), of_unknown(radii, u)), place(radii, 'rate'), place(radii, 'rate'), radii))
height_of(c, u, rate) = number(ask(sprintf("awk -F, 'NR > 1 && %s && $%d !~ /inf/ && $%d != \"\" { h = $%d - $%d * %.12g; if (!s++ || h > m) m = h } END { print s ? m : 0 }' '%s'", curve(c, u, 'series'), y, y, y, N, log10(rate), main)))

eval grid(drawn, 3)
foot = foot_for(shown_in_key(n) + 4, n == 1 ? 14 : 20)
bottom = least(main, sprintf('%d', y), '1', 0)
top = greatest(main, sprintf('%d', y), '1', 0)
do for [kind in terminals] {
    eval figure_of(kind, stem)
    eval heading('Error of the series of '.called.' and of its approximants', 'the largest error at times up to '.tidy(first_of(radii, place(radii, 'reach'), '1')).' from the start, in '.scalar.left_out)
    do for [p=1:drawn] {
        u = drawn_unknown(p)
        eval panel(p)
        set lmargin 9; set rmargin 3; set tmargin 2; set bmargin 3.6
        set title u offset 0, -0.5
        eval rising('x', least(main, sprintf('%d', N), '1', 0), greatest(main, sprintf('%d', N), '1', 1))
        set yrange [bottom - 1:top + 1]
        set xlabel 'order N'
        set ylabel 'log_{10} (max |error| / '.unit_name(u).')'
        unset key
        array slope[n]
        array height[n]
        do for [c=1:n] {
            r = rate_of(c, u)
            slope[c] = strlen(r) > 0 ? log10(number(r)) : 0
            height[c] = strlen(r) > 0 ? height_of(c, u, number(r)) : 1e9
        }
        plot for [c=1:n] height[c] + x * slope[c] with lines lw 1 dt 3 lc rgb tone(c, 'series'), \
             for [c=1:n] for [m in methods] rows(main, N, y, curve(c, u, m)) using 1:2 with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb tone(c, m)
        eval no_heading
    }
    eval key_strip
    plot for [m in methods] NaN with linespoints lw 1.8 dt number_of(m) pt mark[number_of(m)] ps 0.7 lc rgb n == 1 ? tone(1, m) : soft title name_of(m), \
         NaN with lines lw 1 dt 3 lc rgb soft title 'rate (reach/R)^N', \
         for [c=1:n] NaN with lines lw 2.4 lc rgb tone(c, 'series') title n > 1 && in_key(c, n) ? case_name(main, k, word(all, c)) : ''
    unset multiplot
    unset output
    eval restart
}
