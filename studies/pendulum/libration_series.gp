# libration_series: the partial sums from the top, extended to two periods of libration.
name = 'libration_series'
heading_text = 'The series from the top, extended periodically: libration'
load scripts.'/pendulum/extension.gp'
