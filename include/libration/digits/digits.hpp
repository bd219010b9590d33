// Any number of correct digits: the precision is increased until they are reached.
#pragma once

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/digits/precision_loop.hpp"
