// Piecewise functions in the text of a problem, as formulas of step functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libration/ode/equation_system.hpp"

namespace libration::ode {

/// Those of piecewise_names().
enum class piecewise_kind { conditional, absolute, sign, maximum, minimum, heaviside, floor, square, sawtooth };

/// The piecewise function of this name, for example "abs"; std::nullopt for other names.
std::optional<piecewise_kind> piecewise_named(std::string_view name);
/// abs(x) has one argument, max(a, b) two; the condition of if(x > 0, a, b) counts as one.
std::size_t arguments_of(piecewise_kind kind);
/// The form of a call, for messages: abs(x).
std::string form_of(piecewise_kind kind);

/// Collects the step functions of the equations of a problem: s = sign(u), and n = floor(u), by which
///     abs(u) = s u, heaviside(u) = (1 + s)/2, if(u > 0, a, b) = h a + (1 - h) b with h = heaviside(u),
///     max(a, b) = if(a - b > 0, a, b), min(a, b) = if(a - b > 0, b, a),
///     square(u) = 1 - 2 (floor(u/pi) - 2 floor(u/(2 pi))), sawtooth(u) = u/pi - 1 - 2 floor(u/(2 pi)).
/// floor(u/d) with d = pi and 2 pi is a step function of its own, so that its times are exact. With numbers for s and n, these formulas fold to one of their branches exactly.
class step_collector {
public:
    explicit step_collector(std::vector<step_function>& steps) : steps_(steps) {}

    /// A piecewise function; the first argument of `conditional` is u in if(u > 0, a, b).
    expression value_of(piecewise_kind kind, const std::vector<expression>& arguments, const std::string& text,
                        const place& at);

private:
    expression sign(const expression& argument, const std::string& text, const place& at);
    expression floor(const expression& argument, const number& divisor, const std::string& text, const place& at);
    expression added(step_function made);

    std::vector<step_function>& steps_;
};

}  // namespace libration::ode
