# terms: the least order for D digits against the distance of E from 2, on either side; for one energy or two against D.
#
# For any equation: the least order against the number of digits, one panel per unknown, one colour per combination of
# the parameters; thin the prediction from the rate of the series.
if (equation ne '') {
    load scripts.'/shared/equation.gp'
    eval equation_panels('digits')
    title_text = 'Terms for D digits of '.called
    below_text = 'the least order whose largest error at the times is at most 10^{−D}'
    kind_by = 'method'; kinds = 'series endpoint'
    kind_name(m) = m
    hue(h, k) = cases < 2 ? shade[5 - k] : tone(h)
    x = 'digits'; x_name = 'digits D'; y_name = 'least order N'; y_axis = 'set yrange [0:*]'
    layers = by_hue('predicted', "is('method', 'series')", 'lines lw 1 dt 3 lc rgb hue(h, 1)') \
        .', '.curves('order', '1', 'linespoints lw 1.8 dt 3 - k pt mark[2 * k - 1] ps 0.7 lc rgb hue(h, k)')
    key = key_of_kinds('linespoints lw 1.8 dt 3 - k pt mark[2 * k - 1] ps 0.7 lc rgb cases < 2 ? hue(1, k) : soft') \
        .', '.key_entry('lines lw 1 dt 3 lc rgb soft', "'rate of the series'").', '.key_of_cases('lines lw 2.4 lc rgb tone(h)')
    entries = shown_in_key(cases) + 3; letters = 18
    load scripts.'/shared/panels.gp'
    exit
}

load scripts.'/style.gp'
tone(h) = words(hues) <= 6 ? shade[word('4 6 2 3 5 1', h) + 0] : colour(h, words(hues))     # neighbours far apart

figure = 'terms'
table = data.'/terms.csv'
title_text = 'Powers for D digits on [0, T*]'
below_text = 'the error norm is at most 10^{−D} rad'
kind_by = 'method'; kinds = 'series resummed'
kind_name(m) = approximation_name(m)
hue_name(D) = 'D = '.D
y_name = 'order N'; most_across = 2; height = 500
one_two_five = '1'
do for [k=0:6] { do for [m in '2 5 10'] { one_two_five = one_two_five.sprintf(', %d', m * 10**k) } }
eval seen('energies', table, 'energy', '1')
eval extent('y', table, 'order proved_order', "at('order') > 0 || at('proved_order') > 0")
# Powers of ten would be one or two tics of a short axis.
y_axis = 'set logscale y; set yrange [y_low / 1.6:y_high * 1.6]; if (y_high < 30 * y_low) { eval "set ytics (".one_two_five.")" }'
if (words(energies) <= 2) {
    eval energy_names(table)
    panel_by = 'energy'; x = 'digits'; x_name = 'digits D'
    prepare = "set lmargin 11; panel_title = 'E = '.named_energy(this)"
    hues = '-'
    hue(h, k) = shade[k == 1 ? 5 : 4]
} else {
    this = 'libration'
    always = "(this eq 'rotation') == (".rotates.")"
    do for [this in 'libration rotation'] {
        eval count_of('count', table, always)
        panels = panels.(count > 0 ? ' '.this : '')
    }
    hue_by = 'digits'; x = 'log10_gap'; x_name = gap_axis
    hues = ''
    eval seen('hues', table, 'digits', '1')
    prepare = "set lmargin 11; panel_title = this.(this eq 'libration' ? ', E < 2' : ', E > 2')"
    x_axis = "eval extent('x', table, 'log10_gap', always); eval falling('x', x_low, x_high)"
    hue(h, k) = tone(h)
}
layers = by_hue('predicted', "is('method', 'series')", "lines lw 1.5 dt 3 lc rgb hue_by eq '' ? '#444444' : tone(h)") \
    .', '.curves('order', "at('order') > 0", 'linespoints pt 7 ps 0.5 lw 2 dt 3 - k lc rgb hue(h, k)') \
    .', '.curves('proved_order', '1', 'points pt k ps 0.8 lc rgb hue(h, k)')
key = (hue_by eq '' ? '' : key_of_hues('lines lw 2.4 lc rgb tone(h)').', ') \
    .key_of_kinds("linespoints pt 7 ps 0.5 lw 2 dt 3 - k lc rgb hue_by eq '' ? hue(1, k) : soft") \
    .', for [k=1:2] '.key_entry('points pt k ps 0.8 lc rgb soft', "'proved bound, '.kind_name(word(kinds, k))") \
    .', '.key_entry('lines lw 1.5 dt 3 lc rgb soft', "'D ln 10 / ln (R/T*)'")
entries = shown_in_key(words(hues)) + 5; letters = 17
load scripts.'/shared/panels.gp'
