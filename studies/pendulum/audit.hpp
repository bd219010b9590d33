// theta in double by a library that takes the modulus k, and by Libration from the exact gap, against proved values.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../shared/sweep_columns.hpp"
#include "../shared/sweep_plan.hpp"
#include "libration/pendulum/proved_theta.hpp"

#include "libration/pendulum/exact_solution.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

/// The input of a peer: an energy and a time, rounded to doubles.
struct audited_input {
    double k;
    double time;
};

/// 2 asin(k cd(t, k)) in double for each input, in their order.
using audited_peer = std::function<std::vector<double>(const std::vector<audited_input>&)>;

inline constexpr long proved_places = 60;
inline constexpr long judged_digits = 6;
inline constexpr long digits_of_times = 50;

/// One energy and one time: the peer's input, exactly and as doubles.
struct audit_case {
    const sweep_energy* at;
    const exact* asked;
    std::string time_text;  // dimensionless, exact if it is a finite decimal
    rational gap;
    double time;
    double k;
};

/// E as a fraction, for an exact comparison with the double k.
inline const rational& fraction_of(const sweep_energy& at) {
    if (!at.value.is_fraction()) {
        throw input_error("--energies", at.value.text, "is not a decimal or a fraction",
                          "write energies such as 0.5,1.71,2.02, or gaps of the same form");
    }
    return at.value.coefficient;
}

inline audit_case case_of(const sweep_energy& at, const exact& time) {
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

/// theta of the motion given by the double k, as an exact fraction: E = 2 k^2, which is at rest at the top if k was
/// rounded to 1.
inline ball theta_of_received(const audited_input& given) {
    const rational k(given.k);
    const rational energy = k * k * 2;
    if (energy == 2) {
        const precision_scope scope(proved_places + 10);
        return pi<ball>();
    }
    return pendulum::proved_theta(energy, rational(2 - energy), rational(given.time), proved_places);
}

/// The digits of an error, each proved.
inline cell proved_cell(const ball& x) {
    const auto text = to_proved_decimal(x, judged_digits);
    if (!text) {
        throw std::runtime_error("an error is below the proved places of the reference");
    }
    return cell::number(text->text, judged_digits);
}

/// One value of one library and its error.
struct audit_row {
    const sweep_energy& at;
    const audit_case& of;
    std::string library;
    double theta;
    cell reference, error, error_ulp, correct_digits, condition, input_ulp, own_ulp;
};

inline const column_list<audit_row>& audit_columns() {
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
inline audit_row judged_row(const audit_case& one, const std::string& library, double theta, const ball& reference,
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

inline table judged_rows(const audit_case& one, const std::string& library, double theta) {
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

/// E = 0 and E >= 2, where there is no k below 1.
inline std::vector<without_answer> without_modulus() {
    auto excluded = no_answer_at_limits("the motion is the constant 0", "the motion has no period");
    excluded.push_back({"energy", [](const exact& energy) { return sign_of_exact(energy - exactly(2)) > 0; },
                        "2 asin(k cd) is not the solution"});
    return excluded;
}

/// The values of a library in all cases of an audit, computed in one call when the first is needed.
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

/// The cells of an audit: each time at each energy.
inline study_plan plan_of_audit(const std::string& library, const audited_peer& peer, const study_request& request) {
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

inline std::vector<study_parameter> audit_parameters() {
    return {{"--energies", "", "energies E below 2, in m g l"},
            {"--gaps", "1:1e-15:46log", "energies as 2 - E"},
            {"--times", "0.7,T/16,T/8,3T/16,10", "times since the top, in sqrt(l/g); multiples of T"}};
}

inline std::vector<study_parameter> quick_audit() { return {{"--gaps", "1,1e-12", ""}, {"--times", "0.7,T/8", ""}}; }

}  // namespace libration::studies
