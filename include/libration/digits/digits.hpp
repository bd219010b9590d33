// As many correct digits as are asked for: the precision grows until they are there.
#pragma once

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/digits/growing_precision.hpp"
