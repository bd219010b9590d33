#include "given_question.hpp"

#include "libration/number/given_number.hpp"
#include "libration/pendulum/point_coefficients.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

void require_time(const motion& m, const exact& time) {
    if (time.has_periods() && at_critical_energy(m.regime())) {
        throw error(error_kind::argument, error_subject::time, time.text, "is a multiple of an infinite period");
    }
}

exact exact_time(const motion& m, const std::string& text) {
    exact time = given_time("time", text);
    require_time(m, time);
    return time;
}

std::optional<std::string> short_decimal(const std::optional<rational>& value, long digits) {
    return value ? to_finite_decimal(*value, static_cast<std::size_t>(digits)) : std::nullopt;
}

expansion_point exact_point(const motion& m, const std::string& point, long n) {
    if (n < 0 || n > largest_power) {
        throw error(error_kind::argument, "power", std::to_string(n),
                    "is not between 0 and " + std::to_string(largest_power));
    }
    return point_of_motion(m, point);
}

rational energy_of_norm(const motion& m, int order) {
    if (order < 0) {
        throw error(error_kind::argument, "order", std::to_string(order), "is negative");
    }
    if (!m.energy()) {
        throw error(error_kind::argument, error_subject::energy, "",
                    "is not rational: the norm is that of a rational energy");
    }
    if (*m.energy() == 0 || at_critical_energy(m.regime())) {
        throw error(error_kind::argument, error_subject::energy, m.energy()->str(),
                    *m.energy() == 0 ? "leaves theta constant" : "makes the period infinite");
    }
    return *m.energy();
}

}  // namespace libration::pendulum
