// The public interface of the target libration::libration, which does not need FLINT. The header of a single folder, such
// as pendulum/pendulum.hpp or series/series.hpp, compiles faster.
#pragma once

#include "libration/algebra/algebra.hpp"
#include "libration/approximant/approximant.hpp"
#include "libration/approximant/asymptotic.hpp"
#include "libration/convergence/convergence.hpp"
#include "libration/digits/digits.hpp"
#include "libration/elliptic/elliptic.hpp"
#include "libration/ode.hpp"
#include "libration/pendulum/pendulum.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/scalar.hpp"
#include "libration/series/series.hpp"
