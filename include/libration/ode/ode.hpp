// Differential equations as text and in C++, and numerical solutions of the pendulum's.
#pragma once

#include "libration/ode/equation_system.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/ode/expression.hpp"
#include "libration/ode/flow.hpp"
#include "libration/ode/numerical_solution.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/runge_kutta.hpp"
