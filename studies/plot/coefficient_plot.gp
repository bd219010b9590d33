# coefficient_plot: the plots of lists of coefficients by which the nearest singularity is found: for each list a
# Domb-Sykes plot, the root test and the poles of a Pade approximant below each other, so that a narrow screen shows
# them as well.
# `list_names`, `pade_order`, `figure`, `figure_title` and `figure_note` are texts. Columns of ratios_K: n,inverse_n,
# ratio,root,corrected_root,power,ratio_in_power,pair_ratio; of poles_K: kind,position_re,position_im,modulus,distance;
# of radius: method,radius,uncertainty,...,unknown.
load scripts.'/style.gp'
load scripts.'/shared/ratio_fit.gp'

verdicts = data.'/radius.csv'
place(c) = or_0(ask(sprintf("head -n 1 '%s' | tr ',' '\\n' | grep -nxF -- '%s' | cut -d: -f1", verdicts, c)))
several = place('unknown')
n = words(list_names)
list_at = 1
of_list(m) = several ? sprintf('$1 == "%s" && $%d == "%s"', m, several, word(list_names, list_at)) : sprintf('$1 == "%s"', m)
test_cell(m, c) = first_of(verdicts, place(c), of_list(m))
shown_name(i) = n > 1 ? word(list_names, i) : ''

across = 1; down = 3 * n
panel_w = 640; panel_h = 400
foot = 10
do for [kind in terminals] {
    eval figure_of(kind, figure)
    eval heading(figure_title, figure_note)
    set lmargin 12; set rmargin 3; set bmargin 3.6
    do for [i=1:n] {
        ratios = data.sprintf('/ratios_%d.csv', i)
        poles = data.sprintf('/poles_%d.csv', i)
        named = shown_name(i)
        list_at = i
        do for [k=1:3] {
            part = word('ratios roots poles', k)
            eval panel(3 * i - 3 + k)
            load scripts.'/shared/coefficient_panel.gp'
            eval no_heading
        }
    }
    eval figure_done
}
