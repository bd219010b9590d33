// Differential equations from text and C++, and their Taylor series over any scalar.
#pragma once

#include "libration/ode/equation_system.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/ode/expression.hpp"
#include "libration/ode/functor.hpp"
#include "libration/ode/invariant.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/path.hpp"
#include "libration/ode/step.hpp"
#include "libration/ode/tape.hpp"
#include "libration/ode/taylor_expansion.hpp"
#include "libration/ode/trajectory.hpp"
