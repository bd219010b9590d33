// How does the proved radius of convergence of an equation depend on its parameters, and what does a digit cost?
#include <algorithm>
#include <chrono>

#include "libration/equation/first_order_form.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "shared/equation_plan.hpp"

namespace libration::studies {

namespace proved_radius_study {

namespace {

constexpr int most_digits = 200;

struct radius_row {
    int digits;
    std::string lower, upper;
    cell place_re, place_im;
    std::string kind;
    std::string unknown;
};

const column_list<radius_row>& columns() {
    using row = radius_row;
    static const column_list<row> all{
        {"digits", "D, to which the bounds agree", [](const row& r) { return r.digits; }},
        {"lower", "bound of the radius (proved); inf for a linear equation with entire coefficients",
         [](const row& r) { return number_cell(r.lower); }},
        {"upper", "bound of the radius (proved)", [](const row& r) { return number_cell(r.upper); }},
        {"position_re", "nearest singularity from the start, real part", [](const row& r) { return r.place_re; }},
        {"position_im", "imaginary part, not below 0", [](const row& r) { return r.place_im; }},
        {"kind", "of it (heuristic)", [](const row& r) { return r.kind; }},
        {"unknown", "of the problem, the most singular there", [](const row& r) { return r.unknown; }},
    };
    return all;
}

struct cost_row {
    int digits;
    std::size_t discs;
    double seconds;
    std::string unknown;
};

const column_list<cost_row>& cost_columns() {
    using row = cost_row;
    static const column_list<row> all{
        {"digits", "D, to which the bounds agree", [](const row& r) { return r.digits; }},
        {"discs", "of the covering and of the loop", [](const row& r) { return r.discs; }},
        {"seconds", "of the whole proof on this machine", [](const row& r) { return decimal_cell(r.seconds, 4); }},
        {"unknown", "of the problem, the most singular there", [](const row& r) { return r.unknown; }},
    };
    return all;
}

std::vector<table> proved_rows(const ode::explicit_system& system, const std::vector<int>& all) {
    std::vector<radius_row> rows;
    std::vector<cost_row> costs;
    const auto names = ode::first_order_form(system).names;
    for (const int digits : all) {
        const auto begin = std::chrono::steady_clock::now();
        const auto radius = ode::prove_radius(system, digits);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const precision_scope scope(digits + 40);
        if (radius.infinite) {
            rows.push_back({digits, "inf", "inf", {}, {}, "", names.front()});
            costs.push_back({digits, 0, seconds, names.front()});
            continue;
        }
        const auto& nearest = *radius.nearest;
        const std::string& unknown = names[nearest.unknown];
        rows.push_back({digits, parts_of(midpoint_of(radius.lower), digits + 2, MPFR_RNDD).text(),
                        parts_of(midpoint_of(radius.upper), digits + 2, MPFR_RNDU).text(),
                        decimal_cell(nearest.offset.re, digits), decimal_cell(mpfr(abs(nearest.offset.im)), digits),
                        ode::words_of(nearest.kind, nearest.exponent.real()), unknown});
        costs.push_back({digits, radius.cover.discs.size() + static_cast<std::size_t>(radius.evidence->evidence.discs),
                         seconds, unknown});
    }
    return {make_table(columns(), rows), make_table(cost_columns(), costs)};
}

std::vector<int> digits_from(const study_request& request) {
    std::vector<int> digits = request.digits();
    std::ranges::sort(digits);
    if (digits.front() < 1 || digits.back() > most_digits) {
        throw input_error("--digits", std::to_string(digits.front() < 1 ? digits.front() : digits.back()),
                          "is not a number of digits from 1 to 200", "write numbers such as 10,20,30");
    }
    return digits;
}

study_plan plan(const study_request& request) {
    const auto sweep = equation_sweep_of(request);
    const scalar_spec scalar{scalar_kind::proved, digits_from(request).back()};
    std::vector<study_table> tables{head_of(*sweep, "", scalar, columns()),
                                    head_of(*sweep, "cost", scalar, cost_columns())};
    tables.back().timed = true;
    return plan_by_numbers(
        std::move(tables), sweep, "digits", digits_from(request),
        [sweep](std::size_t i, const std::vector<int>& chosen) { return proved_rows(sweep->system(i), chosen); });
}

}  // namespace
}  // namespace proved_radius_study

const study& proved_radius() {
    using namespace proved_radius_study;
    static const study result{
        .name = "proved_radius",
        .title = "The radius of convergence, proved",
        .question =
            "How does the radius of convergence depend on the parameters of an equation, and what does a proof "
            "of it cost?",
        .reading =
            "Lower and upper bound of the radius about the start, which agree to D digits, by a loop round the nearest "
            "singularity and a covering of the disc that does not reach it. On the right the number of discs and the "
            "time of the proof against D: about ten discs a digit, each of which costs more digits the more there are, "
            "so that the time grows like a small power of D.",
        .alone = true,
        .any_equation = equation_form{.plan = plan,
                                      .parameters = {{"--digits", "10", "D, digits to which the bounds agree"}},
                                      .example = {"van_der_pol", {"m=1:4:4"}},
                                      .example_words = {{"--digits", "5,10,20"}},
                                      .quick = {{"--digits", "3"}},
                                      .seconds = 60}};
    return result;
}

}  // namespace libration::studies
