// The same with rigorously proved digits.
#pragma once

#include "libration/digits/digits.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
