// Linear systems and the roots of polynomials.
#pragma once

#include "libration/algebra/first_root.hpp"
#include "libration/algebra/linear_system.hpp"
#include "libration/algebra/polynomial_roots.hpp"
#include "libration/algebra/vandermonde.hpp"
