# rotation_series: the partial sums from the top, extended to two periods of rotation.
name = 'rotation_series'
heading_text = 'The series from the top, extended periodically: rotation'
load scripts.'/pendulum/extension.gp'
