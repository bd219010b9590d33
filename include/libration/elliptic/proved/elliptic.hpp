// The same with rigorous enclosures.
#pragma once

#include "libration/elliptic/elliptic.hpp"
#include "libration/elliptic/proved/digits.hpp"
#include "libration/elliptic/proved/function_condition.hpp"
#include "libration/elliptic/proved/named_function.hpp"
#include "libration/elliptic/proved/proved_functions.hpp"
#include "libration/elliptic/proved/theta_values.hpp"
