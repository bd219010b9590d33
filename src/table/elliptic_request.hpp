// What `elliptic` and `table` are asked about am, sn, cn, dn, K and F: functions, arguments and moduli, and the proved
// values.
#pragma once

#include <string>
#include <vector>

#include "libration/elliptic/proved/proved_functions.hpp"
#include "option/option_words.hpp"

namespace libration {

/// A modulus k, parameter m or complementary parameter m1 as typed.
struct typed_parameter {
    exact typed;
    elliptic::exact_parameter (*from)(const exact&);

    elliptic::exact_parameter value() const { return from(typed); }
};

/// Every function at every argument and every parameter.
struct elliptic_request {
    std::vector<std::string> functions;
    std::string option;  ///< --k, --m or --m1
    std::vector<typed_parameter> parameters;
    std::string argument;          ///< u or phi; empty for K
    std::vector<exact> arguments;  ///< for K, one without a text
};

/// --u, --phi, --k, --m, --m1.
void offer_elliptic(option_words& said, CLI::App& command);

/// Whether a name is one of am, sn, cn, dn, K, F.
bool is_elliptic_function(const std::string& name);

/// Whether one parameter may be given, or lists and ranges of them.
enum class elliptic_grid { one, lists };

/// Reads what was said for functions that take the same argument. Throws input_error.
elliptic_request read_elliptic(const std::vector<std::string>& functions, const option_words& said, elliptic_grid grid);

/// The function as a ball, in the working precision and as many digits more as the argument has before its point.
/// Throws precision_exhausted as jacobi_value does, and error where the function is infinite.
ball function_ball(const std::string& function, const exact& at, const elliptic::exact_parameter& p);

/// `digits` proved digits; inf or -inf where the function is infinite, 0 where it is 0.
std::string function_text(const std::string& function, const exact& at, const elliptic::exact_parameter& p,
                          long digits);

/// Whether K or F is infinite there.
bool is_infinite(const std::string& function, const exact& at, const elliptic::exact_parameter& p);

}  // namespace libration
