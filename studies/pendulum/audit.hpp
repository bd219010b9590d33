// theta in double by a library that takes the modulus k, and by ours from the exact gap, judged against proved values.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "libration/pendulum/proved/proved_theta.hpp"

#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "run/parallel.hpp"
#include "sweep/study.hpp"

namespace libration::studies {

/// What a peer is given: the doubles that are left of an energy and a time.
struct audited_input {
    double k;
    double time;
};

/// 2 asin(k cd(t, k)) in double for each input, in their order.
using audited_peer = std::function<std::vector<double>(const std::vector<audited_input>&)>;

inline constexpr long proved_places = 60;
inline constexpr long judged_digits = 6;

inline const std::vector<column>& audit_columns() {
    static const std::vector<column> all{
        {"gap", "2 - E, in units of m g l"},
        {"time", "as asked"},
        {"library", "who computed theta; ours takes the exact gap, the other the nearest double of k = sqrt(E/2)"},
        {"theta", "the double that came out, radians"},
        {"reference", "theta of the gap as typed at time_in_double, 25 proved digits"},
        {"error", "|theta - reference|, proved digits"},
        {"error_ulp", "error in units of 2^-52 max(1, |reference|)"},
        {"correct_digits", "-log10 of error/max(1, |reference|)"},
        {"condition", "|d theta/dE| E/max(1, |theta|): units of theta for one unit of E"},
        {"input_ulp",
         "what the library was not told: |theta of the k that it received - reference|, in the same units"},
        {"own_ulp", "what it did itself: |theta - theta of the k that it received|, in the same units"},
        {"time_in_double", "the double nearest to time, which both took"},
        {"energy", "E, in units of m g l"},
    };
    return all;
}

/// One energy and one time: what the peer gets, exactly and as doubles.
struct audit_case {
    const sweep_energy* at;
    std::string time_text;
    rational gap;
    double time;
    double k;
};

inline audit_case case_of(const sweep_energy& at, const exact& time) {
    const precision_scope scope(proved_places);
    const rational gap = 2 - at.value;
    const landen_motion motion(at.value, gap);
    const ball instant = time.measure == unit::period
                             ? ball(pi<ball>() * from_rational<ball>(rational(time.coefficient * 2)) / motion.mean())
                             : from_exact<ball>(time);
    const auto k = narrow<double>(mpfr(sqrt(from_rational<mpfr>(rational(at.value / 2)))));
    return {&at, time.text, gap, narrow<double>(midpoint_of(instant)), k};
}

/// theta of the motion that the double k means, as an exact fraction: E = 2 k^2, which is at rest on top where k was
/// rounded to 1.
inline ball theta_of_received(const audited_input& given) {
    const rational k(given.k);
    const rational energy = k * k * 2;
    if (energy == 2) {
        const precision_scope scope(proved_places + 10);
        return pi<ball>();
    }
    return proved_theta(energy, rational(2 - energy), rational(given.time), proved_places);
}

/// The digits of an error, each proved.
inline std::string proved_text(const ball& x) {
    const auto text = to_proved_decimal(x, judged_digits);
    if (!text) {
        throw std::runtime_error("an error is below the proved places of the reference");
    }
    return text->text;
}

// `received` is theta of the k that the library was given; none where it was given the gap itself.
inline std::vector<std::string> judged_row(const audit_case& one, const std::string& library, double theta,
                                           const ball& reference, const ball* received, const std::string& condition) {
    const precision_scope scope(proved_places + 20);
    const ball size = certainly_less(abs(reference), ball(1)) ? ball(1) : abs(reference);
    const ball unit = ldexp(size, -52);
    std::vector<std::string> row{one.at->gap, one.time_text, library,
                                 std::isfinite(theta) ? to_round_trip(theta) : std::string("nan"),
                                 to_proved_decimal(reference, 25).value().text};
    const auto in_units = [&](const ball& difference) { return proved_text(abs(difference) / unit); };
    const std::string input = received == nullptr ? "0" : in_units(*received - reference);
    if (std::isfinite(theta)) {
        const ball value{widen(theta)};
        const ball error = abs(value - reference);
        const mpfr digits = -log10(midpoint_of(error / size));
        row.insert(row.end(), {proved_text(error), in_units(error), to_decimal(digits, 4), condition, input,
                               in_units(value - (received == nullptr ? reference : *received))});
    } else {
        row.insert(row.end(), {"inf", "inf", "0", condition, input, "inf"});
    }
    row.insert(row.end(), {to_round_trip(one.time), one.at->energy});
    return row;
}

inline std::vector<std::vector<std::string>> judged_rows(const audit_case& one, const std::string& library,
                                                         double theta) {
    const rational instant(one.time);
    const ball reference = proved_theta(one.at->value, one.gap, instant, proved_places);
    const ball received = theta_of_received({one.k, one.time});
    const std::string condition = to_decimal(energy_condition(one.at->value, one.gap, instant), judged_digits);
    const double ours = exact_solution<double>(motion::of_energy(one.at->value))(exactly(instant)).theta;
    return {judged_row(one, "libration", ours, reference, nullptr, condition),
            judged_row(one, library, theta, reference, &received, condition)};
}

/// The table of an audit. Throws error for E = 0 and E >= 2, where there is no k below 1.
inline std::vector<study_table> run_audit(const std::string& name, const std::string& library, const audited_peer& peer,
                                          const study_request& request) {
    refuse_limits(request.energies, "the motion is the constant 0", "the motion has no period");
    std::vector<audit_case> cases;
    cases.reserve(request.energies.size() * request.times.size());
    for (const sweep_energy& at : request.energies) {
        if (at.value > 2) {
            throw error(error_kind::argument, "energies", "",
                        "has the energy " + at.energy + ", where 2 asin(k cd) is not the solution");
        }
        for (const exact& time : request.times) {
            cases.push_back(case_of(at, time));
        }
    }
    std::vector<audited_input> inputs;
    inputs.reserve(cases.size());
    for (const audit_case& one : cases) {
        inputs.push_back({one.k, one.time});
    }
    const std::vector<double> thetas = peer(inputs);
    progress shown(name + ", values", cases.size(), request.shown);
    const auto rows = parallel_map(cases.size(), request.jobs, shown,
                                   [&](std::size_t i) { return judged_rows(cases[i], library, thetas[i]); });
    study_table result{"", read_scalar("double"), {audit_columns(), {}}};
    result.data.rows.reserve(rows.size() * 2);
    for (const auto& of_case : rows) {
        result.data.rows.insert(result.data.rows.end(), of_case.begin(), of_case.end());
    }
    return {std::move(result)};
}

inline std::vector<study_parameter> audit_parameters() {
    return {{"--energies", "", "energies E below 2, in m g l"},
            {"--gaps", "1:1e-15:46log", "energies as 2 - E"},
            {"--times", "0.7,T/16,T/8,3T/16,10", "times since the top, in sqrt(l/g); multiples of T"}};
}

inline std::vector<study_parameter> quick_audit() { return {{"--gaps", "1,1e-12", ""}, {"--times", "0.7,T/8", ""}}; }

}  // namespace libration::studies
