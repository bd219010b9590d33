// How slowly does the root test find the radius of convergence of any equation?
#include <algorithm>

#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace root_test_of_equation {

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

// Whether the table of estimates shows a test: those by size alone, and what is better.
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
        const auto& list = lists.unknowns[static_cast<std::size_t>(unknown)].parts.front();
        for (int n = 1; n <= list.order(); ++n) {
            if (list[n] != 0) {
                const mpfr root(mpfr(-lists.root) / n);
                rows.push_back({n, pow(mpfr(abs(list[n])), root), pow(mpfr(abs(list[n]) * n), root), scalar.digits,
                                sweep.name_of(unknown)});
            }
        }
    }
    return {make_table(columns(), rows),
            make_table(answered_columns(), answers_to(lists, sweep, orders, scalar, by_size))};
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a root test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "estimates", scalar, answered_columns())}, sweep,
        [sweep, orders, scalar](std::size_t i) { return tables_at(*sweep, i, orders, scalar); });
}

}  // namespace
}  // namespace root_test_of_equation

const equation_study& root_test() {
    using namespace root_test_of_equation;
    static const equation_study result{
        .name = "root_test",
        .title = "The root test",
        .question = "How slowly does the root test find the radius of convergence?",
        .reading =
            "Roots of the coefficients over 1/n: |a_n|^(-1/n), and |n a_n|^(-1/n), which knows how the coefficients of "
            "a logarithm fall. Both creep towards the radius, the grey line of the verdict, like ln n over n: more "
            "coefficients help less than a test that fits where they come from.",
        .parameters = {{"--orders", "20,50,100,200", "N, last powers of the lists judged; the largest is drawn"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists that are judged"}},
        .example = {"blasius", {}},
        .example_words = {},
        .quick = {{"--orders", "20"}},
        .seconds = 1,
        .plan = plan};
    return result;
}

}  // namespace libration::studies::of_equation
