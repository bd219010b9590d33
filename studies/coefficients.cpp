// How fast do the coefficients of the series of an equation decrease, and do they agree with the radius from the tests?
#include <algorithm>
#include <optional>

#include "shared/list_answers.hpp"

namespace libration::studies {

namespace coefficients_study {

namespace {

constexpr long digits_of_logs = 12;

struct coefficient_row {
    int n;
    mpfr value;
    std::optional<mpfr> log10_fitted;
    int root;
    long digits;
    std::string unknown;
};

const column_list<coefficient_row>& columns() {
    using row = coefficient_row;
    static const column_list<row> all{
        {"n", "index of the coefficient", [](const row& r) { return r.n; }},
        {"coefficient", "of (variable - start)^power", [](const row& r) { return decimal_cell(r.value, r.digits); }},
        {"log10_abs", "log10 of its size; empty where it is 0",
         [](const row& r) { return r.value == 0 ? cell() : log10_cell(r.value); }},
        {"log10_fitted",
         "log10 of c n^(-1 - nu) R^-n with the radius R and the exponent nu that the tests find (0 where they find "
         "none), and c so large that no coefficient of the second half is above it; empty without a radius",
         [](const row& r) { return decimal_cell(r.log10_fitted, digits_of_logs); }},
        {"power", "of the distance from the start: n, or n/q where the series goes in its q-th root",
         [](const row& r) { return cell(rational(r.n, r.root).str()); }},
        unknown_column<row>(),
    };
    return all;
}

// log10 of n^(1 + nu) R^(n/root).
mpfr inverse_envelope(const answer_of_test& found, int root, int n) {
    const mpfr exponent = 1 + found.of.exponent.value_or(mpfr(0));
    return mpfr(log10(*found.radius) * n / root + exponent * log10(mpfr(std::max(n, 1))));
}

std::vector<coefficient_row> rows_of(const series::power_series<mpfr>& list, const answer_of_test& found, int root,
                                     long digits, const std::string& unknown) {
    std::optional<mpfr> height;
    for (int n = (list.order() + 1) / 2; found.radius && n <= list.order(); ++n) {
        if (list[n] != 0) {
            const mpfr here = log10(mpfr(abs(list[n]))) + inverse_envelope(found, root, n);
            height = height ? std::max(*height, here) : here;
        }
    }
    std::vector<coefficient_row> rows;
    for (int n = 0; n <= list.order(); ++n) {
        const auto fitted =
            height && n > 0 ? std::optional(mpfr(*height - inverse_envelope(found, root, n))) : std::optional<mpfr>();
        rows.push_back({n, list[n], fitted, root, digits, unknown});
    }
    return rows;
}

// Both tables for one combination of the parameters.
std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders,
                             const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    const auto lists = unknown_lists(sweep.system(i), orders.back(), scalar.digits + guard_of_lists);
    const auto answers = answers_to(lists, sweep, orders, scalar, is_verdict);
    std::vector<coefficient_row> rows;
    for (const int unknown : sweep.unknowns()) {
        const auto& name = sweep.name_of(unknown);
        const auto last = std::ranges::find_if(
            answers, [&](const answered_list& each) { return each.unknown == name && each.order == orders.back(); });
        const auto& list = lists[static_cast<std::size_t>(unknown)].coefficients();
        const auto own = rows_of(list, last == answers.end() ? answer_of_test{} : last->found, lists.front().lists.root,
                                 scalar.digits, name);
        rows.insert(rows.end(), own.begin(), own.end());
    }
    return {make_table(columns(), rows), make_table(answered_columns(), answers)};
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a radius test");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "radius", scalar, answered_columns())}, sweep,
        [sweep, orders, scalar](std::size_t i) { return tables_at(*sweep, i, orders, scalar); });
}

}  // namespace
}  // namespace coefficients_study

const study& coefficients() {
    using namespace coefficients_study;
    static const study result{
        .name = "coefficients",
        .title = "The size of the coefficients",
        .question = "How do the coefficients fall with their power, and is that the radius that the tests see?",
        .reading =
            "The size of every coefficient about the start; those that are 0 are left out. The line is c n^(-1 - nu) "
            "R^-n with the radius R and the exponent nu of the verdict of the radius tests, and with c so large that "
            "no coefficient of the second half lies above it: the marks dip below where several singularities at one "
            "distance beat, and follow the line where there is one.",
        .plan = plan,
        .any_equation = equation_form{
            .parameters = {{"--orders", "200", "N, last powers of the lists under test; the largest is drawn"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test, and their digits"}},
            .example = {"painleve_1", {}},
            .quick = {{"--orders", "30"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
