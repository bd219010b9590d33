// Do the ratios of successive coefficients run straight to the radius of convergence? [paper sec:conclusions]
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "libration/convergence/estimate/coefficient_ratios.hpp"
#include "radius_cells.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace domb_sykes_study {
namespace {

using rows = std::vector<std::vector<std::string>>;

constexpr long guard_digits = 15;
constexpr int least_order = 4;

const std::vector<column>& columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
        {"power", "p: the series is taken in t^p"},
        {"n", "power of t of the later coefficient"},
        {"inverse_n", "1/n"},
        {"ratio", "a_n/a_(n-p), in (dimensionless time)^-p; empty where a_(n-p) is 0, and the ratio not defined"},
        {"scaled_ratio", "ratio times R^p with the exact radius R"},
        {"log10_scaled_ratio", "log10 of its size"},
        {"line", "the straight line of one logarithm, +-(1 - p/n); empty where the nearest singularities are a pair"},
        {"gap", "2 - E"},
    };
    return all;
}

const std::vector<column>& list_columns() {
    static const std::vector<column> all{
        {"energy", "E, in units of m g l"},
        {"point", "expansion point as a fraction of T*: 0 the top, 1 the bottom"},
        {"power", "p: the series is taken in t^p"},
        {"first", "n = first mod p are the powers of t taken"},
        {"ratios", "number of ratios up to the largest order"},
        {"undefined", "of these not defined: divided by a coefficient 0"},
        {"zero", "of these 0"},
        {"least", "smallest of a_n/a_(n-p) R^p over the last half of n; empty where one is not defined"},
        {"largest", "largest of them"},
        {"limit", "of a_n/a_(n-p) R^p by theory: 1 | -1; empty where the ratios scatter for ever"},
        {"radius", "exact R, dimensionless time"},
        {"pattern", "which coefficients are 0"},
    };
    return all;
}

// One list of coefficients, a_n R^n with what is 0 up to rounding set to 0.
struct plotted {
    const sweep_energy& at;
    const exact& point;
    motion m;
    mpfr radius;
    power_series<mpfr> list;
    coefficient_pattern pattern;
};

plotted plotted_list(const sweep_energy& at, const exact& point, int order) {
    motion m = motion::of_energy(at.value);
    const mpfr radius = cover_from<mpfr>(m, point.coefficient).radius;
    auto list = series_on_descent<mpfr>(m, point.coefficient, order).scaled;
    const auto zero = zeros_of(list, epsilon<mpfr>());
    for (int n = 0; n <= order; ++n) {
        list[n] = zero[static_cast<std::size_t>(n)] ? mpfr(0) : list[n];
    }
    auto pattern = pattern_of(list, epsilon<mpfr>());
    return {at, point, std::move(m), radius, std::move(list), pattern};
}

// The powers p that divide the stride of the list: 1, and 2 and 4 where symmetry leaves them.
std::vector<int> powers_of(const plotted& p) {
    std::vector<int> powers;
    for (int power = 1; power <= p.pattern.stride; power *= 2) {
        powers.push_back(power);
    }
    return powers;
}

// The series of one list in t^power, and the ratios that are defined, times R^power, by n.
struct plot {
    const plotted& of;
    int power;
    strided_series<mpfr> series;
    std::map<int, mpfr> defined;
    std::optional<int> limit;
};

plot plot_in(const plotted& p, int power) {
    plot result{p,
                power,
                strided_series<mpfr>(p.list, p.pattern.first % power, power),
                {},
                limit_of_ratios(p.m, p.point.coefficient, power)};
    for (const auto& ratio : ratios_of(result.series)) {
        result.defined[ratio.n] = ratio.value;
    }
    return result;
}

rows ratio_rows(const plot& drawn, long digits) {
    const plotted& p = drawn.of;
    const mpfr unit = pow(p.radius, drawn.power);
    rows all;
    all.reserve(static_cast<std::size_t>(drawn.series.last()));
    for (int k = 1; k <= drawn.series.last(); ++k) {
        const int n = drawn.series.power(k);
        const auto found = drawn.defined.find(n);
        std::vector<std::string> ratio(3);
        if (found != drawn.defined.end()) {
            ratio = {to_decimal(mpfr(found->second / unit), digits), to_decimal(found->second, digits),
                     log10_text(found->second)};
        }
        const mpfr one_over_n = mpfr(1) / n;
        const std::string line =
            drawn.limit ? to_decimal(mpfr(*drawn.limit * (1 - drawn.power * one_over_n)), digits) : "";
        all.push_back(joined(joined({p.at.energy, p.point.text, std::to_string(drawn.power), std::to_string(n),
                                     to_decimal(one_over_n, digits)},
                                    ratio),
                             {line, p.at.gap}));
    }
    return all;
}

// The ratios of the second half of n by size; nothing where one of them is not defined.
std::vector<mpfr> late_ratios(const plot& drawn) {
    const int last = drawn.series.last();
    std::vector<mpfr> late;
    late.reserve(drawn.defined.size());
    for (int k = last / 2 + 1; k <= last; ++k) {
        const auto found = drawn.defined.find(drawn.series.power(k));
        if (found == drawn.defined.end()) {
            return {};
        }
        late.push_back(found->second);
    }
    std::sort(late.begin(), late.end());
    return late;
}

std::vector<std::string> list_row(const plot& drawn, long digits) {
    const plotted& p = drawn.of;
    const auto zero =
        std::count_if(drawn.defined.begin(), drawn.defined.end(), [](const auto& ratio) { return ratio.second == 0; });
    const auto late = late_ratios(drawn);
    return {p.at.energy,
            p.point.text,
            std::to_string(drawn.power),
            std::to_string(drawn.series.first()),
            std::to_string(drawn.series.last()),
            std::to_string(drawn.series.last() - static_cast<int>(drawn.defined.size())),
            std::to_string(zero),
            late.empty() ? "" : to_decimal(late.front(), digits),
            late.empty() ? "" : to_decimal(late.back(), digits),
            drawn.limit ? std::to_string(*drawn.limit) : "",
            to_decimal(p.radius, digits),
            p.pattern.text()};
}

struct plots {
    rows points;
    rows lists;
    rows intercepts;
};

plots plots_at(const sweep_energy& at, const exact& point, const std::vector<int>& orders, const scalar_spec& scalar) {
    plots all;
    all.intercepts = answers_about(at, point, orders, scalar, [](const std::string&) { return true; });
    const precision_scope scope(scalar.digits + guard_digits);
    const plotted p = plotted_list(at, point, orders.back());
    for (const int power : powers_of(p)) {
        const plot drawn = plot_in(p, power);
        rows points = ratio_rows(drawn, scalar.digits);
        std::move(points.begin(), points.end(), std::back_inserter(all.points));
        all.lists.push_back(list_row(drawn, scalar.digits));
    }
    return all;
}

std::vector<study_table> run(const study_request& request) {
    refuse_limits(request.energies, "theta is constant and has no ratios", "T* is infinite");
    std::vector<int> orders = request.orders;
    std::sort(orders.begin(), orders.end());
    if (orders.front() < least_order) {
        throw input_error("--orders", std::to_string(orders.front()), "leaves no ratios to draw",
                          "write orders from " + std::to_string(least_order) + " on");
    }
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    const std::size_t points = request.points.size();
    progress shown("domb_sykes, lists", request.energies.size() * points, request.shown);
    const auto found = parallel_map(request.energies.size() * points, request.jobs, shown, [&](std::size_t i) {
        return plots_at(request.energies[i / points], request.points[i % points], orders, scalar);
    });
    study_table ratios{"", scalar, {columns(), {}}};
    study_table lists{"lists", scalar, {list_columns(), {}}};
    study_table intercepts{"intercepts", scalar, {answer_columns(), {}}};
    for (const plots& each : found) {
        ratios.data.rows.insert(ratios.data.rows.end(), each.points.begin(), each.points.end());
        lists.data.rows.insert(lists.data.rows.end(), each.lists.begin(), each.lists.end());
        intercepts.data.rows.insert(intercepts.data.rows.end(), each.intercepts.begin(), each.intercepts.end());
    }
    return {std::move(ratios), std::move(lists), std::move(intercepts)};
}

}  // namespace
}  // namespace domb_sykes_study

const study& domb_sykes() {
    using namespace domb_sykes_study;
    static const study result{
        .name = "domb_sykes",
        .title = "The Domb-Sykes plot",
        .label = "",
        .question = "Do the ratios of successive coefficients run straight to the radius of convergence?",
        .reading =
            "Ratios of coefficients over 1/n, times the exact power of R, so that the answer at 1/n = 0 is 1 or -1 "
            "for every energy; the broad grey lines are what one logarithmic singularity makes, +-(1 - p/n). In t, "
            "as textbooks draw it (left), symmetry leaves nothing: every second ratio is 0 and the others divide by "
            "0. In t^2 (right) the plot about the bottom runs straight to -1, for the two singularities +-i K~' are "
            "one there. About the top it scatters for ever and has no intercept at all, because two pairs are "
            "nearest and their squares are still a pair; only at E = 1, in t^4, do all four fall together (marks on "
            "the edge lie beyond it). The second figure shows what radius tests make of the same lists: where the "
            "plot is straight, the last ratio is right to two digits and the extrapolated intercept to as many as "
            "the coefficients have; where it scatters, both refuse, a test for pairs gains digits slowly, and fitted "
            "recurrences, which the verdict follows, have them all from N = 80.",
        .parameters = {{"--energies", "0.5,1,1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,40,60,80,120,160,200",
                        "N, last powers of the lists judged; the largest is drawn"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .quick = {{"--energies", "1,1.71", ""}, {"--orders", "12", ""}, {"--points", "0,1", ""}},
        .seconds = 2,
        .run = run};
    return result;
}

}  // namespace libration::studies
