// Differential equations from text and C++, and their Taylor series over any scalar.
#pragma once

#include "libration/equation/equation_system.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/equation/expression.hpp"
#include "libration/equation/functor.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/invariant.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/plane/path.hpp"
#include "libration/query/trajectory.hpp"
