// The C interface as a test calls it: handles that free themselves, and codes that have to be 0.
#pragma once

#include <libration.h>

#include <catch2/catch.hpp>
#include <memory>
#include <string>

namespace c_test {

template <class Handle, void (*free)(Handle*)>
struct freeing {
    void operator()(Handle* handle) const { free(handle); }
};
template <class Handle, void (*free)(Handle*)>
using owned = std::unique_ptr<Handle, freeing<Handle, free>>;
using number = owned<libration_number, libration_number_free>;
using table = owned<libration_table, libration_table_free>;
using motion = owned<libration_motion, libration_motion_free>;
using problem = owned<libration_problem, libration_problem_free>;
using sampler = owned<libration_sampler, libration_sampler_free>;

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
