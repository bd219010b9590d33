# all_time: error against the number of periods; one panel per method for T*, and in a second figure per scalar.
load scripts.'/style.gp'
hue_name(E) = 'E = '.number_name(E)
tone(h) = colour(h, words(hues))
settings = "hue_by = 'energy'; eval seen('hues', table, 'energy', '1'); x = 'log10_periods'; x_name = 'log_{10} p'; y_name = norm_axis; y_where = \"at('log10_error') > -40\"; y_together = 'log10_error log10_predicted'"

figure = 'all_time'
table = data.'/all_time.csv'
eval settings
title_text = 'Error after p periods with an inexact T*'
below_text = 'each panel: T* from N powers of its series or of the resummation'
panel_by = 'period_by'; most_across = 4
# Energies whose errors are below the axis are named in the panel.
below_axis = "below = ''; do for [h=1:words(hues)] { eval count_of('drawn', table, of_hue(\"at('log10_error') > y_low\")); if (drawn == 0) { below = below.(below eq '' ? 'below 10^{'.sprintf('%.0f', floor(y_low)).\"}:\\nE = \" : ', ').number_name(word(hues, h)) } }; "
prepare = below_axis."panel_title = rule_name(this); set label 50 below at graph 0.04, 0.13 font ',11' textcolor rgb soft"
finish = 'unset label 50'
layers = by_hue('log10_predicted', '1', 'lines lw 1.4 dt 3 lc rgb tone(h)').', '.by_hue('log10_error', '1', 'linespoints lw 1.8 pt mark_of(h) ps 0.9 lc rgb tone(h)')
key = key_of_hues('linespoints lw 1.8 pt mark_of(h) ps 0.9 lc rgb tone(h)').', '.key_entry('lines lw 1.4 dt 3 lc rgb soft', "'estimate'")
entries = shown_in_key(words(hues)) + 1; letters = 12
load scripts.'/shared/panels.gp'

figure = 'all_time_reduction'
table = data.'/all_time_reduction.csv'
eval settings
title_text = 'The exact solution after p periods in each arithmetic'
below_text = 'the time reduced by fmod in that arithmetic, or exactly'
panel_by = 'scalar'
prepare = 'panel_title = arithmetic_name(this)'
layers = by_hue('log10_predicted', "is('reduction', 'fmod')", 'lines lw 1.4 dt 3 lc rgb tone(h)') \
    .', '.by_hue('log10_error', "is('reduction', 'exact')", 'linespoints lw 1.8 dt 2 pt mark_of(h) ps 0.6 lc rgb tone(h)') \
    .', '.by_hue('log10_error', "is('reduction', 'fmod')", 'linespoints lw 1.8 pt mark_of(h) ps 0.9 lc rgb tone(h)')
key = key_of_hues('linespoints lw 1.8 pt mark_of(h) ps 0.9 lc rgb tone(h)').', '.key_entry('lines lw 1.8 lc rgb soft', "'by fmod'") \
    .', '.key_entry('lines lw 1.4 dt 3 lc rgb soft', "'its bound'").', '.key_entry('lines lw 1.8 dt 2 lc rgb soft', "'exactly'")
entries = shown_in_key(words(hues)) + 3; letters = 12
load scripts.'/shared/panels.gp'
