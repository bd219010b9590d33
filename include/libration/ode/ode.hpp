// Numerical solutions by Taylor series and by the classical Runge-Kutta method.
#pragma once

#include "libration/ode/flow.hpp"
#include "libration/ode/numerical_solution.hpp"
#include "libration/ode/runge_kutta.hpp"
