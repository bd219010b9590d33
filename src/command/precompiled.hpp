#pragma once
// What nearly every source of the command includes and is slow to compile. It saves time and nothing else: each source
// includes what it uses, and `./run lint` compiles without this file.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>
#if __has_include(<quadmath.h>)
#include <boost/multiprecision/float128.hpp>
#endif
#include <fmt/format.h>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>
