// The implementations of the names in named_function.hpp.
#pragma once

#include "libration/elliptic/named_function.hpp"
#include "libration/scalar/error.hpp"

namespace libration::elliptic {

true_value amplitude_value(std::string_view name, const function_arguments& at);
true_value quotient_value(std::string_view name, const function_arguments& at);
true_value inverse_value(std::string_view name, const function_arguments& at);
true_value integral_value(std::string_view name, const function_arguments& at);
true_value zeta_value(std::string_view name, const function_arguments& at);
true_value nome_value(std::string_view name, const function_arguments& at);
true_value theta_value(std::string_view name, const function_arguments& at);

/// sn, cn and dn at u.
jacobi_values<ball> triple_at(const exact& u, const real_parameter& p);

/// A letter of a name: at m = 0 dn is 1, at m = 1 it is cn.
char letter_at(char letter, real_parameter::range where);

inline bool is_exact_zero(const ball& x) { return is_exact(x) && contains_zero(x); }

/// K for a parameter below 1, pi/(2 agm(1, k')) [DLMF 19.8.5].
ball complete_value(const real_parameter& p);

inline true_value exact_value(const rational& value) { return {from_rational<ball>(value), value}; }
inline true_value infinite_value(int sign) { return {ball(0), std::nullopt, ball(1), sign}; }

[[noreturn]] inline void refuse_not_real(std::string_view name, const exact& m) {
    throw error(error_kind::argument, error_subject::parameter, m.text,
                "is above 1, where " + std::string(name) + " is not real");
}

}  // namespace libration::elliptic
