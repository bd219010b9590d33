# stiff_solvers: studies/shared/solver_panels.gp.
stem = 'stiff_solvers'
solvers_called = 'Implicit solvers of stiff initial value problems in double'
times_called = 'eleven'
load scripts.'/shared/solver_panels.gp'
