#pragma once
// What nearly every source of the library includes and is slow to compile. It saves time and nothing else: each source
// includes what it uses, and `./run lint` compiles without this file.

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#if __has_include(<quadmath.h>)
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
