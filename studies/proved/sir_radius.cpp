// Where are the nearest singularities of the SIR epidemic, over all of its parameters, and what does a root test find?
#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/problem/problem_family.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/constants.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

namespace sir_radius_study {

namespace {

constexpr long quadrature_digits = 30;
constexpr long printed_digits = 15;
constexpr long proof_digits = 8;

// S' = -S I, I' = S I - I: every SIR epidemic in units of 1/a of time and a/r of people.
ode::explicit_system epidemic(const exact& reproduction, const exact& infected) {
    return ode::explicit_system(ode::parse("S' = -S*I; I' = S*I - I; S(0) = " + reproduction.coefficient.str() +
                                           "; I(0) = " + infected.coefficient.str()));
}

// t_s = -int du/J(u), J(u) = i + s (1 - e^u) + u, from 0 to i pi and then to i pi + infinity, where Im J = pi.
complex_number<mpfr> place_by_quadrature(const exact& reproduction, const exact& infected) {
    const precision_scope scope(quadrature_digits);
    const mpfr s = from_exact<mpfr>(reproduction);
    const mpfr i = from_exact<mpfr>(infected);
    const mpfr half_turn = pi<mpfr>();
    // 1/J on the vertical part, times i; and on the horizontal part, where e^u = -e^x.
    const auto up = [&](const mpfr& y) {
        const complex_number<mpfr> j{mpfr(i + s - s * cos(y)), mpfr(y - s * sin(y))};
        return complex_number<mpfr>{mpfr(0), mpfr(1)} / j;
    };
    const auto out = [&](const mpfr& x) {
        const complex_number<mpfr> j{mpfr(i + s + s * exp(x) + x), half_turn};
        return complex_number<mpfr>(mpfr(1)) / j;
    };
    boost::math::quadrature::tanh_sinh<mpfr> finite;
    boost::math::quadrature::exp_sinh<mpfr> infinite;
    const auto whole = [&](const auto& part) {
        return mpfr(-finite.integrate([&](const mpfr& y) { return part(up(y)); }, mpfr(0), half_turn) -
                    infinite.integrate([&](const mpfr& x) { return part(out(x)); }));
    };
    return {whole([](const complex_number<mpfr>& z) { return z.re; }),
            whole([](const complex_number<mpfr>& z) { return z.im; })};
}

// The time of the maximum of the infected: s(t) = 1, t = int from u = -log s of -du/J.
mpfr time_of_peak(const exact& reproduction, const exact& infected) {
    const precision_scope scope(quadrature_digits);
    const mpfr s = from_exact<mpfr>(reproduction);
    const mpfr i = from_exact<mpfr>(infected);
    if (s <= 1) {
        return mpfr(0);
    }
    boost::math::quadrature::tanh_sinh<mpfr> finite;
    return finite.integrate([&](const mpfr& u) { return mpfr(1 / (i + s - s * exp(mpfr(-u)) - u)); }, mpfr(0),
                            mpfr(log(s)));
}

struct sir_row {
    std::string reproduction, infected;
    complex_number<mpfr> place;
    mpfr radius, peak;
    std::string lower, upper, verdict;
};

const column_list<sir_row>& columns() {
    using row = sir_row;
    static const column_list<row> all{
        {"reproduction", "r S(0)/a, by how many an infected person infects at first",
         [](const row& r) { return number_cell(r.reproduction); }},
        {"infected", "r I(0)/a at the start", [](const row& r) { return number_cell(r.infected); }},
        {"radius", "of convergence in units of 1/a: |t_s| of the first strip, by quadrature",
         [](const row& r) { return decimal_cell(r.radius, printed_digits); }},
        {"position_re", "t_s, real part", [](const row& r) { return decimal_cell(r.place.re, printed_digits); }},
        {"position_im", "imaginary part",
         [](const row& r) { return decimal_cell(mpfr(abs(r.place.im)), printed_digits); }},
        {"peak", "time at which the infected are most; 0 where they decrease from the start",
         [](const row& r) { return decimal_cell(r.peak, printed_digits); }},
        {"lower", "bound of the radius, proved", [](const row& r) { return number_cell(r.lower); }},
        {"upper", "bound of the radius, proved", [](const row& r) { return number_cell(r.upper); }},
        {"verdict", "whether the quadrature lies between them", [](const row& r) { return r.verdict; }},
    };
    return all;
}

sir_row row_of(const exact& reproduction, const exact& infected) {
    sir_row row{decimal_of(reproduction, printed_digits), decimal_of(infected, printed_digits), {}, {}, {}, "", "", ""};
    const precision_scope scope(quadrature_digits);
    row.place = place_by_quadrature(reproduction, infected);
    row.radius = modulus_of(row.place);
    row.peak = time_of_peak(reproduction, infected);
    const auto proved = ode::prove_radius(epidemic(reproduction, infected), proof_digits);
    const mpfr lower = midpoint_of(proved.lower);
    const mpfr upper = midpoint_of(proved.upper);
    row.lower = parts_of(lower, proof_digits + 2, MPFR_RNDD).text();
    row.upper = parts_of(upper, proof_digits + 2, MPFR_RNDU).text();
    row.verdict = lower <= row.radius && row.radius <= upper ? "holds" : "fails";
    return row;
}

study_plan plan(const study_request& request) {
    struct pair_of_values {
        exact reproduction, infected;
    };
    std::vector<pair_of_values> all;
    for (const exact& s : request.values.of("reproduction")) {
        for (const exact& i : request.values.of("infected")) {
            all.push_back({s, i});
        }
    }
    return plan_of_cells(
        {head_of("", {scalar_kind::proved, proof_digits}, columns())}, {"reproduction", "infected"}, all.size(),
        [all](std::size_t k) {
            return cell_inputs{{"reproduction", decimal_of(all[k].reproduction, printed_digits)},
                               {"infected", decimal_of(all[k].infected, printed_digits)}};
        },
        [all](std::size_t k) {
            return std::vector<table>{
                make_table(columns(), std::vector<sir_row>{row_of(all[k].reproduction, all[k].infected)})};
        });
}

void require_positive(const exact& value) {
    require_plain_number(value);
    if (!(value.coefficient > 0)) {
        throw error(error_kind::argument, "list", "", "has '" + value.text + "', which is not above 0");
    }
}

axis axis_named(const std::string& name, const std::string& help) {
    return {.name = name,
            .option = "--" + name,
            .help = help,
            .form = axis_form::numbers,
            .remedy = "write numbers above 0 such as 1/2,1,2 or 1/2:8:9log",
            .check = require_positive,
            .coordinate = name};
}

const problem_family& epidemics() {
    static const problem_family result{"SIR epidemics",
                                       {axis_named("reproduction", "r S(0)/a"), axis_named("infected", "r I(0)/a")}};
    return result;
}

}  // namespace
}  // namespace sir_radius_study

const study& sir_radius() {
    using namespace sir_radius_study;
    static const study result{
        .name = "sir_radius",
        .title = "The radius of convergence of SIR",
        .question = "Where are the nearest singularities of an SIR epidemic, for all of its parameters?",
        .reading =
            "In units of 1/a of time and a/r of people an epidemic has two parameters: the reproduction number at the "
            "start and the infected. The radius of convergence about the start is a quadrature, and for each point of "
            "the map it lies between proved bounds that agree to 8 digits. Where the dashed line is crossed the radius "
            "is the time of the peak: to the left of it one series from the start reaches the peak of the epidemic, to "
            "the right it does not. No series of this kind reaches all times: the singularities stay at a finite "
            "distance.",
        .of = &epidemics(),
        .parameters = {{"--reproduction", "1/2,1,3/2,2,3,4,6,8", "r S(0)/a"},
                       {"--infected", "1/1000,1/100,1/10,1,10", "r I(0)/a"}},
        .quick = {{"--reproduction", "2", ""}, {"--infected", "1/10", ""}},
        .seconds = 60,
        .plan = plan,
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
