# coefficient_plot: the plots of lists of coefficients by which the nearest singularity is found: for each list a
# Domb-Sykes plot, the root test and the poles of a Pade approximant below each other, so that a narrow screen shows
# them as well.
# `list_names`, `pade_order`, `figure`, `figure_title` and `figure_note` are texts. Columns of ratios_K: n,inverse_n,
# ratio,root,corrected_root,power,ratio_in_power,pair_ratio; of poles_K: kind,position_re,position_im,modulus,distance;
# of radius: method,radius,uncertainty,...,unknown.
load scripts.'/style.gp'
tests = data.'/radius.csv'
eval has_column('several', tests, 'unknown')
n = words(list_names)
list_panel = "named = n > 1 ? word(list_names, list) : ''; of_list = several ? \"is('unknown', word(list_names, list))\" : '1'; ratios = sprintf('%s/ratios_%d.csv', data, list); poles = sprintf('%s/poles_%d.csv', data, list); load scripts.'/shared/coefficient_panel.gp'"
list = 1
eval list_panel
table = ratios
do for [k=1:3 * n] { panels = panels.' '.k }
title_text = figure_title; below_text = figure_note
most_panels = 3 * n; most_across = 1; width = 640; height = 400
prepare = "list = (p + 2) / 3; eval list_panel; eval p % 3 == 1 ? ratios_panel : p % 3 == 2 ? roots_panel : poles_panel"
finish = 'set size noratio; set xtics autofreq; set ytics autofreq; unset key'
load scripts.'/shared/panels.gp'
