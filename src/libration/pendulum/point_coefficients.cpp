#include "libration/pendulum/point_coefficients.hpp"

#include <algorithm>
#include <optional>

#include "libration/pendulum/vanishing_coefficients.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

namespace {

// Fractions of N digits are too expensive beyond.
constexpr long longest_exact_series = 1000;

}  // namespace

std::vector<bool> vanishing_at(const motion& m, const expansion_point& point, long first, long last) {
    const phase<mpfr> at = phase_of<mpfr>(point, m);
    const bool from_start = point.where == expansion_point::place::start;
    const auto cosine = at.side == 0 ? rational_cosine_at(m, at.quarter)
                        : from_start ? rational_cosine_at_start(m)
                                     : std::nullopt;
    // Beyond, only zeros by symmetry are known, and those are computed as 0.
    const auto order = static_cast<int>(std::min(last, longest_exact_series));
    if (!cosine || first > order) {
        return {};
    }
    const auto all = vanishing_coefficients(*m.energy(), *cosine, order);
    return {all.begin() + first, all.end()};
}

expansion_point point_of_motion(const motion& m, const std::string& name) {
    const bool critical = at_critical_energy(m.regime());
    if (name.empty()) {
        return read_expansion_point(critical ? "bottom" : "top");
    }
    expansion_point point = read_expansion_point(name);
    if (critical && point.where == expansion_point::place::top) {
        throw error(error_kind::argument, error_subject::point, name, "is not a point of a motion with E = 2");
    }
    if (critical && point.time.has_periods()) {
        throw error(error_kind::argument, error_subject::point, name, "is a multiple of an infinite period");
    }
    return point;
}

}  // namespace libration::pendulum
