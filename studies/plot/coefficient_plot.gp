# coefficient_plot: the plots of lists of coefficients by which the nearest singularity is found: for each list a
# Domb-Sykes plot, the root test and the poles of a Pade approximant below each other, so that a narrow screen shows
# them as well, and the plots of the verdict for which it has data.
# `list_names`, `pade_order`, `figure`, `figure_title` and `figure_note` are texts. Columns of ratios_K: n,inverse_n,
# ratio,root,corrected_root,power,ratio_in_power,pair_ratio; of poles_K: kind,position_re,position_im,modulus,distance;
# of radius: method,radius,uncertainty,...,unknown; of history_K, fits_K, predictions_K: see shared/verdict_panels.gp.
load scripts.'/style.gp'
tests = data.'/radius.csv'
eval has_column('several', tests, 'unknown')
n = words(list_names)
of_verdict(name, k) = sprintf('%s/%s_%d.csv', data, name, k)
list_panel = "named = n > 1 ? word(list_names, list) : ''; of_list = several ? \"is('unknown', word(list_names, list))\" : '1'; ratios = sprintf('%s/ratios_%d.csv', data, list); poles = sprintf('%s/poles_%d.csv', data, list); load scripts.'/shared/coefficient_panel.gp'; history = of_verdict('history', list); fits = of_verdict('fits', list); predictions = of_verdict('predictions', list); load scripts.'/shared/verdict_panels.gp'"
list = 1
eval list_panel
table = ratios
do for [k=1:n] {
    do for [name in 'ratios roots poles'] { panels = panels.sprintf(' %d:%s', k, name) }
    do for [name in 'history fits predictions'] {
        if (exists_file(of_verdict(name, k))) { panels = panels.sprintf(' %d:%s', k, name) }
    }
}
title_text = figure_title; below_text = figure_note
most_panels = 6 * n; most_across = 1; width = 640; height = 400
prepare = "list = this[1:1] + 0; eval list_panel; eval value(this[3:*].'_panel')"
finish = 'set size noratio; set xtics autofreq; set ytics autofreq; unset logscale; unset key'
load scripts.'/shared/panels.gp'
