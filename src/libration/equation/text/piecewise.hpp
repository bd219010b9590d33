// Piecewise functions in the text of a problem, as formulas of step functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// Those of forms in piecewise.cpp.
enum class piecewise_kind { conditional, absolute, sign, maximum, minimum, heaviside, floor, square, sawtooth };

/// The piecewise function of this name, for example "abs"; std::nullopt for other names.
std::optional<piecewise_kind> piecewise_named(std::string_view name);
/// abs(x) has one argument, max(a, b) two; the condition of if(x > 0, a, b) counts as one.
std::size_t arguments_of(piecewise_kind kind);
/// The form of a call, for messages: abs(x).
std::string form_of(piecewise_kind kind);

/// difference > 0, or difference >= 0.
struct comparison {
    expression difference;
    bool or_equal = false;
};

/// Collects the step functions of the equations of a problem: s = sign(u) with sign(0) = 0, its indicators [u > 0] and
/// [u >= 0], and n = floor(u), by which
///     if(u > 0, a, b) = [u > 0] a + (1 - [u > 0]) b, the same with >=,
///     abs(u) = if(u > 0, u, -u), max(a, b) = if(a - b > 0, a, b), min(a, b) = if(a - b > 0, b, a),
///     heaviside(u) = (1 + s)/2, so that heaviside(0) = 1/2,
///     square(u) = 1 - 2 (floor(u/pi) - 2 floor(u/(2 pi))), sawtooth(u) = u/pi - 1 - 2 floor(u/(2 pi)).
/// floor(u/d) with d = pi and 2 pi is a separate step function, so that its times are exact. With numbers for the
/// step functions these formulas fold exactly to the branch that is chosen.
class step_collector {
public:
    explicit step_collector(std::vector<step_function>& steps) : steps_(steps) {}

    /// if(condition, a, b).
    expression chosen(const comparison& condition, const expression& a, const expression& b, const std::string& text,
                      const place& at);
    /// Another piecewise function.
    expression value_of(piecewise_kind kind, const std::vector<expression>& arguments, const std::string& text,
                        const place& at);

private:
    struct oriented_sign {
        std::string parameter;
        int orientation = 1;  // the sign is this times the one of the parameter
    };

    oriented_sign sign(const expression& argument, const std::string& text, const place& at);
    expression floor(const expression& argument, const number& divisor, const std::string& text, const place& at);
    const std::string& added(step_function made);

    std::vector<step_function>& steps_;
};

}  // namespace libration::ode
