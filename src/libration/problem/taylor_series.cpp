// The Taylor coefficients of a solution.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/law_answer.hpp"
#include "libration/problem/unknown_lists.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "taylor_solution.hpp"

namespace libration {

namespace {

std::vector<std::string> names_of_unknowns(const ode::explicit_system& system, bool parts) {
    std::vector<std::string> names;
    for (const auto& each : system.unknowns()) {
        for (const char* part : parts ? std::vector{"_re", "_im"} : std::vector{""}) {
            names.push_back(each.name + part);
        }
    }
    return names;
}

// One row per power; `value` converts the elements of the list.
template <class Number, class Value>
answer coefficient_answer(const ode::coefficient_request& of, const ode::coefficient_list<Number>& list,
                          const std::string& rigour, const Value& value) {
    answer result{.names = names_of_unknowns(of.system, list.complex), .rows = {}, .rigour = rigour};
    const std::size_t width = result.names.size();
    result.names.insert(result.names.begin(), "n");
    if (list.root > 1) {
        result.names.emplace_back("power");
    }
    for (std::size_t at = 0; at < list.values.size(); at += width) {
        const long n = of.first + static_cast<long>(at / width);
        auto& row = result.rows.emplace_back();
        row.push_back(whole_value(n));
        for (std::size_t i = 0; i < width; ++i) {
            row.push_back(value(list.values[at + i]));
        }
        if (list.root > 1) {
            row.push_back(text_value(rational(n, list.root).str()));
        }
    }
    return result;
}

constexpr long last_order_without_law = 20'000;
constexpr long most_orders_by_law = 1'000;

// Few coefficients of large order by the laws of all unknowns; std::nullopt if one of them has no law, or not all digits.
std::optional<answer> series_by_laws(const ode::coefficient_request& of, const request& how) {
    if (!of.about_start() || of.system.singular() || of.first <= last_order_without_law ||
        of.order - of.first >= most_orders_by_law) {
        return std::nullopt;
    }
    answer result{.names = {"n"}, .rows = {}, .rigour = "proved"};
    law_question asked;
    std::vector<long> orders;
    for (long n = of.first; n <= of.order; ++n) {
        orders.push_back(n);
        result.rows.push_back({whole_value(n)});
    }
    try {
        for (const auto& each : of.system.unknowns()) {
            asked.show = each.name;
            const law_report found = law_of(of.system, asked, orders, how);
            if (!found.complete) {
                return std::nullopt;
            }
            result.names.push_back(each.name);
            for (std::size_t i = 0; i < result.rows.size(); ++i) {
                result.rows[i].push_back(found.coefficients.rows[i][1]);
            }
        }
    } catch (const error& reason) {
        if (reason.kind() != error_kind::undecided) {
            throw;
        }
        return std::nullopt;
    }
    return result;
}

std::vector<unknown_series> lists_of(const ode::coefficient_request& of, long digits) {
    const auto found = ode::rounded_coefficients({scalar_kind::arbitrary, digits}, of);
    const std::size_t parts = found.complex ? 2 : 1;
    const std::size_t width = of.system.unknowns().size() * parts;
    std::vector<unknown_series> lists;
    for (std::size_t column = 0; column < width; ++column) {
        if (column % parts == 0) {
            lists.push_back({of.system.unknowns()[column / parts].name, {{}, found.root}});
        }
        std::vector<mpfr> values;
        for (std::size_t at = column; at < found.values.size(); at += width) {
            values.push_back(found.values[at]);
        }
        lists.back().lists.parts.push_back({series::power_series<mpfr>(std::move(values))});
    }
    return lists;
}

}  // namespace

ode::complex_constant point_in(const std::string& text) {
    try {
        return ode::parse_complex_constant(text);
    } catch (const error& problem) {
        throw error(problem.kind(), error_subject::point, text, problem.reason());
    }
}

void taylor_solution::require_point(const std::string& about) const {
    if (!about.empty()) {
        point_in(about);
    }
}

ode::coefficient_request taylor_solution::coefficients_of(const series_request& of) const {
    ode::coefficient_request request{system_, of.first, of.order};
    if (!of.about.empty()) {
        request.at = point_in(of.about);
    }
    if (!of.corners.empty() && of.about.empty()) {
        throw error(error_kind::argument, error_subject::point, "",
                    "is not given, and there are corners of a path to it");
    }
    request.corners = of.corners;
    return request;
}

void taylor_solution::require_second_series(const ode::coefficient_request& of, long digits,
                                            const std::vector<proved_decimal>& first) const {
    const auto second =
        ode::proved_coefficients(of, digits + ode::more_digits_of_second_proof, ode::proof_route::second());
    const std::size_t unknowns = system_.unknowns().size();
    for (std::size_t i = 0; i < first.size(); ++i) {
        const std::string n = std::to_string(of.first + static_cast<long>(i / unknowns));
        require_agreement(first[i], second.values[i],
                          "coefficient " + n + " of " + system_.unknowns()[i % unknowns].name);
    }
}

answer taylor_solution::series(const series_request& of, const request& how) const {
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    const ode::coefficient_request asked = coefficients_of(of);
    const long digits = how.printed_digits();
    if (how.scalar.kind == scalar_kind::proved) {
        const auto checked = checked_products(how.check);
        if (!how.check) {  // the second proof is by the recurrence, for which the first is as well
            if (auto found = series_by_laws(asked, how)) {
                return *std::move(found);
            }
        }
        const ode::shared_integrations::use kept(kept_);
        const auto found = ode::proved_coefficients(asked, digits, {}, kept.steps());
        if (how.check) {
            require_second_series(asked, digits, found.values);
        }
        return coefficient_answer(asked, found, "proved", [](const proved_decimal& value) {
            return answer_value{value.text, value.uncertainty};
        });
    }
    const bool agreed = how.scalar.kind == scalar_kind::arbitrary;
    return coefficient_answer(asked, ode::rounded_coefficients(how.scalar, asked), agreed ? "two-method" : "heuristic",
                              [&](const mpfr& value) {
                                  return answer_value{to_decimal(value, digits), ""};
                              });
}

std::optional<answer> taylor_solution::fractions(const series_request& of) const {
    const ode::coefficient_request asked = coefficients_of(of);
    return coefficient_answer(asked, ode::exact_coefficients(asked), "exact", [](const rational& value) {
        return answer_value{value.str(), ""};
    });
}

std::vector<unknown_series> taylor_solution::coefficient_lists(const series_request& of,
                                                               const scalar_spec& scalar) const {
    return lists_of(coefficients_of(of), scalar.digits + convergence::radius_guard_digits);
}

std::vector<unknown_series> unknown_lists(const ode::explicit_system& system, long order, long digits,
                                          const std::optional<ode::complex_constant>& at) {
    return lists_of({system, 0, order, at}, digits);
}

}  // namespace libration
