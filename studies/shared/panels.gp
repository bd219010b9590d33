# Draws a figure of equal panels from the settings of style.gp, section "panels", and returns to their defaults.
if (panel_by ne '' && panels eq '') { eval seen('panels', table, panel_by, always) }
if (hue_by ne '' && hues eq '') { eval seen_together('hues', table, hue_by, always) }
if (kind_by ne '' && kinds eq '') { eval seen('kinds', table, kind_by, always) }
if (panels eq '') { panels = '-' }
if (hues eq '') { hues = '-' }
if (kinds eq '') { kinds = '-' }
all_panels = words(panels)
columns_drawn = all_panels < most_panels ? all_panels : most_panels
if (columns_drawn < all_panels) { below_text = below_text.sprintf(' (%d of %d panels)', columns_drawn, all_panels) }
if (!strstrt(x, '(')) { eval extent('x', table, x, always) }
if (x_axis eq '') { x_axis = rising('x', x_low, x_high) }
if (y_together ne '') {
    eval extent('y', table, y_together, both(always, y_where))
    y_axis = rising('y', y_low, y_high)
}
if (rows_down > 1) { across = columns_drawn; down = rows_down } else { eval grid(columns_drawn, most_across) }
panel_w = width > 0 ? width : across == 1 ? 900 : across == 2 ? 590 : across == 3 ? 400 : 310
panel_h = height > 0 ? height : rows_down > 1 ? 320 : across == 1 ? 520 : 430
foot = key eq '' ? 20 : foot_for(entries, letters)
do for [terminal_kind in terminals] {
    eval figure_of(terminal_kind, figure)
    eval heading(title_text, below_text)
    do for [row=1:rows_down] {
        do for [p=1:columns_drawn] {
            this = pick(panels, columns_drawn, p)
            eval panel((row - 1) * columns_drawn + p)
            set lmargin 10; set rmargin 3; set tmargin 2; set bmargin 3.6
            set offsets graph 0, graph 0, graph 0.04, graph 0.04
            unset key
            panel_title = panel_by eq '' ? '' : this
            set xlabel x_name
            set yrange [*:*]
            eval prepare
            eval x_axis
            eval y_axis
            set title panel_title offset 0, -0.5
            if (y_name_everywhere || (p - 1) % across == 0) { set ylabel y_name } else { unset ylabel }
            eval 'plot '.layers
            unset arrow
            eval no_heading
            eval finish
        }
    }
    if (key ne '') {
        eval key_strip
        eval 'plot '.key
    }
    eval figure_done
}
eval panel_defaults
