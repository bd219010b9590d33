# near_separatrix_series: the partial sums from the top where the pendulum almost stops there.
name = 'near_separatrix_series'
heading_text = 'The series from the top, extended periodically: near the separatrix'
load scripts.'/pendulum/extension.gp'
