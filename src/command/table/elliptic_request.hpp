// The requests of `elliptic` and `table` for elliptic functions: functions, arguments and moduli.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "option/option_words.hpp"
#include "table/elliptic_values.hpp"

namespace libration {

/// Every function at every point.
struct elliptic_request {
    std::vector<const elliptic::named_function*> functions;
    std::string modulus;                 ///< k, m, m1, alpha, alpha_deg or q
    std::string argument;                ///< u, phi, x or z; empty where the functions have none
    std::vector<elliptic_point> points;  ///< of a grid, the parameters first
    bool from_file = false;              ///< the points are rows of --points

    bool has_characteristic() const { return functions.front()->has_characteristic; }
    bool is_complex() const {
        return std::any_of(points.begin(), points.end(), [](const elliptic_point& at) { return at.imaginary; });
    }
};

/// The complaint of a function about one of its inputs, as one about the option or the column that gave it. Throws
/// input_error; what leaves something open, and what is about no input, as it is.
[[noreturn]] void refuse_input(const elliptic_request& request, const elliptic_point& at, const error& complaint);

/// compute() of a point, whose complaints name the option or the column.
template <class Compute>
auto answer_at(const elliptic_request& request, const elliptic_point& at, const Compute& compute) {
    try {
        return compute();
    } catch (const error& complaint) {
        refuse_input(request, at, complaint);
    }
}

/// --u, --phi, --x, --z, --n, --k, --m, --m1, --alpha, --q.
void offer_elliptic(option_words& said, CLI::App& command);

/// The names of all functions: "am, sn, ...".
std::string elliptic_names();

/// Whether one parameter may be given, or lists and ranges of parameters.
enum class elliptic_grid { one, lists };

/// Parses the options for functions with the same argument; with lists also --points, a file with columns.
/// Throws input_error.
elliptic_request read_elliptic(const std::vector<const elliptic::named_function*>& functions, const option_words& said,
                               elliptic_grid grid);

/// The parameter of --k, --m, --m1, --alpha or --q, without the dashes, from a number; throws error where there is none.
typed_parameter parameter_of(const std::string& quantity, const exact& typed);

/// A number that an argument of this name may be: an angle for phi. Throws error.
void require_argument(const std::string& name, const exact& argument);

}  // namespace libration
