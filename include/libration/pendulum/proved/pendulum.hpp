// The same, proved.
#pragma once

#include "libration/pendulum/error/proved/proved_norm.hpp"
#include "libration/pendulum/pendulum.hpp"
#include "libration/pendulum/proved/condition.hpp"
#include "libration/pendulum/proved/digits.hpp"
#include "libration/pendulum/proved/proved_motion.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/proved/proved_theta.hpp"
