# near_separatrix_resummed: the resummation where the pendulum almost stops at the top.
name = 'near_separatrix_resummed'
heading_text = 'The resummation, extended periodically: near the separatrix'
load scripts.'/pendulum/extension.gp'
