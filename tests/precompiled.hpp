#pragma once
// What nearly every test includes and is slow to compile. It saves time and nothing else: each test includes
// what it uses, and `./run lint` compiles without this file.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>
#if __has_include(<quadmath.h>)
#include <boost/multiprecision/float128.hpp>
#endif
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>
