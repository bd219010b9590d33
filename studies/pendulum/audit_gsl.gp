# audit_gsl: correct digits of theta against the gap, one panel per time.
name = 'audit_gsl'
library = 'gsl'
called = 'GSL'
load scripts.'/pendulum/audit.gp'
