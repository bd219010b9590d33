// Are the reference values used for testing solvers correct?
#include <algorithm>
#include <string>
#include <vector>

#include "../shared/catalogue_system.hpp"
#include "../shared/named_choice.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/problem/known/blasius.hpp"
#include "libration/problem/known/falkner_skan.hpp"
#include "libration/problem/known/painleve_1.hpp"
#include "libration/problem/known/sakiadis_shear.hpp"
#include "libration/problem/known/thomas_fermi.hpp"
#include "libration/problem/problem_family.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/query/states.hpp"
#include "printed_stiff_states.hpp"
#include "sweep/study.hpp"
#include "text/members.hpp"

namespace libration::studies {

namespace published_study {

namespace {

// Digits beyond those of the longest printed value of a kind.
constexpr long more_digits = 6;

// A published value.
struct printed_value {
    std::string quantity;
    std::string printed;
    std::string source;
};

// The published values of one problem, and the function that computes proved values in the same order.
struct kind_of_value {
    std::string name;
    std::string problem;
    std::vector<printed_value> printed;
    std::function<std::vector<proved_decimal>(long digits)> prove;
};

std::vector<proved_decimal> state_at(const ode::equation_system& system, const std::string& time, long digits) {
    return ode::proved_trajectory(ode::explicit_system(system), {ode::parse_constant(time).constant()}, digits).front();
}

const std::vector<kind_of_value>& kinds_of_theory() {
    static const std::vector<kind_of_value> all{
        {"blasius",
         "blasius",
         {{"f''(0) for f'(inf) = 1", "0.33205733621519629893718006201058", "OEIS A256522"}},
         [](long digits) {
             return std::vector<proved_decimal>{proved_value(digits, [] { return ode::blasius_shear(ball(1)); })};
         }},
        {"falkner_skan_layer",
         "falkner_skan",
         {{"f''(0) for b = 0", "0.469599988361", "the catalogue, after V. M. Falkner, S. W. Skan"},
          {"f''(0) for b = 1/2", "0.927680039837", "the catalogue, after V. M. Falkner, S. W. Skan"},
          {"f''(0) for b = 1", "1.232587656820289", "public codes for the flow towards a wall"},
          {"f''(0) for b = 1", "1.23258765682022", "public codes for the flow towards a wall"}},
         [](long digits) {
             const auto shear = [&](const std::string& b, const std::string& s) {
                 const auto equations = catalogue_system("falkner_skan", {"b = " + b, "s = " + s});
                 return proved_value(digits, [&] { return ode::falkner_skan_shear(equations); });
             };
             const auto flat = proved_value(digits, [] { return ode::blasius_shear(ball(1)) * sqrt(ball(2)); });
             const auto stagnation = shear("1", "1.2326");
             return std::vector<proved_decimal>{flat, shear("1/2", "0.9277"), stagnation, stagnation};
         }},
        {"sakiadis_layer",
         "sakiadis",
         {{"f''(0) for f'(inf) = 0", "-0.443748313368861", "the catalogue, after B. C. Sakiadis"}},
         [](long digits) {
             const auto equations = catalogue_system("sakiadis");
             return std::vector<proved_decimal>{proved_value(digits, [&] { return ode::sakiadis_shear(equations); })};
         }},
        {"thomas_fermi_slope",
         "thomas_fermi",
         {{"y'(0) for y(inf) = 0", "-1.588071022611375312718", "J. P. Boyd, J. Comput. Appl. Math. 244 (2013) 90-101"}},
         [](long digits) {
             return std::vector<proved_decimal>{proved_value(digits, [] { return ode::thomas_fermi_slope(); })};
         }},
        {"tritronquee",
         "painleve_1",
         {{"u(0) without oscillations at -inf", "-0.1875543083404949",
           "B. Fornberg, J. A. C. Weideman, J. Comput. Phys. 230 (2011) 5957-5973"},
          {"u'(0)", "0.3049055602612289", "B. Fornberg, J. A. C. Weideman, J. Comput. Phys. 230 (2011) 5957-5973"}},
         [](long digits) {
             return proved_decimals(digits, [] {
                 const auto start = ode::tritronquee_start();
                 return std::vector{start.value, start.slope};
             });
         }},
        {"lane_emden_zero",
         "lane_emden",
         {{"first zero for n = 2", "4.35287459594612467697", "J. P. Boyd, Appl. Math. Comput. 217 (2011) 5553-5565"},
          {"first zero for n = 3", "6.89684861937696037545", "J. P. Boyd, Appl. Math. Comput. 217 (2011) 5553-5565"},
          {"first zero for n = 4", "14.97154634883809509761", "J. P. Boyd, Appl. Math. Comput. 217 (2011) 5553-5565"}},
         [](long digits) {
             std::vector<proved_decimal> zeros;
             for (const std::string n : {"n = 2", "n = 3", "n = 4"}) {
                 const auto equations = catalogue_system("lane_emden", {n});
                 ode::event_request request;
                 request.g = ode::parse_condition(equations, "y = 0");
                 zeros.push_back(ode::proved_events(ode::explicit_system(equations), request, digits).front().time);
             }
             return zeros;
         }},
        {"lorenz_orbit",
         "lorenz",
         {{"x on z = 27 of the orbit AB", "-13.76361068213420052501", "D. Viswanath, Physica D 190 (2004) 115-128"},
          {"y there", "-19.57875194245179553883", "D. Viswanath, Physica D 190 (2004) 115-128"},
          {"its period", "1.55865221071617472756", "D. Viswanath, Physica D 190 (2004) 115-128"}},
         [](long digits) {
             const auto orbit = ode::proved_periodic_orbit(
                 ode::explicit_system(catalogue_system("lorenz", {"x(0) = -13.7636", "y(0) = -19.5788", "z(0) = 27"})),
                 digits);
             return std::vector<proved_decimal>{orbit.start[0], orbit.start[1], orbit.period};
         }},
        {"van_der_pol_cycle",
         "van_der_pol",
         {{"amplitude of the cycle for m = 1", "2.008619860874843136509",
           "the catalogue, after E. Hairer, S. P. Norsett, G. Wanner, I.16"},
          {"its period", "6.66328685932313018969", "the catalogue, after E. Hairer, S. P. Norsett, G. Wanner, I.16"}},
         [](long digits) {
             const auto orbit =
                 ode::proved_periodic_orbit(ode::explicit_system(catalogue_system("van_der_pol")), digits);
             return std::vector<proved_decimal>{orbit.start[0], orbit.period};
         }},
    };
    return all;
}

kind_of_value kind_of_state(const proved::printed_state& of) {
    std::vector<printed_value> printed;
    for (const auto& [unknown, digits] : of.values) {
        printed.push_back({unknown + " at t = " + of.time, digits, of.source});
    }
    return {
        of.name, of.problem, printed, [of](long digits) {
            const auto equations = catalogue_system(of.problem, of.changes);
            const auto state = state_at(equations, of.time, digits);
            const auto names = ode::names_of_state(ode::explicit_system(equations));
            std::vector<proved_decimal> result;
            for (const auto& [unknown, printed_digits] : of.values) {
                result.push_back(state.at(static_cast<std::size_t>(std::ranges::find(names, unknown) - names.begin())));
            }
            return result;
        }};
}

const std::vector<kind_of_value>& kinds() {
    static const std::vector<kind_of_value> all = [] {
        std::vector<kind_of_value> result = kinds_of_theory();
        for (const proved::printed_state& each : proved::printed_stiff_states()) {
            result.push_back(kind_of_state(each));
        }
        return result;
    }();
    return all;
}

// The position of the last printed digit, as a power of 10.
long last_place_of(const std::string& printed) {
    const auto mark = printed.find('e');
    const std::string digits = printed.substr(0, mark);
    const auto point = digits.find('.');
    const long exponent = mark == std::string::npos ? 0 : std::stol(printed.substr(mark + 1));
    return exponent - (point == std::string::npos ? 0 : static_cast<long>(digits.size() - point - 1));
}

struct published_row {
    std::string kind, problem;
    printed_value printed;
    std::string value;
    mpfr units;
};

// A truncated value is up to one unit away, a rounded one half a unit; the proved value itself is accurate to 10^-6 of
// a unit.
bool holds(const published_row& r) { return r.units <= 1; }

const column_list<published_row>& columns() {
    using row = published_row;
    static const column_list<row> all{
        {"value_of", "which values", [](const row& r) { return r.kind; }},
        {"problem", "name in the catalogue", [](const row& r) { return r.problem; }},
        {"quantity", "what is printed", [](const row& r) { return r.printed.quantity; }},
        {"printed", "its digits in print", [](const row& r) { return number_cell(r.printed.printed); }},
        {"value", "proved", [](const row& r) { return number_cell(r.value); }},
        {"units", "distance of the two in units of the last printed digit",
         [](const row& r) { return decimal_cell(r.units, 6); }},
        {"verdict", "holds where that is at most 1", [](const row& r) { return holds(r) ? "holds" : "fails"; }},
        {"rigour", "of value", [](const row&) { return "proved"; }},
        {"source", "of the printed digits", [](const row& r) { return r.printed.source; }},
    };
    return all;
}

table rows_of_kind(const kind_of_value& of) {
    std::size_t longest = 0;
    for (const printed_value& each : of.printed) {
        longest = std::max(longest, each.printed.size());
    }
    const long digits = static_cast<long>(longest) + more_digits;
    const auto proved = of.prove(digits);
    const precision_scope scope(digits + 10);
    std::vector<published_row> rows;
    for (std::size_t i = 0; i < of.printed.size(); ++i) {
        const printed_value& printed = of.printed[i];
        const mpfr unit = pow(mpfr(10), static_cast<int>(last_place_of(printed.printed)));
        const mpfr distance = abs(mpfr(proved[i].text) - mpfr(printed.printed));
        rows.push_back({of.name, of.problem, printed, proved[i].text, mpfr(distance / unit)});
    }
    return make_table(columns(), rows);
}

const named_choice& values_to_choose() {
    static const named_choice result{.axis = "value_of",
                                     .option = "--values",
                                     .help = "published values",
                                     .forms = "LIST, or all",
                                     .remedy = "write names such as blasius,lorenz_orbit, or all",
                                     .what = "not a set of values of this study",
                                     .names = members_of(kinds(), &kind_of_value::name)};
    return result;
}

study_plan plan(const study_request& request) {
    std::vector<kind_of_value> all;
    for (const std::string& name : chosen_names(values_to_choose(), request.values)) {
        all.push_back(named(kinds(), name));
    }
    return plan_of_cells(
        {head_of("", {scalar_kind::proved, 50}, columns())}, {"value_of"}, all.size(),
        [all](std::size_t i) {
            return cell_inputs{{"value_of", all[i].name}};
        },
        [all](std::size_t i) { return std::vector<table>{rows_of_kind(all[i])}; });
}

const problem_family& values_in_print() {
    static const problem_family result{.name = "values in print", .axes = {axis_of(values_to_choose())}};
    return result;
}

}  // namespace
}  // namespace published_study

const study& published() {
    using namespace published_study;
    static const study result{
        .name = "published",
        .title = "Published reference values",
        .question = "Are the values in print right, to the last digit?",
        .reading =
            "How far each printed value is from the proved one, in units of its last printed digit: what stands left "
            "of the line at 1 holds. The table has both, and the source.",
        .of = &values_in_print(),
        .parameters = {{"--values", "all", "which values"}},
        .quick = {{"--values", "blasius,van_der_pol_cycle,stiff_c5", ""}},
        .seconds = 60,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
