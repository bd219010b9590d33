// The pendulum: exact motions, their solution, series, resummations and errors; digits.hpp computes decimals without
// the need to choose a precision.
#pragma once

#include "libration/pendulum/arc_pade.hpp"
#include "libration/pendulum/bounds.hpp"
#include "libration/pendulum/digits.hpp"
#include "libration/pendulum/endpoint_resummation.hpp"
#include "libration/pendulum/energy.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/pendulum/flow.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/pendulum/numerical_solution.hpp"
#include "libration/pendulum/period.hpp"
#include "libration/pendulum/period_error.hpp"
#include "libration/pendulum/periodic_extension.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/pendulum/runge_kutta.hpp"
#include "libration/pendulum/sampler.hpp"
#include "libration/pendulum/singularities.hpp"
#include "libration/pendulum/uniform_resummation.hpp"
#include "libration/pendulum/variation.hpp"
