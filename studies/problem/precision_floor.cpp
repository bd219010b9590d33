// What can each arithmetic reach before its rounding is larger than the error of the series? [paper fig:error]
#include <algorithm>

#include "libration/pendulum/error/error_norm.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace precision_floor_study {
namespace {

constexpr long printed_digits = 12;
constexpr long guard_digits = 15;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N, last power of the series; last index of the resummed series"},
        {"method", "series | resummed"},
        {"scalar", "arithmetic of coefficients and evaluation; mpfr without guard digits"},
        {"norm", "max of |approximation - theta| over 1001 points of [0, T*] and the place of exact_norm, radians"},
        {"exact_norm", "the same in exact arithmetic, as a true maximum, radians"},
        {"norm_in_epsilon", "norm over the unit in the last place of 1"},
        {"epsilon", "unit in the last place of 1"},
        {"floor", "yes where rounding is more than half of norm"},
        {"log10_norm", "log10 of norm"},
        {"log10_exact_norm", "log10 of exact_norm"},
        {"log10_epsilon", "log10 of epsilon"},
        {"gap", "2 - E"},
    };
    return all;
}

std::vector<scalar_spec> scalars_of(const study_request& request) {
    if (request.scalar) {
        return {*request.scalar};
    }
    return {read_scalar("double"), read_scalar("long-double"), read_scalar("quad"), read_scalar("mpfr:40")};
}

// The unit in the last place of 1, as a number that outlives the scope of the scalar.
mpfr epsilon_of(const scalar_spec& scalar) {
    return with_scalar(scalar, 0, []<class T>() { return widen(epsilon<T>()); });
}

mpfr norm_in(const scalar_spec& scalar, descent_errors& errors, descent_method method, int order, const motion& m,
             const mpfr& place) {
    switch (scalar.kind) {
        case scalar_kind::binary64: return errors.norm_in<double>(method, order, m, place).norm;
        case scalar_kind::extended: return errors.norm_in<long double>(method, order, m, place).norm;
        case scalar_kind::binary128: return errors.norm_in<quad>(method, order, m, place).norm;
        default: return errors.norm_in_digits(scalar.digits, method, order, m, place).norm;
    }
}

std::vector<std::vector<std::string>> rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                              const std::vector<scalar_spec>& scalars) {
    const motion m = motion::of_energy(at.value);
    long digits = 0;
    for (const scalar_spec& scalar : scalars) {
        digits = std::max(digits, scalar.digits);
    }
    const int highest = orders.empty() ? 0 : *std::max_element(orders.begin(), orders.end());
    // Both floors and exact norms are to have their printed digits.
    const precision_scope scope(std::max(digits, digits_below(m, highest)) + printed_digits + guard_digits);
    descent_errors errors(m);
    std::vector<std::vector<std::string>> rows;
    rows.reserve(orders.size() * scalars.size() * 2);
    for (const int order : orders) {
        for (const auto method : {descent_method::series, descent_method::resummed}) {
            const norm_at<mpfr> exact = errors.norm(method, order);
            for (const scalar_spec& scalar : scalars) {
                const mpfr norm = norm_in(scalar, errors, method, order, m, exact.place);
                const mpfr unit = epsilon_of(scalar);
                rows.push_back({at.energy, std::to_string(order),
                                method == descent_method::series ? "series" : "resummed", scalar.name(),
                                to_decimal(norm, printed_digits), to_decimal(exact.norm, printed_digits),
                                to_decimal(mpfr(norm / unit), 6), to_decimal(unit, printed_digits),
                                exact.norm * 2 < norm ? "yes" : "no", log10_text(norm), log10_text(exact.norm),
                                log10_text(unit), at.gap});
            }
        }
    }
    return rows;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "the series is the constant 0",
                  "the series is not defined: the period is infinite");
    const auto scalars = scalars_of(request);
    progress shown("precision_floor, energies", request.energies.size(), request.shown);
    const auto rows = parallel_map(request.energies.size(), request.jobs, shown, [&](std::size_t i) {
        return rows_at(request.energies[i], request.orders, scalars);
    });
    study_table result{"", scalars.back(), {columns(), {}}};
    for (const auto& at_energy : rows) {
        result.data.rows.insert(result.data.rows.end(), at_energy.begin(), at_energy.end());
    }
    return {std::move(result)};
}

}  // namespace
}  // namespace precision_floor_study

const study& precision_floor() {
    using namespace precision_floor_study;
    static const study result{
        .name = "precision_floor",
        .title = "Where rounding takes over",
        .label = "",
        .question = "How small can the error of the series get in each arithmetic before rounding wins?",
        .reading =
            "The error norm against the order N, one panel an energy: dashed the series, solid its resummation, in "
            "double, long double, quad and mpfr of 40 digits without guard digits; thin dotted the norm in exact "
            "arithmetic. The short lines at the right mark the epsilon of each arithmetic. Each curve follows the "
            "exact norm down to a few epsilon, stays there, and does not rise again: no order is too high. The farther "
            "the energy is from 2, the earlier the floor is reached; the resummation reaches it with fewer terms.",
        .parameters = {{"--energies", "0.5,1.71,1.9998,2.02,4", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--orders", "2,5,10,15,20,30,40,50,60,80,100,120,150,200,250,300",
                        "N, last power of the series; last index of the resummed series"},
                       {"--scalar", "double, long-double, quad and mpfr:40", "arithmetic"}},
        .quick = {{"--energies", "1.71", ""}, {"--orders", "5,40", ""}},
        .seconds = 2,
        .run = run};
    return result;
}

}  // namespace libration::studies
