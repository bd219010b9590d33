// The same until they are proved.
#pragma once

#include "libration/digits/digits.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
