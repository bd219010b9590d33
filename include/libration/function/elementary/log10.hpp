// The logarithm to the base 10.
#pragma once

#include "libration/function/elementary/base_logarithm.hpp"

namespace libration::function {

struct log10_function : base_logarithm<10, mpfr_log10> {
    static constexpr auto kind = function_kind::log10;
    static constexpr std::string_view name = "log10";
};

}  // namespace libration::function
