#include "problem_tables.hpp"

#include <cmath>
#include <complex>

#include "guarded.hpp"
#include "libration/ode/constant_value.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/problem/unknown_lists.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/text/given_number.hpp"
#include "libration/scalar/text/proved_digits.hpp"

namespace libration::c {

namespace {

constexpr long most_powers = 100'000;
constexpr long most_digits_of_places = 1000;

libration_number heuristic(const std::string& decimal, const std::string& uncertainty) {
    return {decimal, uncertainty, LIBRATION_HEURISTIC};
}

// A number that may be missing.
void add_where_known(libration_table& table, const std::string& decimal, const std::string& uncertainty) {
    if (decimal.empty()) {
        table.add(std::string());
    } else {
        table.add(heuristic(decimal, uncertainty));
    }
}

void add_estimate(libration_table& table, const convergence::radius_estimate<mpfr>& estimate, const std::string& name,
                  long digits) {
    const convergence::printed_estimate shown = printed(estimate, digits);
    table.add(estimate.method);
    table.add(name);
    add_where_known(table, shown.radius, shown.uncertainty);
    add_where_known(table, shown.position_re, shown.uncertainty);
    add_where_known(table, shown.position_im, shown.uncertainty);
    add_where_known(table, shown.exponent, shown.exponent_uncertainty);
    const bool known = estimate.kind != convergence::singularity_kind::unknown;
    table.add(known ? name_of(estimate.kind) : std::string());
    if (estimate.count > 0) {
        table.add(count_number(estimate.count));
    } else {
        table.add(std::string());
    }
    table.add(estimate.note);
}

// A part of a position to this number of digits: its uncertainty bounds the distance of the decimal from every point of
// the surrounding disc. The decimal is 0 if a proved one has no digit.
libration_number part_of_place(const mpfr& part, const magnitude& reach, long digits, int rigour) {
    const std::string decimal = to_decimal(part, digits);
    const ball within = widened(ball(part), reach);
    const ball away = within - from_rational<ball>(read_exact(decimal).coefficient);
    const proved_decimal number{decimal, upper_bound_text(away)};
    if (rigour == LIBRATION_PROVED && !has_a_digit(number)) {
        return proved_number({"0", upper_bound_text(within)});
    }
    return {number.text, number.uncertainty, rigour};
}

// A part of an exponent: an integer as such.
std::string small_text(double x) {
    const double nearest = std::round(x);
    constexpr double whole = 1e-7;
    constexpr long shown = 9;
    return to_decimal(std::abs(x - nearest) < whole * std::max(1.0, std::abs(x)) ? nearest + 0.0 : x, shown);
}

double distance_of(const std::string& text) {
    const exact within = given_number("within", text);
    if (!within.is_number() || sign_of_exact(within) <= 0) {
        throw error(error_kind::argument, "within", text, "is not a positive number");
    }
    return from_exact<double>(within);
}

ode::singularity_map search(const ode::explicit_system& system, const std::string& within, long digits) {
    ode::singularity_request request;
    request.digits = digits;
    if (!within.empty()) {
        request.within = distance_of(within);
    }
    auto map = ode::singularities_of(system, request);
    if (map.all.empty() && !map.entire && within.empty()) {
        throw error(error_kind::undecided, "problem", "",
                    "has no known singularity within " + to_decimal(map.within, 6) +
                        " of its initial point, which does not prove that there is none: search a larger disc");
    }
    return map;
}

}  // namespace

libration_table table_of_radii(const std::vector<unknown_series>& unknowns, long digits) {
    const scalar_spec scalar{scalar_kind::arbitrary, digits};
    std::vector<convergence::radius_answers> all;
    all.reserve(unknowns.size());
    for (const unknown_series& each : unknowns) {
        const precision_scope scope(digits + convergence::radius_guard_digits);
        all.push_back(answers_of(each.lists, scalar));
    }
    const std::size_t nearest = nearest_of(all);
    libration_table table{
        {"method", "unknown", "radius", "position_re", "position_im", "exponent", "kind", "count", "note"}, {}};
    add_estimate(table, all[nearest].rows.front(), unknowns[nearest].name, digits);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t row = i == nearest ? 1 : 0; row < all[i].rows.size(); ++row) {
            add_estimate(table, all[i].rows[row], unknowns[i].name, digits);
        }
    }
    return table;
}

libration_table radius_table(const ode::explicit_system& system, long last, long digits) {
    if (last < 0 || last > most_powers) {
        throw error(error_kind::argument, "power", std::to_string(last), "is not between 0 and 100000");
    }
    return table_of_radii(unknown_lists(system, last, digits + convergence::radius_guard_digits), digits);
}

found_singularities singularity_table(const ode::explicit_system& system, const std::string& within, long digits,
                                      bool proved) {
    if (given_digits(digits) > most_digits_of_places) {
        throw error(error_kind::argument, "number of digits", std::to_string(digits), "is more than 1000");
    }
    const auto map = search(system, within, proved ? digits + 3 : digits);
    const auto proofs =
        proved ? ode::prove_singularities(system, map.all, digits) : std::vector<ode::proved_singularity>();
    const auto names = ode::first_order_form(system).names;
    const precision_scope scope(digits + 30);
    const mpfr origin = ode::constant_value<mpfr>::of(system.point());
    libration_table table{{"position_re", "position_im", "modulus", "kind", "exponent_re", "exponent_im", "unknown"},
                          {}};
    for (const ode::proved_singularity& each : proofs) {
        if (!each.refusal.empty()) {
            throw error(error_kind::undecided, "problem", "", each.refusal);
        }
    }
    for (std::size_t i = 0; i < map.all.size(); ++i) {
        const auto& each = map.all[i];
        const magnitude reach = proved ? proofs[i].reach : magnitude(ball(each.uncertainty));
        for (const mpfr& part : {mpfr(origin + each.offset.re), each.offset.im, modulus_of(each.offset)}) {
            table.add(part_of_place(part, reach, digits, proved ? LIBRATION_PROVED : LIBRATION_HEURISTIC));
        }
        table.add(ode::words_of(each.kind, each.exponent.real()));
        const bool clear = each.kind != ode::singularity_kind::unclear;
        for (const double part : {each.exponent.real(), each.exponent.imag()}) {
            add_where_known(table, clear ? small_text(part) : "", "");
        }
        table.add(names[each.unknown]);
    }
    return {std::move(table), map.complete};
}

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_list_radius(const char* coefficients, long digits, libration_table** tests) {
    return made(tests, [&] {
        std::vector<exact> written;
        std::vector<mpfr> values;
        const precision_scope scope(given_digits(digits) + convergence::radius_guard_digits);
        for (const std::string& item : items_of(text_of(coefficients, "coefficients"), "coefficients")) {
            written.push_back(given_number("coefficient", item));
            values.push_back(from_exact<mpfr>(written.back()));
        }
        const convergence::listed_series list{series::power_series<mpfr>(std::move(values)), std::move(written)};
        return table_of_radii({{"", {{list}, 1}}}, digits);
    });
}
