// How many correct digits of theta do Boost.Math and the GNU Scientific Library deliver near the separatrix? theta in double
// by a library that takes the modulus k, and by Libration from the exact gap, against proved values.
#include <fmt/format.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/pendulum/proved_theta.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "run/child_program.hpp"
#include "run/program_files.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace audit_study {

namespace {

// The input of a peer: an energy and a time, rounded to doubles.
struct audited_input {
    double k;
    double time;
};

// 2 asin(k cd(t, k)) in double for each input, in their order.
using audited_peer = std::function<std::vector<double>(const std::vector<audited_input>&)>;

constexpr long proved_places = 60;
constexpr long judged_digits = 6;
constexpr long digits_of_times = 50;

// One energy and one time: the peer's input, exactly and as doubles.
struct audit_case {
    const sweep_energy* at;
    const exact* asked;
    std::string time_text;  // dimensionless, exact if it is a finite decimal
    rational gap;
    double time;
    double k;
};

// E as a fraction, for an exact comparison with the double k.
const rational& fraction_of(const sweep_energy& at) {
    if (!at.value.is_fraction()) {
        throw input_error("--energies", at.value.text, "is not a decimal or a fraction",
                          "write energies such as 0.5,1.71,2.02, or gaps of the same form");
    }
    return at.value.coefficient;
}

audit_case case_of(const sweep_energy& at, const exact& time) {
    const precision_scope scope(proved_places);
    const rational& energy = fraction_of(at);
    const rational gap = 2 - energy;
    const pendulum::landen_motion motion(energy, gap);
    ball instant = from_exact<ball>(time.without_periods());
    if (time.has_periods()) {
        instant += pi<ball>() * from_rational<ball>(rational(time.periods() * 2)) / motion.mean();
    }
    const auto k = narrow<double>(mpfr(sqrt(from_rational<mpfr>(rational(energy / 2)))));
    const std::string text = time.measure == unit::period ? to_proved_decimal(instant, digits_of_times).value().text
                                                          : decimal_of(time, digits_of_times);
    return {&at, &time, text, gap, narrow<double>(midpoint_of(instant)), k};
}

// theta of the motion given by the double k, as an exact fraction: E = 2 k^2, which is at rest at the top if k was
// rounded to 1.
ball theta_of_received(const audited_input& given) {
    const rational k(given.k);
    const rational energy = k * k * 2;
    if (energy == 2) {
        const precision_scope scope(proved_places + 10);
        return pi<ball>();
    }
    return pendulum::proved_theta(energy, rational(2 - energy), rational(given.time), proved_places);
}

// The digits of an error, each proved.
cell proved_cell(const ball& x) {
    const auto text = to_proved_decimal(x, judged_digits);
    if (!text) {
        throw std::runtime_error("an error is below the proved places of the reference");
    }
    return cell::number(text->text, judged_digits);
}

// One value of one library and its error.
struct audit_row {
    const sweep_energy& at;
    const audit_case& of;
    std::string library;
    double theta;
    cell reference, error, error_ulp, correct_digits, condition, input_ulp, own_ulp;
};

const column_list<audit_row>& audit_columns() {
    using row = audit_row;
    static const column_list<row> all{
        gap_column<row>(),
        {"time", "dimensionless, as asked", [](const row& r) { return number_cell(r.of.time_text); }},
        {"library", "who computed theta; ours takes the exact gap, the other the nearest double of k = sqrt(E/2)",
         [](const row& r) { return r.library; }},
        {"theta", "the double that came out, radians",
         [](const row& r) { return number_cell(std::isfinite(r.theta) ? to_round_trip(r.theta) : "nan"); }},
        {"reference", "theta of the gap as typed at time_in_double, 25 proved digits",
         [](const row& r) { return r.reference; }},
        {"error", "|theta - reference|, proved digits", [](const row& r) { return r.error; }},
        {"error_ulp", "error in units of 2^-52 max(1, |reference|)", [](const row& r) { return r.error_ulp; }},
        {"correct_digits", "-log10 of error/max(1, |reference|)", [](const row& r) { return r.correct_digits; }},
        {"condition", "|d theta/dE| E/max(1, |theta|): units of theta for one unit of E",
         [](const row& r) { return r.condition; }},
        {"input_ulp", "what the library was not told: |theta of the k that it received - reference|, in the same units",
         [](const row& r) { return r.input_ulp; }},
        {"own_ulp", "what it did itself: |theta - theta of the k that it received|, in the same units",
         [](const row& r) { return r.own_ulp; }},
        {"time_in_double", "the double nearest to time, which both took",
         [](const row& r) { return number_cell(to_round_trip(r.of.time)); }},
        {"energy", "E, in units of m g l", [](const row& r) { return number_cell(r.at.energy); }},
        {"time_typed", "as typed", [](const row& r) { return cell(r.of.asked->text); }},
    };
    static const auto with_typed = with_typed_energy(all);
    return with_typed;
}

// `received` is theta for the k that was passed to the library; empty if it was given the gap itself.
audit_row judged_row(const audit_case& one, const std::string& library, double theta, const ball& reference,
                     const ball* received, const cell& condition) {
    const precision_scope scope(proved_places + 20);
    const ball size = certainly_less(abs(reference), ball(1)) ? ball(1) : abs(reference);
    const ball unit = ldexp(size, -52);
    const auto in_units = [&](const ball& difference) { return proved_cell(abs(difference) / unit); };
    audit_row row{*one.at,
                  one,
                  library,
                  theta,
                  cell::number(to_proved_decimal(reference, 25).value().text, 25),
                  number_cell("inf"),
                  number_cell("inf"),
                  number_cell("0"),
                  condition,
                  received == nullptr ? number_cell("0") : in_units(*received - reference),
                  number_cell("inf")};
    if (std::isfinite(theta)) {
        const ball value{widen(theta)};
        const ball error = abs(value - reference);
        row.error = proved_cell(error);
        row.error_ulp = in_units(error);
        row.correct_digits = decimal_cell(mpfr(-log10(midpoint_of(error / size))), 4);
        row.own_ulp = in_units(value - (received == nullptr ? reference : *received));
    }
    return row;
}

table judged_rows(const audit_case& one, const std::string& library, double theta) {
    const rational instant(one.time);
    const ball reference = pendulum::proved_theta(fraction_of(*one.at), one.gap, instant, proved_places);
    const ball received = theta_of_received({one.k, one.time});
    const cell condition =
        decimal_cell(pendulum::energy_condition(fraction_of(*one.at), one.gap, instant), judged_digits);
    const double ours =
        pendulum::exact_solution<double>(pendulum::motion::of_energy(one.at->value))(exactly(instant)).theta;
    return make_table(audit_columns(),
                      std::vector<audit_row>{judged_row(one, "libration", ours, reference, nullptr, condition),
                                             judged_row(one, library, theta, reference, &received, condition)});
}

// E = 0 and E >= 2, where there is no k below 1.
std::vector<without_answer> without_modulus() {
    auto excluded = no_answer_at_limits("the motion is the constant 0", "the motion has no period");
    excluded.push_back({"energy", [](const exact& energy) { return sign_of_exact(energy - exactly(2)) > 0; },
                        "2 asin(k cd) is not the solution"});
    return excluded;
}

// The values of a library in all cases of an audit, computed in one call when the first is needed.
class peer_answers {
public:
    peer_answers(audited_peer peer, std::vector<audit_case> cases) : peer_(std::move(peer)), cases_(std::move(cases)) {}

    const audit_case& of(std::size_t i) const { return cases_[i]; }
    std::size_t size() const { return cases_.size(); }
    double theta(std::size_t i) {
        std::call_once(asked_, [&] {
            std::vector<audited_input> inputs;
            inputs.reserve(cases_.size());
            for (const audit_case& one : cases_) {
                inputs.push_back({one.k, one.time});
            }
            thetas_ = peer_(inputs);
        });
        return thetas_[i];
    }

private:
    audited_peer peer_;
    std::vector<audit_case> cases_;
    std::once_flag asked_;
    std::vector<double> thetas_;
};

// The cells of an audit: each time at each energy.
study_plan plan_of_audit(const std::string& library, const audited_peer& peer, const study_request& request) {
    const auto sweep = sweep_of(request);
    std::vector<audit_case> cases;
    cases.reserve(sweep->energies.size() * sweep->times.size());
    for (const sweep_energy& at : sweep->energies) {
        for (const exact& time : sweep->times) {
            cases.push_back(case_of(at, time));
        }
    }
    const auto answers = std::make_shared<peer_answers>(peer, std::move(cases));
    return plan_of_cells(
        {head_of("", read_scalar("double"), audit_columns())}, {"energy", "gap", "time"}, answers->size(),
        [sweep, answers](std::size_t i) {
            return with_input(inputs_of(*answers->of(i).at), "time", answers->of(i).asked->text);
        },
        [sweep, answers, library](std::size_t i) {
            return std::vector<table>{judged_rows(answers->of(i), library, answers->theta(i))};
        });
}

std::vector<double> by_boost(const std::vector<audited_input>& inputs) {
    std::vector<double> thetas;
    thetas.reserve(inputs.size());
    for (const audited_input& given : inputs) {
        thetas.push_back(2 * std::asin(given.k * boost::math::jacobi_cd(given.k, given.time)));
    }
    return thetas;
}

// GSL is under the GPL, so it is called in a separate process. Throws input_error if that program was not built.
std::string gsl_program() {
    std::string path = peer_program("libration-gsl-theta");
    if (!std::filesystem::exists(path)) {
        throw input_error(
            "the study audit_gsl asks the GNU Scientific Library, whose program is not here: install it (Debian: "
            "apt-get install libgsl-dev), configure, build and install again");
    }
    return path;
}

std::vector<double> by_gsl(const std::vector<audited_input>& inputs) {
    std::string questions;
    for (const audited_input& given : inputs) {
        questions += fmt::format("{:a} {:a}\n", given.k, given.time);
    }
    std::istringstream answers(output_of_program(gsl_program(), questions));
    std::vector<double> thetas;
    thetas.reserve(inputs.size());
    for (std::string line; std::getline(answers, line);) {
        thetas.push_back(std::strtod(line.c_str(), nullptr));
    }
    if (thetas.size() != inputs.size()) {
        throw std::runtime_error(fmt::format("GSL returned {} of {} values", thetas.size(), inputs.size()));
    }
    return thetas;
}

// The study of a library.
study study_of(const std::string& library, const audited_peer& peer, const std::string& title,
               const std::string& question, const std::string& reading) {
    return {.name = "audit_" + library,
            .title = title,
            .question = question,
            .reading = reading,
            .of = &pendulum_problem(),
            .parameters = {{"--energies", "", "energies E below 2, in m g l"},
                           {"--gaps", "1:1e-15:46log", "energies as 2 - E"},
                           {"--times", "0.7,T/16,T/8,3T/16,10", "times since the top, in sqrt(l/g); multiples of T"}},
            .quick = {{"--gaps", "1,1e-12", ""}, {"--times", "0.7,T/8", ""}},
            .seconds = 1,
            .excluded = without_modulus(),
            .plan = [library, peer](const study_request& request) { return plan_of_audit(library, peer, request); },
            .script = "audit"};
}

}  // namespace
}  // namespace audit_study

const study& audit_boost() {
    using namespace audit_study;
    static const study result = study_of(
        "boost", by_boost, "Boost.Math, judged",
        "How many digits of theta does Boost.Math leave in double when the energy comes close to 2?",
        "Correct digits of theta (absolute where |theta| < 1) against the gap 2 - E, one panel a time. Circles: "
        "our own double from the exact gap, at most {{max error_ulp of audit_boost where library=libration to 2}} "
        "units in the last place of max(1, |theta|) off. "
        "Dots: Boost.Math from the nearest double of k = sqrt(E/2), by 2 asin(k cd(t, k)). Dashed: how far theta "
        "of that double is from the theta that was meant, so what no code can win back that takes k alone. Most of "
        "the loss is that: at a gap of 1e-15 and t = 3T/16 "
        "{{the correct_digits of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 2}} digits are "
        "left, and of {{the error_ulp of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 1}} lost "
        "units {{the own_ulp of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 2}} are of Boost's "
        "own making. Near the top it adds its own, up to "
        "{{max own_ulp of audit_boost where time=0.7 library=boost to 1}} units at t = 0.7, because the arcsine of "
        "a number next to 1 keeps half of its digits.");
    return result;
}

const study& audit_gsl() {
    using namespace audit_study;
    static const study result = study_of(
        "gsl", by_gsl, "The GNU Scientific Library, judged",
        "How many digits of theta does GSL leave in double when the energy comes close to 2?",
        "Correct digits of theta (absolute where |theta| < 1) against the gap 2 - E, one panel a time. Circles: "
        "our own double from the exact gap, at most {{max error_ulp of audit_gsl where library=libration to 2}} "
        "units in the last place of max(1, |theta|) off. "
        "Dots: GSL from the nearest double of k = sqrt(E/2), by 2 asin(k cd(t, k)). Dashed: how far theta of that "
        "double is from the theta that was meant, so what no code can win back that takes k alone. Most of the "
        "loss is that: at a gap of 1e-15 and t = 3T/16 "
        "{{the correct_digits of audit_gsl where gap=1e-15 time_typed=3T/16 library=gsl to 2}} digits are left. "
        "GSL adds its own, up to {{max own_ulp of audit_gsl where time=0.7 library=gsl to 2}} units at t = 0.7, "
        "where the arcsine of a number next to 1 keeps half of its digits, and at gaps about 2e-8, up to "
        "{{max own_ulp of audit_gsl where time=10 library=gsl to 1}} units at t = 10, where Boost.Math loses "
        "{{max own_ulp of audit_boost where time=10 library=boost to 1}} at most.");
    return result;
}

}  // namespace libration::studies
