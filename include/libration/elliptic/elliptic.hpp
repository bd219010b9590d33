// Elliptic integrals and Jacobi's functions; digits.hpp for decimals without a choice of precision.
#pragma once

#include "libration/elliptic/complete_integral.hpp"
#include "libration/elliptic/complete_integral_series.hpp"
#include "libration/elliptic/digits.hpp"
#include "libration/elliptic/exact_functions.hpp"
#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "libration/elliptic/jacobi_zeta.hpp"
#include "libration/elliptic/modulus.hpp"
