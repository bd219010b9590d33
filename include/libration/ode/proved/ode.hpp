// Rigorous results for differential equations: solutions, events, unknowns, conditions at infinity,
// coefficients, condition numbers, singularities and radii of convergence.
#pragma once

#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/proved/condition_numbers.hpp"
#include "libration/ode/proved/problem_coefficients.hpp"
#include "libration/ode/proved/proved_events.hpp"
#include "libration/ode/proved/proved_root.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/ode/proved/solution_branch.hpp"
