// How slowly does the root test find the radius of convergence? [paper sec:conclusions]
#include <optional>
#include <utility>

#include "shared/list_answers.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace root_test_study {

using namespace convergence;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;

// The roots of one coefficient, in a unit that is the radius of the pendulum's series, and 1 for an equation.
struct root_row {
    int n;
    mpfr root, corrected, unit;
    long digits;
    std::string unknown;
    const sweep_energy* at = nullptr;  // of the pendulum
    const exact* point = nullptr;      // of the pendulum
    std::optional<law_root> law = {};  // with --prove
    known_value proved_radius = {};
};

const column_list<root_row>& columns() {
    using row = root_row;
    const auto length = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(mpfr(r.*which * r.unit), r.digits); };
    };
    const auto error = [](mpfr row::*which) {
        return [which](const row& r) { return decimal_cell(mpfr(r.*which - 1), digits_of_errors); };
    };
    const auto log10_error = [](mpfr row::*which) {
        return [which](const row& r) { return log10_cell(mpfr(r.*which - 1)); };
    };
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"n", "power; those with a_n = 0 are left out", [](const row& r) { return r.n; }},
        {"inverse_n", "1/n", [](const row& r) { return decimal_cell(mpfr(mpfr(1) / r.n), r.digits); }},
        {"root", "|a_n|^(-1/n), in the unit of the variable", length(&row::root)},
        {"corrected", "|n a_n|^(-1/n), in the unit of the variable", length(&row::corrected)},
        {"exact", "radius of convergence R from the lattice of singularities, dimensionless time",
         [](const row& r) { return decimal_cell(r.unit, r.digits); }},
        {"root_error", "root/exact - 1", error(&row::root)},
        {"corrected_error", "corrected/exact - 1", error(&row::corrected)},
        {"log10_root_error", "log10 of the size of root_error", log10_error(&row::root)},
        {"log10_corrected_error", "log10 of the size of corrected_error", log10_error(&row::corrected)},
        {"amplitude", "A: twice the number of singularities on the circle; |a_n| is at most about A/n R^-n",
         [](const row& r) { return 2 * nearest_count_on_arc(r.point->coefficient); }},
        gap_column<row>(),
        unknown_column<row>(),
        {"law_root", "|a_n|^(-1/n) by the law of all coefficients alone (proved); empty below its first n",
         [](const row& r) { return r.law ? value_cell(r.law->root) : cell(); }},
        {"law_error", "a bound of the distance of the root from law_root (proved)",
         [](const row& r) { return r.law ? bound_cell(r.law->root) : cell(); }},
        {"proved_radius", "radius of convergence by the law (proved); empty if it is not proved",
         [](const row& r) { return value_cell(r.proved_radius); }},
        {"deviation", "a bound of |root - radius| at this n (proved)",
         [](const row& r) { return r.law ? number_cell(r.law->deviation) : cell(); }},
    });
    return all;
}

const column_list<root_row>& columns_of_pendulum() {
    static const auto all = columns_named(
        "energy,point,n,root,corrected,exact,root_error,corrected_error,log10_root_error,log10_corrected_error,"
        "amplitude,gap,energy_typed,gap_typed",
        with_meanings(columns(), {{"n", "power of t; those with a_n = 0 are left out"},
                                  {"root", "|a_n|^(-1/n), dimensionless time"},
                                  {"corrected", "|n a_n|^(-1/n), dimensionless time"}}));
    return all;
}

const column_list<root_row>& columns_of_equation() {
    static const auto all = columns_named("n,inverse_n,root,corrected,unknown", columns());
    return all;
}

const column_list<root_row>& columns_with_law() {
    static const auto all =
        joined(columns_of_equation(), columns_named("law_root,law_error,proved_radius,deviation", columns()));
    return all;
}

table roots_of_list(const sweep_energy& at, const exact& point, int order, long digits) {
    const precision_scope scope(digits + guard_digits);
    const motion m = motion::of_energy(at.value);
    const mpfr radius = coverage_from<mpfr>(m, point.coefficient).radius;
    const auto list = series_on_arc<mpfr>(m, point.coefficient, order).scaled;
    const auto zero = zeros_of(list, epsilon<mpfr>());
    std::vector<root_row> rows;
    for (int n = 1; n <= order; ++n) {
        if (!zero[static_cast<std::size_t>(n)]) {
            const mpfr power = mpfr(-1) / n;
            rows.push_back({n, pow(mpfr(abs(list[n])), power), pow(mpfr(abs(list[n]) * n), power), radius, digits, "",
                            &at, &point});
        }
    }
    return make_table(columns_of_pendulum(), rows);
}

std::vector<root_row> roots_in(const list_of_unknown& of) {
    std::vector<root_row> rows;
    const known_value radius = of.law != nullptr ? of.law->radius(of.digits) : known_value{};
    for (int n = 1; n <= of.list.order(); ++n) {
        if (of.list[n] != 0) {
            const mpfr power = mpfr(-of.root) / n;
            const mpfr size = abs(of.list[n]);
            root_row& row = rows.emplace_back(
                root_row{n, pow(size, power), pow(mpfr(size * n), power), mpfr(1), of.digits, of.unknown});
            if (of.law != nullptr) {
                row.proved_radius = radius;
                if (n >= of.law->first() && (n - of.law->residue()) % of.law->stride() == 0) {
                    row.law = of.law->root(n, of.digits, proved_law::source::law);
                }
            }
        }
    }
    return rows;
}

const char* const too_short = "is too short a list for a root test";

study_plan plan_of_pendulum(const study_request& request) {
    const auto orders = orders_from(request, least_order_of_lists, too_short);
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_point(
        {head_of("", scalar, columns_of_pendulum()), head_of("estimates", scalar, judged_answer_columns())},
        sweep_of(request), [orders, scalar](const sweep_energy& at, const exact& point) {
            return std::vector<table>{roots_of_list(at, point, orders.back(), scalar.digits),
                                      answers_about(at, point, orders, scalar, is_by_size)};
        });
}

study_plan plan_of_equation(const study_request& request) {
    return plan_of_lists(request, too_short, proves_law(request) ? columns_with_law() : columns_of_equation(), roots_in,
                         "estimates", is_by_size);
}

}  // namespace
}  // namespace root_test_study

const study& root_test() {
    using namespace root_test_study;
    static const study result{
        .name = "root_test",
        .title = "The root test",
        .question = "How slowly does the root test find the radius of convergence?",
        .reading =
            "The relative error of |a_n|^(-1/n) (top row) and of |n a_n|^(-1/n) (bottom row) over n, both "
            "logarithmic. The coefficients are R^-n times a power of n, and the root of that power is what the plain "
            "test errs by: ln(n)/n, the broad grey line, still 1% at n = 600. The factor n takes the power of "
            "logarithms away and leaves ln(A)/n by the amplitude A of the coefficients: each further digit costs ten "
            "times the coefficients. About the bottom, and about the top at E = 1, the errors lie on the dotted "
            "lines of the amplitude; elsewhere the phase of a complex pair makes them scatter. The second figure "
            "compares what the tests that look at sizes alone answer, and the uncertainty that they give, with the "
            "verdict of all tests on the same lists: two digits from 400 coefficients, against all 30 from 80.",
        .of = &pendulum_problem(),
        .parameters = {{"--energies", "0.5,1,1.71,2.02", "energies E, in m g l"},
                       {"--gaps", "", "energies as 2 - E"},
                       {"--points", "0,1", "expansion points, fractions of T*: 0 the top, 1 the bottom"},
                       {"--orders", "20,40,60,80,120,160,240,400",
                        "N, last powers of the lists under test; roots are drawn up to the largest"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
        .quick = {{"--energies", "1,1.71", ""}, {"--orders", "12", ""}, {"--points", "0,1", ""}},
        .seconds = 2,
        .excluded = no_answer_at_limits("theta is constant and has no finite radius", "T* is infinite"),
        .plan = plan_of_pendulum,
        .version = 3,
        .any_equation = equation_form{
            .plan = plan_of_equation,
            .reading =
                "Roots of the coefficients over 1/n: |a_n|^(-1/n), and |n a_n|^(-1/n), which knows how the "
                "coefficients of a logarithm fall. Both creep towards the radius, the grey line of the verdict, like "
                "ln n over n: more coefficients help less than a test that fits where they come from. With --prove the "
                "law "
                "of all coefficients adds the root that it predicts, the radius, and a bound of their distance, proved "
                "at each n.",
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
