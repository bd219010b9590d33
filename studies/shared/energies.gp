# Panels over the energy, and towards E = 2 from either side where there are several energies near it: before this is
# loaded a script sets `table`, and `y_columns`, whose values near E = 2 set the range of y there.
near = "at('log10_gap') < -0.9"
eval seen('energies_between', table, 'energy', "at('log10_gap') > -2.1")
eval seen('energies_below', table, 'log10_gap', near.' && !('.rotates.')')
eval seen('energies_above', table, 'log10_gap', near.' && '.rotates)
panels = (words(energies_below) > 1 ? ' "libration"' : '').(words(energies_above) > 1 ? ' "rotation"' : '')
if (words(energies_between) > 1 || panels eq '') { panels = '"energy"'.panels }
always = "(this eq 'energy' || (this eq 'rotation') == (".rotates."))"
x = "this eq 'energy' ? at('energy') : at('log10_gap')"
x_axis = "if (this eq 'energy') { eval extent('x', table, 'energy', '1'); eval energies_on_x(x_low, x_high); eval separatrix_on_x(x_low, x_high); set xlabel e_axis } else { eval extent('x', table, 'log10_gap', always); eval falling('x', x_low, x_high); set xlabel gap_axis }"
y_axis = "eval extent('y', table, y_columns, this eq 'energy' ? '1' : both(always, near)); eval rising('y', larger(y_low, y_least), y_high)"
this = 'energy'
y_least = -1e9
prepare = "panel_title = this eq 'energy' ? '' : this eq 'libration' ? 'libration, E < 2' : 'rotation, E > 2'"
finish = 'eval energies_done'
height = 540
