# Of domb_sykes with --prove: the line of the law through the points, and below it the bound of their distance.
eval column_in(main, 'proved_line')
if (has_column) {
    array limit[cases]
    array fall[cases]
    law_here = "do for [c in 'proved_limit proved_line inverse_n'] { eval last_cell('l_'.c, table, c, of_hue(\"has('proved_line')\")) }; limit[h] = l_proved_limit eq '' ? NaN : number(l_proved_limit); fall[h] = limit[h] == limit[h] ? (number(l_proved_line) / limit[h] - 1) / number(l_inverse_n) : NaN"
    ratios_in_panel = prepare.'; do for [h=1:cases] { eval law_here }; y_axis = axis_of_ratios; layers = ratios_of_law; panel_title = this."\n{/*0.8 ".(limit[1] == limit[1] ? "proved limit ".printed("%.15g", l_proved_limit) : "no limit is proved")."}"'
    axis_of_ratios = y_axis
    ratios_of_law = "for [h=1:cases] limit[h] * (1 + fall[h] * x) with lines lw 2 lc rgb cases < 2 ? '#D55E00' : tone(h)" \
        .', '.by_hue('ratio', '1', 'points pt mark_of(h) ps 0.6 lc rgb tone(h)').', '.by_hue('law_ratio', "has('law_ratio') && at('law_error') < 1e-3 * abs(at('law_ratio'))", 'points pt 6 ps 1.1 lc rgb tone(h)') \
        .", for [h=1:cases] '+' using (0):(visible(limit[h])) every ::0::0 with points pt 7 ps 0.9 lc rgb '#D55E00'"
    x = 'n'
    bounds_of_law = by_hue("log10(at('deviation'))", "has('deviation') && at('deviation') > 0", 'lines lw 1.5 lc rgb tone(h)')
    x = 'inverse_n'
    rows_down = 2; height = 400
    eval extent('n', table, 'n', "has('law_ratio')")
    prepare = "if (row == 1) { eval ratios_in_panel } else { set tmargin 3; set lmargin 11; set xlabel 'n'; panel_title = 'proved bound of |ratio − line|'; y_name = 'log_{10} bound'; y_axis = 'set yrange [*:*]'; layers = bounds_of_law }"
    x_axis = "if (row == 1) { set xrange [0:0.26] } else { set xrange [n_low:n_high] }"
    key = key_entry('points pt mark_of(1) ps 0.8 lc rgb cases < 2 ? tone(1) : soft', "'ratio'") \
        .', '.key_entry('points pt 6 ps 1.1 lc rgb cases < 2 ? tone(1) : soft', "'by the law alone'") \
        .', '.key_entry("lines lw 2 lc rgb '#D55E00'", "'proved line'").', '.key_entry("points pt 7 ps 0.9 lc rgb '#D55E00'", "'proved limit'") \
        .', '.key_of_cases('points pt mark_of(h) ps 0.8 lc rgb tone(h)')
    entries = shown_in_key(cases) + 4
}
