# solvers: studies/shared/solver_panels.gp.
stem = 'solvers'
solvers_called = 'Solvers of initial value problems in double'
times_called = 'eight'
load scripts.'/shared/solver_panels.gp'
