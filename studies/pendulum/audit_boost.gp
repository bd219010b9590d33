# audit_boost: correct digits of theta against the gap, one panel per time.
name = 'audit_boost'
library = 'boost'
called = 'Boost.Math'
load scripts.'/pendulum/audit.gp'
