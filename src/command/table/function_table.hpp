// A table of elliptic functions: proved values over a grid of arguments and parameters, and how well conditioned they
// are.
#pragma once

#include <string>
#include <vector>

#include "libration/elliptic/named_function.hpp"
#include "option/option_words.hpp"
#include "table/motion_table.hpp"
#include "text/table.hpp"

namespace libration {

/// The functions of a list such as am,sn,cn,dn, which take the same argument; throws input_error.
std::vector<const elliptic::named_function*> functions_of(const std::string& list);

/// Every function at every argument and every parameter, parameters first. In the typed style one value per row:
/// function, argument, k, m or m1, value, condition, digits, rigour, of Pi also n. In decimals one argument per row,
/// with a column for each function: u or phi, k, m or m1, the functions, condition_NAME for each. With complex
/// arguments the value is the real part and a column `imaginary` follows; in decimals u_re, u_im, k, m or m1, NAME_re,
/// NAME_im, condition_NAME.
///
/// condition = (|u df/du| + |x df/dx|)/|f| with x the parameter as typed, of Pi also |n df/dn|, to three digits and
/// heuristic (function_condition); inf where f is 0 or infinite and not exact. Throws input_error.
table function_table(const std::vector<const elliptic::named_function*>& functions, const option_words& said,
                     long digits, input_style style, int jobs);

}  // namespace libration
