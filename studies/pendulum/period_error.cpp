// How large is the error of T* from the two partial sums of K? [paper fig:perioderror]
#include <algorithm>

#include "libration/pendulum/energy/period_error.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace period_error_study {
namespace {

constexpr long guard_digits = 15;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"order", "N: the sum ends with k^(2N)"},
        {"method", "series (Kold) | resummed (Knew)"},
        {"error", "|T* by the sum - T*|, dimensionless time; both sums are below T*"},
        {"tstar", "T* by the sum, dimensionless time"},
        {"gap", "2 - E"},
        {"bound", "proved bound of the error, dimensionless time"},
        {"bound_over_error", "bound / error"},
        {"scalar", "arithmetic of the sum"},
        {"log10_error", "log10 of error"},
        {"log10_bound", "log10 of bound"},
        {"log10_gap", "log10 of |2 - E|"},
    };
    return all;
}

// T* by the sum in the scalar, as a wide value.
mpfr sum_in(const scalar_spec& scalar, long guard, const motion& m, const period_rule& rule) {
    return with_scalar(scalar, guard, [&]<class T>() { return widen(effective_period_by(rule, orbit_of<T>(m))); });
}

std::vector<std::vector<std::string>> rows_at(const sweep_energy& at, const std::vector<int>& orders,
                                              const scalar_spec& scalar) {
    const motion m = motion::of_energy(at.value);
    const int highest = orders.empty() ? 0 : *std::max_element(orders.begin(), orders.end());
    const long guard = period_digits_below(m, highest) + guard_digits;
    const precision_scope scope(scalar.digits + guard);
    const orbit<mpfr> o = orbit_of<mpfr>(m);
    const mpfr truth = effective_period(o);
    std::vector<std::vector<std::string>> rows;
    rows.reserve(orders.size() * 2);
    for (const int order : orders) {
        for (const auto method : {period_method::series, period_method::resummed}) {
            const mpfr value = sum_in(scalar, guard, m, {method, order});
            const mpfr error = abs(value - truth);
            const mpfr bound = effective_period_bound({method, order}, o);
            rows.push_back({at.energy, std::to_string(order), method == period_method::series ? "series" : "resummed",
                            to_decimal(error, scalar.digits), to_decimal(value, scalar.digits), at.gap,
                            to_decimal(bound, 12), error == 0 ? "inf" : to_decimal(mpfr(bound / error), 6),
                            scalar.name(), log10_text(error), log10_text(bound),
                            log10_text(abs(from_rational<mpfr>(rational(2 - at.value))))});
        }
    }
    return rows;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "k = 0 and both sums are exact", "the period is infinite");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:40"));
    progress shown("period_error, energies", request.energies.size(), request.shown);
    const auto rows = parallel_map(request.energies.size(), request.jobs, shown,
                                   [&](std::size_t i) { return rows_at(request.energies[i], request.orders, scalar); });
    study_table result{"", scalar, {columns(), {}}};
    for (const auto& at_energy : rows) {
        result.data.rows.insert(result.data.rows.end(), at_energy.begin(), at_energy.end());
    }
    return {std::move(result)};
}

}  // namespace
}  // namespace period_error_study

const study& period_error() {
    using namespace period_error_study;
    static const study result{
        .name = "period_error",
        .title = "Error of the period",
        .label = "fig:perioderror",
        .question = "How large is the error of T* by the series of K and by its resummation, at each energy and order?",
        .reading =
            "Dashed: T* from the series (Kold) cut after k^(2N); solid: from its resummation (Knew) with as many "
            "terms; crosses: the proved bounds of both, which are never more than 1.4 times the error and so lie on "
            "the curves. Left over the energy, right towards the separatrix, where rotation (circles) falls on "
            "libration. Both sums are too small at every order, and both lose their rate as E goes to 2: the error of "
            "the series then grows like the period itself, and that of the resummation settles at 1/(8N + 7), the "
            "algebraic tail of its brackets, which more terms reduce only in proportion.",
        .parameters = {{"--energies", "1e-3,1e-2,0.05:1.95:39,1.99,2.01,2.02,2.05:2.95:19,3:8:26",
                        "energies E, in m g l"},
                       {"--gaps", "1e-2:1e-10:17log,-1e-2:-1e-10:17log", "energies as 2 - E"},
                       {"--orders", "1,5,10,20,50,100", "N: the sums end with k^(2N)"},
                       {"--scalar", "mpfr:40", "arithmetic of the sums"}},
        .quick = {{"--energies", "1.71,2.02", ""}, {"--orders", "1,10", ""}},
        .seconds = 0.4,
        .run = run};
    return result;
}

}  // namespace libration::studies
