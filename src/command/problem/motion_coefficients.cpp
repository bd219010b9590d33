#include "motion_coefficients.hpp"

#include <algorithm>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/pendulum/point_coefficients.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr long digits_of_differences = 3;
constexpr long more_digits_of_reference = 30;
constexpr long guard_of_terms = 20;

// a_first .. a_last in the unit of time of the motion, by a recurrence in T alone.
template <scalar T>
std::vector<wide_t<T>> by_recurrence(const motion& m, const expansion_point& point, const series_request& powers,
                                     coefficient_route route) {
    if (route == coefficient_route::lattice) {
        return point_coefficients<T>(m, point, powers.first, powers.order);
    }
    using W = wide_t<T>;
    const exact_solution<T> solution(m);
    const T scale = midpoint(radius_about(solution, point).value_or(T(1)));
    const auto start = start_at(solution, phase_of(point, solution));
    const auto scaled = taylor_coefficients_by(route, start, static_cast<int>(powers.order), scale);
    const W unit = widen(scale) * time_unit<W>(m);
    std::vector<W> values;
    for (long n = powers.first; n <= powers.order; ++n) {
        values.push_back(W(widen(scaled[static_cast<int>(n)]) / pow(unit, n)));
    }
    return values;
}

}  // namespace

table coefficients_by_recurrence(const chosen_motion& of, const series_request& powers, coefficient_route route,
                                 const scalar_spec& scalar) {
    const expansion_point point = point_of_motion(of.of, powers.about);
    std::vector<mpfr> expected;
    const precision_scope scope(scalar.digits + more_digits_of_reference);
    expected = point_coefficients<mpfr>(of.of, point, powers.first, powers.order);
    table data({{"n", "power of t"},
                {"coefficient", "a_n in the unit of time of the motion"},
                {"recurrence", "printed | squares | omega | lattice"},
                {"difference", "|difference| from a_n with 30 digits more, by lattice"}});
    std::vector<mpfr> found;
    with_scalar(scalar, 0, [&]<class T>() {
        for (const auto& each : by_recurrence<T>(of.of, point, powers, route)) {
            found.push_back(mpfr(each));
        }
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
        data.add_row({powers.first + static_cast<long>(i), decimal_cell(found[i], scalar.digits), name_of(route),
                      decimal_cell(mpfr(abs(found[i] - expected[i])), digits_of_differences)});
    }
    return data;
}

table coefficients_of_resummation(const chosen_motion& of, const series_request& powers, resummation_formulas by,
                                  long digits) {
    const int order = static_cast<int>(powers.order);
    const bool corrected = by == resummation_formulas::corrected;
    const precision_scope scope(digits + digits_lost_in_terms(of.of, order) + guard_of_terms);
    const resummation_terms terms = terms_of_resummation(of.of, order, by);
    const resummation_terms other = corrected ? terms_by_another_route(of.of, order) : terms;
    using list = std::vector<mpfr> resummation_terms::*;
    const std::vector<list> lists{&resummation_terms::a,           &resummation_terms::s,     &resummation_terms::c,
                                  &resummation_terms::b,           &resummation_terms::a_hat, &resummation_terms::sigma,
                                  &resummation_terms::sigma_slope, &resummation_terms::alpha, &resummation_terms::beta};
    table data({{"n", "index, and the order of the truncation"},
                {"a", "a_n of theta (seriesrec)"},
                {"s", "s_n of sin theta"},
                {"c", "c_n of cos theta"},
                {"b", "b_n (b)"},
                {"a_hat", "ahat_n (approxcoeffs)"},
                {"sigma", "sigma_n(T*) (efficient)"},
                {"sigma_slope", "sigma_n'(T*)"},
                {"alpha", "of the truncation n, coefficient of t^(n+1)"},
                {"beta", "of the truncation n, coefficient of t^(n+2)"},
                {"tstar", "T*"},
                {"theta_star", "theta*, the angle at the bottom; the printed formulas have 0"},
                {"omega_star", "omega*, the angular velocity at the bottom"},
                {"formulas", "corrected | printed"},
                {"rigour", "two-method | as printed"}});
    for (auto n = static_cast<std::size_t>(powers.first); n < terms.a.size(); ++n) {
        table_row_cells row{cell(static_cast<long>(n))};
        bool agreed = true;
        for (const list each : lists) {
            row.push_back(decimal_cell((terms.*each)[n], digits));
            agreed = agreed && agree((terms.*each)[n], (other.*each)[n], digits);
        }
        for (const mpfr& each : {terms.effective_period, terms.angle, terms.speed}) {
            row.push_back(decimal_cell(each, digits));
        }
        row.push_back(corrected ? "corrected" : "printed");
        row.push_back(!corrected ? "as printed" : agreed ? "two-method" : "heuristic");
        data.add_row(std::move(row));
    }
    return data;
}

}  // namespace libration
