// Do the ratios of successive coefficients of any equation run straight to its radius of convergence?
#include <algorithm>
#include <optional>

#include "libration/convergence/estimate/coefficient_ratios.hpp"
#include "list_answers.hpp"

namespace libration::studies::of_equation {

namespace domb_sykes_of_equation {

namespace {

struct ratio_row {
    int power, root, n;
    mpfr ratio;
    long digits;
    std::string unknown;
};

const column_list<ratio_row>& columns() {
    using row = ratio_row;
    static const column_list<row> all{
        {"power",
         "p: the series is taken in the p-th power of the distance, as its zeros allow; of a list in powers of the "
         "q-th root p/q, a_n the coefficient of the power n/q",
         [](const row& r) { return number_cell(decimal_of(rational(r.power, r.root), 12)); }},
        {"n", "power of the later coefficient", [](const row& r) { return r.n; }},
        {"inverse_n", "1/n", [](const row& r) { return decimal_cell(mpfr(mpfr(1) / r.n), r.digits); }},
        {"ratio", "a_n/a_(n-p), in the unit of the variable to the power -p",
         [](const row& r) { return decimal_cell(r.ratio, r.digits); }},
        {"log10_abs_ratio", "log10 of its size", [](const row& r) { return log10_cell(r.ratio); }},
        unknown_column<row>(),
    };
    return all;
}

// The ratios of one list in the power that its pattern leaves.
std::vector<ratio_row> ratios_in(const series::power_series<mpfr>& list, int root, long digits,
                                 const std::string& unknown) {
    const auto unit = convergence::unit_of(list);
    const auto scaled = convergence::in_unit_of<mpfr>(list, unit);
    const auto pattern = convergence::pattern_of(scaled, epsilon<mpfr>());
    std::vector<ratio_row> rows;
    if (pattern.last < 0 || pattern.polynomial) {
        return rows;
    }
    const int power = std::max(1, pattern.stride);
    const convergence::strided_series<mpfr> part(scaled, pattern.first % power, power);
    const mpfr back = pow(mpfr(unit.length), -power);
    for (const auto& each : convergence::ratios_of(part)) {
        rows.push_back({power, root, each.n, mpfr(each.value * back), digits, unknown});
    }
    return rows;
}

std::vector<table> tables_at(const equation_sweep& sweep, std::size_t i, const std::vector<int>& orders,
                             const scalar_spec& scalar) {
    const precision_scope scope(scalar.digits + guard_of_lists);
    const auto lists = lists_about_start(sweep.system(i), orders.back(), scalar.digits + guard_of_lists);
    std::vector<ratio_row> rows;
    for (const int unknown : sweep.unknowns()) {
        const auto own = ratios_in(lists.unknowns[static_cast<std::size_t>(unknown)].parts.front(), lists.root,
                                   scalar.digits, sweep.name_of(unknown));
        rows.insert(rows.end(), own.begin(), own.end());
    }
    const auto all = [](const std::string&) { return true; };
    return {make_table(columns(), rows), make_table(answered_columns(), answers_to(lists, sweep, orders, scalar, all))};
}

study_plan plan(const shared_problem& problem, const study_request& request) {
    const auto sweep = sweep_of(problem, request);
    const auto orders = orders_from(request, least_order_of_lists, "leaves no ratios to draw");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_by_parameters(
        {head_of(*sweep, "", scalar, columns()), head_of(*sweep, "intercepts", scalar, answered_columns())}, sweep,
        [sweep, orders, scalar](std::size_t i) { return tables_at(*sweep, i, orders, scalar); });
}

}  // namespace
}  // namespace domb_sykes_of_equation

const equation_study& domb_sykes() {
    using namespace domb_sykes_of_equation;
    static const equation_study result{
        .name = "domb_sykes",
        .title = "The Domb-Sykes plot",
        .question = "Do the ratios of successive coefficients run straight to the radius of convergence?",
        .reading =
            "Ratios of coefficients over 1/n, of the series in the power that its zeros leave. A single nearest "
            "singularity makes a straight line whose intercept is its place to that power, and whose slope its "
            "exponent; the grey lines are plus and minus the verdict of all tests. A pair of singularities scatters "
            "the ratios for ever. The second table holds what each test answers.",
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
