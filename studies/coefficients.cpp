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
mpfr inverse_envelope(const convergence::radius_estimate<mpfr>& found, int root, int n) {
    const mpfr exponent = 1 + found.exponent.value_or(mpfr(0));
    return mpfr(log10(*found.radius) * n / root + exponent * log10(mpfr(std::max(n, 1))));
}

std::vector<coefficient_row> rows_of(const list_of_unknown& of) {
    // One order after the other: the last result is that for the whole list.
    const auto last = std::ranges::find(of.answers.rbegin(), of.answers.rend(), of.unknown, &answered_list::unknown);
    const auto found = last == of.answers.rend() ? convergence::radius_estimate<mpfr>() : last->found;
    std::optional<mpfr> height;
    for (int n = (of.list.order() + 1) / 2; found.radius && n <= of.list.order(); ++n) {
        if (of.list[n] != 0) {
            const mpfr here = log10(mpfr(abs(of.list[n]))) + inverse_envelope(found, of.root, n);
            height = height ? std::max(*height, here) : here;
        }
    }
    std::vector<coefficient_row> rows;
    for (int n = 0; n <= of.list.order(); ++n) {
        const auto fitted = height && n > 0 ? std::optional(mpfr(*height - inverse_envelope(found, of.root, n)))
                                            : std::optional<mpfr>();
        rows.push_back({n, of.list[n], fitted, of.root, of.digits, of.unknown});
    }
    return rows;
}

study_plan plan(const study_request& request) {
    return plan_of_lists(request, "is too short a list for a radius test", columns(), rows_of, "radius", is_verdict);
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
        .version = 2,
        .any_equation = equation_form{
            .plan = plan,
            .parameters = {{"--orders", "200", "N, last powers of the lists under test; the largest is drawn"},
                           {"--scalar", "mpfr:30", "arithmetic of the lists under test, and their digits"}},
            .example = {"painleve_1", {}},
            .quick = {{"--orders", "30"}},
            .seconds = 1}};
    return result;
}

}  // namespace libration::studies
