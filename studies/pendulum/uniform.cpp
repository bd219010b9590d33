// How many digits does the uniform resummation reach with 8, 16 and 32 coefficients, at energies from 1e-20 to 1e4?
#include "libration/pendulum/arc/uniform_rate.hpp"
#include "libration/pendulum/arc/uniform_resummation.hpp"
#include "libration/pendulum/error/error_norm.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace uniform_study {
namespace {

constexpr long printed_digits = 12;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"gap", "2 - E"},
        {"count", "coefficients of powers of t that are not 0"},
        {"order", "N, last power"},
        {"norm", "max of |approximation - theta| over [0, T*], radians"},
        {"time_of_maximum", "dimensionless time since the top"},
        {"scalar", "arithmetic of the approximation"},
        {"rigour", "two-method: confirmed by the sum over separatrix solutions | heuristic"},
        {"bound", "theorem U, radians: what exact arithmetic does not exceed"},
        {"rate", "T*/|3 T* + i K~'|, the exact factor of the error a power in the long run"},
        {"log10_norm", "log10 of norm"},
        {"log10_bound", "log10 of bound"},
        {"log10_energy", "log10 of E"},
        {"log10_gap", "log10 of |2 - E|"},
    };
    return all;
}

struct cell {
    const sweep_energy& at;
    int count;
    int order;
    mpfr bound;
    mpfr rate;
    mpfr effective_period;
};

std::vector<std::string> row_of(const cell& c, const norm_at<mpfr>& found, const std::string& scalar, bool two_method) {
    return {c.at.energy,
            c.at.gap,
            std::to_string(c.count),
            std::to_string(c.order),
            to_decimal(found.norm, printed_digits),
            to_decimal(mpfr(found.place * c.effective_period), printed_digits),
            scalar,
            two_method ? "two-method" : "heuristic",
            to_decimal(c.bound, printed_digits),
            to_decimal(c.rate, printed_digits),
            log10_text(found.norm),
            log10_text(c.bound),
            log10_text(from_rational<mpfr>(c.at.value)),
            log10_text(abs(from_rational<mpfr>(rational(2 - c.at.value))))};
}

// The rows of one energy, in mpfr and in double.
struct energy_rows {
    std::vector<std::vector<std::string>> exact;
    std::vector<std::vector<std::string>> in_double;
};

energy_rows rows_at(const sweep_energy& at, const std::vector<int>& counts) {
    const motion m = motion::of_energy(at.value);
    const int parity = parity_from_top(m.regime());
    energy_rows result;
    for (const int count : counts) {
        const int order = 2 * count - parity;
        const precision_scope scope(uniform_digits_below(m, order) + 2 * printed_digits);
        descent_errors errors(m);
        const auto f = uniform_from_top<mpfr>(m, order);
        const norm_at<mpfr> found = errors.norm_of(f, order);
        const mpfr other = errors.second_opinion_of(f, found.place);
        const bool agreed = abs(found.norm - other) <= found.norm * pow(mpfr(10), -static_cast<int>(printed_digits));
        const cell here{at,
                        count,
                        order,
                        f.bounds().norm(order),
                        mpfr(uniform_rate(errors.bounds(), 1)),
                        errors.bounds().effective_period};
        result.exact.push_back(row_of(here, found, "mpfr", agreed));
        const auto rounded = uniform_from_top<double>(m, order);
        const auto value = [&](double x) { return widen(rounded.value(x)); };
        result.in_double.push_back(
            row_of(here, errors.rounded_norm(value, narrow<double>(found.place)), "double", false));
    }
    return result;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "the columns of singularities are infinitely many", "the period is infinite");
    for (const int count : request.orders) {
        if (count < 1) {
            throw input_error("--orders", std::to_string(count), "is no number of coefficients", "write 1 or more");
        }
    }
    progress shown("uniform, energies", request.energies.size(), request.shown);
    const auto rows = parallel_map(request.energies.size(), request.jobs, shown,
                                   [&](std::size_t i) { return rows_at(request.energies[i], request.orders); });
    study_table exact{"", read_scalar("mpfr:" + std::to_string(printed_digits)), {columns(), {}}};
    study_table in_double{"double", read_scalar("double"), {columns(), {}}};
    for (const energy_rows& at : rows) {
        exact.data.rows.insert(exact.data.rows.end(), at.exact.begin(), at.exact.end());
        in_double.data.rows.insert(in_double.data.rows.end(), at.in_double.begin(), at.in_double.end());
    }
    return {std::move(exact), std::move(in_double)};
}

}  // namespace
}  // namespace uniform_study

const study& uniform() {
    using namespace uniform_study;
    static const study result{
        .name = "uniform",
        .title = "One resummation for every energy",
        .label = "",
        .question =
            "How many digits does the uniform resummation reach with 8, 16 and 32 coefficients, from E = 1e-20 "
            "over |2-E| = 1e-100 to E = 1e4?",
        .reading =
            "The digits -log10 of the error norm on [0, T*], of theta minus its two nearest columns of singularities "
            "in closed form and a series for the rest, by the number of coefficients that are not 0. Solid in exact "
            "arithmetic, dotted what theorem U proves at every energy, circles the same with 16 coefficients in "
            "double, whose rounding is all that is left of its error. The digits are absolute: at tiny energies theta "
            "itself is sqrt(2E), so that the digits of theta are fewer by as many as that has zeros, and in double the "
            "rounding of the columns, which are not small, is left. Towards E = 2 the two columns become the whole "
            "motion, and the error falls with the gap itself.",
        .parameters = {{"--energies", "1e-20:1e-1:20log,0.5,1,1.5,10:1e4:7log", "energies E, in m g l"},
                       {"--gaps", "1e-1:1e-100:34log,-1e-1:-1e-100:34log,-0.5,-1,-2", "energies as 2 - E"},
                       {"--orders", "8,16,32", "numbers of coefficients that are not 0"}},
        .quick = {{"--energies", "1.71,1e-20", ""}, {"--gaps", "1e-12,-1e-30", ""}, {"--orders", "4,16", ""}},
        .seconds = 10,
        .run = run};
    return result;
}

}  // namespace libration::studies
