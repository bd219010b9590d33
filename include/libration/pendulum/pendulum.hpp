// The pendulum: exact motions, their solution, series, resummations and errors; digits.hpp computes decimals without
// the need to choose a precision.
#pragma once

#include "libration/pendulum/arc/arc_pade.hpp"
#include "libration/pendulum/arc/bounds.hpp"
#include "libration/pendulum/arc/endpoint_resummation.hpp"
#include "libration/pendulum/arc/periodic_extension.hpp"
#include "libration/pendulum/arc/resummation.hpp"
#include "libration/pendulum/arc/uniform_resummation.hpp"
#include "libration/pendulum/digits.hpp"
#include "libration/pendulum/energy/energy.hpp"
#include "libration/pendulum/energy/period.hpp"
#include "libration/pendulum/energy/period_error.hpp"
#include "libration/pendulum/error/error_norm.hpp"
#include "libration/pendulum/motion/motion.hpp"
#include "libration/pendulum/numerical/flow.hpp"
#include "libration/pendulum/numerical/numerical_solution.hpp"
#include "libration/pendulum/numerical/runge_kutta.hpp"
#include "libration/pendulum/sampler/sampler.hpp"
#include "libration/pendulum/singularity/singularities.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/solution/variation.hpp"
#include "libration/pendulum/taylor/expansion.hpp"
