// The C interface as a test calls it: owned handles, and codes that have to be 0.
#pragma once

#include <libration.h>

#include <catch2/catch.hpp>
#include <string>

#include "interface/owned_handles.hpp"

namespace c_test {

using namespace libration::owned;

/// What f(&handle) makes; the code has to be 0.
template <class Owned, class Call>
Owned made(const Call& call) {
    typename Owned::pointer handle = nullptr;
    const int code = call(&handle);
    INFO(libration_error_message());
    REQUIRE(code == LIBRATION_OK);
    REQUIRE(handle != nullptr);
    return Owned(handle);
}

inline motion motion_of(const std::string& given) {
    return made<motion>([&](auto** to) { return libration_motion_new(given.c_str(), to); });
}

inline problem problem_of(const std::string& text, const char* settings = nullptr) {
    return made<problem>([&](auto** to) { return libration_problem_new(text.c_str(), settings, to); });
}

inline std::string digits_of(const number& x) { return libration_number_decimal(x.get()); }

inline std::string cell(const table& of, std::size_t row, std::size_t column) {
    return libration_table_text(of.get(), row, column);
}

}  // namespace c_test
