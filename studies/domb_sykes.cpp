// Do the ratios of successive coefficients lie on a straight line to the radius of convergence? [paper sec:conclusions]
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "libration/convergence/coefficient_ratios.hpp"
#include "shared/list_answers.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace domb_sykes_study {

namespace {

// One ratio in units of 1/u^p, where u is the radius of the pendulum's series, and for an equation a length near it.
struct ratio_row {
    int power, root, n;
    std::optional<mpfr> scaled;
    mpfr unit;  // u^p
    long digits;
    std::string unknown = {};           // of an equation
    std::optional<int> limit = {};      // of the pendulum
    const sweep_energy* at = nullptr;   // of the pendulum
    const exact* point = nullptr;       // of the pendulum
    std::optional<law_ratio> law = {};  // with --prove
    known_value proved_limit = {};

    std::optional<mpfr> ratio() const { return scaled ? std::optional(mpfr(*scaled / unit)) : std::nullopt; }
};

const column_list<ratio_row>& columns() {
    using row = ratio_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"power",
         "p: the series is taken in the p-th power of the distance, as its zeros allow; of a list in powers of the "
         "q-th root p/q, a_n the coefficient of the power n/q",
         [](const row& r) {
             return r.root == 1 ? cell(r.power) : number_cell(decimal_of(rational(r.power, r.root), 12));
         }},
        {"n", "power of the later coefficient", [](const row& r) { return r.n; }},
        {"inverse_n", "1/n", [](const row& r) { return decimal_cell(mpfr(mpfr(1) / r.n), r.digits); }},
        {"ratio", "a_n/a_(n-p), in the unit of the variable to the power -p",
         [](const row& r) { return decimal_cell(r.ratio(), r.digits); }},
        {"log10_abs_ratio", "log10 of its size", [](const row& r) { return log10_cell(r.ratio()); }},
        {"scaled_ratio", "ratio times R^p with the exact radius R",
         [](const row& r) { return decimal_cell(r.scaled, r.digits); }},
        {"log10_scaled_ratio", "log10 of its size", [](const row& r) { return log10_cell(r.scaled); }},
        {"line", "the straight line of one logarithm, +-(1 - p/n); empty where the nearest singularities are a pair",
         [](const row& r) {
             const mpfr one_over_n = mpfr(1) / r.n;
             return r.limit ? decimal_cell(mpfr(*r.limit * (1 - r.power * one_over_n)), r.digits) : cell();
         }},
        gap_column<row>(),
        unknown_column<row>(),
        {"law_ratio", "a_n/a_(n-p) by the law of all coefficients alone (proved); empty below its first n",
         [](const row& r) { return r.law ? value_cell(r.law->ratio) : cell(); }},
        {"law_error", "a bound of the distance of the ratio from law_ratio (proved)",
         [](const row& r) { return r.law ? bound_cell(r.law->ratio) : cell(); }},
        {"proved_limit", "of the ratios (proved); empty if none is proved, as where a pair of singularities is nearest",
         [](const row& r) { return value_cell(r.proved_limit); }},
        {"proved_line", "proved_limit (1 - p (1 + exponent)/n) with the proved exponent",
         [](const row& r) { return r.law ? value_cell(r.law->line) : cell(); }},
        {"deviation", "a bound of |ratio - proved_line| at this n (proved)",
         [](const row& r) { return r.law ? number_cell(r.law->deviation) : cell(); }},
    });
    return all;
}

}  // namespace

namespace of_pendulum {

using namespace series;
using namespace convergence;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// One list of coefficients, a_n R^n with values that are 0 up to rounding set to 0.
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
    const mpfr radius = coverage_from<mpfr>(m, point.coefficient).radius;
    auto list = series_on_arc<mpfr>(m, point.coefficient, order).scaled;
    const auto zero = zeros_of(list, epsilon<mpfr>());
    for (int n = 0; n <= order; ++n) {
        list[n] = zero[static_cast<std::size_t>(n)] ? mpfr(0) : list[n];
    }
    auto pattern = pattern_of(list, epsilon<mpfr>());
    return {at, point, std::move(m), radius, std::move(list), pattern};
}

// The powers p that divide the stride of the list: 1, and 2 and 4 if symmetry permits them.
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

const column_list<ratio_row>& ratio_columns() {
    static const auto all = columns_named(
        "energy,point,power,n,inverse_n,ratio,scaled_ratio,log10_scaled_ratio,line,gap,energy_typed,gap_typed",
        with_meanings(
            columns(),
            {{"power", "p: the series is taken in t^p"},
             {"n", "power of t of the later coefficient"},
             {"ratio",
              "a_n/a_(n-p), in (dimensionless time)^-p; empty where a_(n-p) is 0, and the ratio not defined"}}));
    return all;
}

std::vector<ratio_row> ratio_rows(const plot& drawn, long digits) {
    const plotted& p = drawn.of;
    const mpfr unit = pow(p.radius, drawn.power);
    std::vector<ratio_row> all;
    all.reserve(static_cast<std::size_t>(drawn.series.last()));
    for (int k = 1; k <= drawn.series.last(); ++k) {
        const int n = drawn.series.power(k);
        const auto found = drawn.defined.find(n);
        const auto scaled = found != drawn.defined.end() ? std::optional(found->second) : std::nullopt;
        all.push_back({drawn.power, 1, n, scaled, unit, digits, "", drawn.limit, &p.at, &p.point});
    }
    return all;
}

// The ratios of the second half of n by size; empty if one of them is undefined.
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

// Summary of the plot of one list.
struct list_row {
    const sweep_energy& at;
    const exact& point;
    long digits;
    int power, first, ratios, undefined, zero;
    std::vector<mpfr> late;  // by size
    std::optional<int> limit;
    mpfr radius;
    std::string pattern;
};

const column_list<list_row>& list_columns() {
    using row = list_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"power", "p: the series is taken in t^p", [](const row& r) { return r.power; }},
        {"first", "n = first mod p are the powers of t taken", [](const row& r) { return r.first; }},
        {"ratios", "number of ratios up to the largest order", [](const row& r) { return r.ratios; }},
        {"undefined", "of these not defined: divided by a coefficient 0", [](const row& r) { return r.undefined; }},
        {"zero", "of these 0", [](const row& r) { return r.zero; }},
        {"least", "smallest of a_n/a_(n-p) R^p over the last half of n; empty where one is not defined",
         [](const row& r) { return r.late.empty() ? cell() : decimal_cell(r.late.front(), r.digits); }},
        {"largest", "largest of them",
         [](const row& r) { return r.late.empty() ? cell() : decimal_cell(r.late.back(), r.digits); }},
        {"limit", "of a_n/a_(n-p) R^p by theory: 1 | -1; empty where the ratios scatter for ever",
         [](const row& r) { return r.limit ? cell(*r.limit) : cell(); }},
        {"radius", "exact R, dimensionless time", [](const row& r) { return decimal_cell(r.radius, r.digits); }},
        {"pattern", "which coefficients are 0", [](const row& r) { return r.pattern; }},
    });
    return all;
}

list_row row_of(const plot& drawn, long digits) {
    const plotted& p = drawn.of;
    const auto zero =
        std::count_if(drawn.defined.begin(), drawn.defined.end(), [](const auto& ratio) { return ratio.second == 0; });
    const int last = drawn.series.last();
    return {p.at,
            p.point,
            digits,
            drawn.power,
            drawn.series.first(),
            last,
            last - static_cast<int>(drawn.defined.size()),
            static_cast<int>(zero),
            late_ratios(drawn),
            drawn.limit,
            p.radius,
            p.pattern.text()};
}

// The tables of one list: its ratios, their summary, and the results of the tests.
std::vector<table> plots_at(const sweep_energy& at, const exact& point, const std::vector<int>& orders,
                            const scalar_spec& scalar) {
    table answers = answers_about(at, point, orders, scalar, is_any_test);
    const precision_scope scope(scalar.digits + guard_digits);
    const plotted p = plotted_list(at, point, orders.back());
    std::vector<table> points;
    std::vector<list_row> lists;
    for (const int power : powers_of(p)) {
        const plot drawn = plot_in(p, power);
        points.push_back(make_table(ratio_columns(), ratio_rows(drawn, scalar.digits)));
        lists.push_back(row_of(drawn, scalar.digits));
    }
    return {stacked(points), make_table(list_columns(), lists), std::move(answers)};
}

study_plan plan(const study_request& request) {
    const std::vector<int> orders = orders_from(request, least_order_of_lists, "leaves no ratios to draw");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_point({head_of("", scalar, ratio_columns()), head_of("lists", scalar, list_columns()),
                          head_of("intercepts", scalar, judged_answer_columns())},
                         sweep_of(request), [orders, scalar](const sweep_energy& at, const exact& point) {
                             return plots_at(at, point, orders, scalar);
                         });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

const column_list<ratio_row>& ratio_columns() {
    static const auto all = columns_named("power,n,inverse_n,ratio,log10_abs_ratio,unknown", columns());
    return all;
}

const column_list<ratio_row>& ratio_columns_with_law() {
    static const auto all =
        joined(ratio_columns(), columns_named("law_ratio,law_error,proved_limit,proved_line,deviation", columns()));
    return all;
}

// The ratios of one list in the power given by its pattern of zeros.
std::vector<ratio_row> ratios_in(const list_of_unknown& of) {
    const auto unit = convergence::unit_of(of.list);
    const auto scaled = convergence::in_unit_of<mpfr>(of.list, unit);
    const auto pattern = convergence::pattern_of(scaled, epsilon<mpfr>());
    std::vector<ratio_row> rows;
    if (pattern.last < 0 || pattern.polynomial) {
        return rows;
    }
    const int power = std::max(1, pattern.stride);
    const convergence::strided_series<mpfr> part(scaled, pattern.first % power, power);
    const mpfr length = pow(mpfr(unit.length), power);
    const known_value limit = of.law != nullptr ? of.law->limit(of.digits) : known_value{};
    for (const auto& each : convergence::ratios_of(part)) {
        ratio_row& row =
            rows.emplace_back(ratio_row{power, of.root, each.n, each.value, length, of.digits, of.unknown});
        if (of.law != nullptr && power == of.law->stride()) {
            row.proved_limit = limit;
            if (each.n >= of.law->first() + power) {
                row.law = of.law->ratio(each.n, of.digits, proved_law::source::law);
            }
        }
    }
    return rows;
}

study_plan plan(const study_request& request) {
    return plan_of_lists(request, "leaves no ratios to draw",
                         proves_law(request) ? ratio_columns_with_law() : ratio_columns(), ratios_in, "intercepts",
                         is_any_test);
}

}  // namespace
}  // namespace of_equation
}  // namespace domb_sykes_study

const study& domb_sykes() {
    using namespace domb_sykes_study;
    static const study result{
        .name = "domb_sykes",
        .title = "The Domb-Sykes plot",
        .question = "Do the ratios of successive coefficients run straight to the radius of convergence?",
        .reading =
            "Ratios of coefficients over 1/n, times the exact power of R, so that the answer at 1/n = 0 is 1 or -1 "
            "for every energy; the broad grey lines are what one logarithmic singularity makes, +-(1 - p/n). In t, "
            "as textbooks draw it, symmetry leaves nothing: every second ratio is 0 and the others divide by 0. In "
            "t^2 the plot about the bottom runs straight to -1, for the two singularities +-i K~' are one there. "
            "About the top it scatters for ever and has no intercept at all, because two pairs are nearest and their "
            "squares are still a pair; only at E = 1, in t^4, do all four fall together (marks on the edge lie "
            "beyond it). The second figure shows what radius tests make of the same lists: where the plot is "
            "straight, the last ratio is right to two digits and the extrapolated intercept to as many as the "
            "coefficients have; where it scatters, both refuse, a test for pairs gains digits slowly, and fitted "
            "recurrences, which the verdict follows, have them all from N = 80.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1,1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,40,60,80,120,160,200",
                        "N, last powers of the lists under test; the largest is drawn"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
        .quick = {{"--energies", "1,1.71", ""}, {"--orders", "12", ""}, {"--points", "0,1", ""}},
        .seconds = 2,
        .excluded = no_answer_at_limits("theta is constant and has no ratios", "T* is infinite"),
        .plan = of_pendulum::plan,
        .version = 4,
        .any_equation = equation_form{
            .plan = of_equation::plan,
            .reading =
                "Ratios of coefficients over 1/n, of the series in the power that its zeros leave. A single nearest "
                "singularity makes a straight line whose intercept is its place to that power, and whose slope its "
                "exponent; the grey lines are plus and minus the verdict of all tests. A pair of singularities "
                "scatters the ratios for ever. The second table holds what each test answers. With --prove the law of "
                "all "
                "coefficients adds what it predicts, from its terms alone, the line to which the ratios are proved to "
                "tend, and "
                "a proved bound of the distance from that line at each n.",
            .parameters = {{"--orders", "20,50,100,200",
                            "N, last powers of the lists under test; the largest is drawn"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test"},
                           law_parameter()},
            .example = {"blasius", {}},
            .quick = {{"--orders", "20"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
