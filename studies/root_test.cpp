// How slowly does the root test find the radius of convergence? [paper sec:conclusions]
#include <algorithm>
#include <utility>

#include "shared/list_answers.hpp"
#include "shared/radius_cells.hpp"
#include "shared/sweep_plan.hpp"

namespace libration::studies {

namespace root_test_study {

namespace of_pendulum {

using namespace convergence;
using namespace pendulum;

namespace {

constexpr long guard_digits = 15;
constexpr int least_order = 4;

// The roots of one coefficient, in units of the radius.
struct root_row {
    const sweep_energy& at;
    const exact& point;
    long digits;
    int n;
    mpfr root, corrected, radius;
};

const column_list<root_row>& columns() {
    using row = root_row;
    static const auto all = with_typed_energy<row>({
        energy_column<row>(),
        point_column<row>(),
        {"n", "power of t; those with a_n = 0 are left out", [](const row& r) { return r.n; }},
        {"root", "|a_n|^(-1/n), dimensionless time",
         [](const row& r) { return decimal_cell(mpfr(r.root * r.radius), r.digits); }},
        {"corrected", "|n a_n|^(-1/n), dimensionless time",
         [](const row& r) { return decimal_cell(mpfr(r.corrected * r.radius), r.digits); }},
        {"exact", "radius of convergence R from the lattice of singularities, dimensionless time",
         [](const row& r) { return decimal_cell(r.radius, r.digits); }},
        {"root_error", "root/exact - 1", [](const row& r) { return decimal_cell(mpfr(r.root - 1), digits_of_errors); }},
        {"corrected_error", "corrected/exact - 1",
         [](const row& r) { return decimal_cell(mpfr(r.corrected - 1), digits_of_errors); }},
        {"log10_root_error", "log10 of the size of root_error",
         [](const row& r) { return log10_cell(mpfr(r.root - 1)); }},
        {"log10_corrected_error", "log10 of the size of corrected_error",
         [](const row& r) { return log10_cell(mpfr(r.corrected - 1)); }},
        {"amplitude", "A: twice the number of singularities on the circle; |a_n| is at most about A/n R^-n",
         [](const row& r) { return 2 * nearest_count_on_arc(r.point.coefficient); }},
        gap_column<row>(),
    });
    return all;
}

// Whether the table of estimates shows a test: those by size alone, and the verdict.
bool by_size(const std::string& method) {
    const auto tests = all_radius_tests<double>();
    return method == "verdict" || std::any_of(tests.begin(), tests.end(), [&](const radius_test<double>& test) {
               return test.method == method && test.kind == radius_test_kind::sizes;
           });
}

table roots_of_list(const sweep_energy& at, const exact& point, int order, long digits) {
    const precision_scope scope(digits + guard_digits);
    const motion m = motion::of_energy(at.value);
    const mpfr radius = coverage_from<mpfr>(m, point.coefficient).radius;
    const auto list = series_on_arc<mpfr>(m, point.coefficient, order).scaled;
    const auto zero = zeros_of(list, epsilon<mpfr>());
    std::vector<root_row> all;
    for (int n = 1; n <= order; ++n) {
        if (zero[static_cast<std::size_t>(n)]) {
            continue;
        }
        const mpfr root = pow(mpfr(abs(list[n])), mpfr(-1) / n);
        const mpfr corrected = pow(mpfr(abs(list[n]) * n), mpfr(-1) / n);
        all.push_back({at, point, digits, n, root, corrected, radius});
    }
    return make_table(columns(), all);
}

study_plan plan(const study_request& request) {
    const std::vector<int> orders = orders_from(request, least_order, "is too short a list for a root test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_point({head_of("", scalar, columns()), head_of("estimates", scalar, judged_answer_columns())},
                         sweep_of(request), [orders, scalar](const sweep_energy& at, const exact& point) {
                             return std::vector<table>{roots_of_list(at, point, orders.back(), scalar.digits),
                                                       answers_about(at, point, orders, scalar, by_size)};
                         });
}

}  // namespace
}  // namespace of_pendulum

namespace of_equation {

namespace {

struct root_row {
    int n;
    mpfr root, corrected;
    long digits;
    std::string unknown;
};

const column_list<root_row>& columns() {
    using row = root_row;
    static const column_list<row> all{
        {"n", "power; those with a_n = 0 are left out", [](const row& r) { return r.n; }},
        {"inverse_n", "1/n", [](const row& r) { return decimal_cell(mpfr(mpfr(1) / r.n), r.digits); }},
        {"root", "|a_n|^(-1/n), in the unit of the variable",
         [](const row& r) { return decimal_cell(r.root, r.digits); }},
        {"corrected", "|n a_n|^(-1/n), in the unit of the variable",
         [](const row& r) { return decimal_cell(r.corrected, r.digits); }},
        unknown_column<row>(),
    };
    return all;
}

// Whether the table of estimates shows a test: those by size alone, and the verdict.
bool by_size(const std::string& method) {
    const auto tests = convergence::all_radius_tests<double>();
    return is_verdict(method) || std::ranges::any_of(tests, [&](const convergence::radius_test<double>& test) {
               return test.method == method && test.kind == convergence::radius_test_kind::sizes;
           });
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders,
                             const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    const auto lists = lists_about_start(sweep.system(i), orders.back(), scalar.digits + guard_of_lists);
    std::vector<root_row> rows;
    for (const int unknown : sweep.unknowns()) {
        const auto& list = lists[static_cast<std::size_t>(unknown)].coefficients();
        for (int n = 1; n <= list.order(); ++n) {
            if (list[n] != 0) {
                const mpfr root(mpfr(-lists.front().lists.root) / n);
                rows.push_back({n, pow(mpfr(abs(list[n])), root), pow(mpfr(abs(list[n]) * n), root), scalar.digits,
                                sweep.name_of(unknown)});
            }
        }
    }
    return {make_table(columns(), rows),
            make_table(answered_columns(), answers_to(lists, sweep, orders, scalar, by_size))};
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a root test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "estimates", scalar, answered_columns())}, sweep,
        [sweep, orders, scalar](std::size_t i) { return tables_at(*sweep, i, orders, scalar); });
}

}  // namespace
}  // namespace of_equation

namespace {

study_plan plan(const study_request& request) {
    return request.equation ? of_equation::plan(request) : of_pendulum::plan(request);
}

}  // namespace
}  // namespace root_test_study

const study& root_test() {
    using namespace root_test_study;
    static const study result{
        .name = "root_test",
        .title = "The root test",
        .label = "",
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
        .plan = plan,
        .any_equation = equation_form{
            .reading =
                "Roots of the coefficients over 1/n: |a_n|^(-1/n), and |n a_n|^(-1/n), which knows how the "
                "coefficients of a logarithm fall. Both creep towards the radius, the grey line of the verdict, like "
                "ln n over n: more coefficients help less than a test that fits where they come from.",
            .parameters = {{"--orders", "20,50,100,200",
                            "N, last powers of the lists under test; the largest is drawn"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
            .example = {"blasius", {}},
            .quick = {{"--orders", "20"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
