// The logarithm to the base 2.
#pragma once

#include "libration/function/elementary/base_logarithm.hpp"

namespace libration::function {

struct log2_function : base_logarithm<2, mpfr_log2> {
    static constexpr auto kind = function_kind::log2;
    static constexpr std::string_view name = "log2";
};

}  // namespace libration::function
