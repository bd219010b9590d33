# series: the accuracy of a list of coefficients as a function. Columns of errors: time,method,order,error,log10_error;
# of poles: kind,position_re,position_im,modulus,distance; of ratios:
# n,inverse_n,ratio,root,corrected_root,power,ratio_in_power,pair_ratio; of the radius: method,radius,uncertainty,...
load scripts.'/style.gp'
ratios = data.'/ratios.csv'
poles = data.'/poles.csv'
tests = data.'/radius.csv'
of_list = '1'
named = ''
pade_order = ''
load scripts.'/shared/coefficient_panel.gp'
array drawn[3] = [ratios_drawn, 1, poles_drawn]
do for [part=1:3] {
    if (drawn[part] > 0) {
        figure = word('domb_sykes roots poles', part)
        table = ratios; x = 'inverse_n'; width = 720; height = part == 3 ? 520 : 420; title_text = ' '
        prepare = part == 1 ? ratios_panel : part == 2 ? roots_panel : poles_panel
        load scripts.'/shared/panels.gp'
    }
}

figure = 'errors'
table = data.'/errors.csv'
eval count_of('compared', table, '1')
if (compared > 0) {
    # Six of the times with an error, from the first to the last.
    eval seen('times', table, 'time', "has('log10_error') && !is('log10_error', '-inf')")
    shown = smaller(words(times), 6)
    do for [h=1:shown] { hues = hues.' '.pick(times, shown, h) }
    title_text = 'Errors of the list'
    panel_by = 'method'; width = 420; height = 400
    hue_by = 'time'; hue_name(t) = 't = '.number_name(t)
    prepare = "panel_title = 'Error of '.(this eq 'pade' ? 'Padé approximants' : this eq 'series' ? 'partial sums' : this.' approximants')"
    eval extent('order', table, 'order', '1')
    x = 'order'; x_name = 'order N'; x_axis = 'set xrange [0:order_high * 1.05]'
    y_name = 'log_{10} |value − reference|'; y_together = 'log10_error'
    line = 'linespoints pt 6 ps 0.6 lw 1.5 lc rgb shade[(h - 1) % 6 + 1]'
    layers = by_hue('log10_error', '1', line)
    key = key_of_hues(line)
    entries = shown
    load scripts.'/shared/panels.gp'
}
