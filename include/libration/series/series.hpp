// Truncated power series over any ring: their kernels, coefficient by coefficient, and the functions based on them.
#pragma once

#include "libration/series/arithmetic.hpp"
#include "libration/series/exponential.hpp"
#include "libration/series/jet.hpp"
#include "libration/series/kernel.hpp"
#include "libration/series/power_series.hpp"
#include "libration/series/square_root.hpp"
#include "libration/series/tangent.hpp"
