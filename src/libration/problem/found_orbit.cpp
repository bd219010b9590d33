// Periodic orbits as answers.
#include <optional>

#include "found_values.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"

namespace libration {

namespace {

// A bound is kept as 0 with that uncertainty.
found_values values_of_orbit(const ode::periodic_orbit& orbit) {
    found_values found{orbit.names, orbit.start};
    found.names.emplace_back("period");
    found.values.push_back(orbit.period);
    const auto add = [&](const std::string& name, const known_value& value) {
        found.names.push_back(name);
        found.values.push_back(value.decimal ? *value.decimal : proved_decimal{"0", value.bound});
    };
    for (std::size_t k = 0; k < orbit.multipliers.size(); ++k) {
        const auto& each = orbit.multipliers[k];
        const std::string name = "multiplier " + std::to_string(k + 1);
        add(each.is_real ? name : name + ", real part", each.real);
        if (!each.is_real) {
            add(name + ", imaginary part", each.imaginary);
        }
    }
    return found;
}

std::string joined_by_commas(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& each : names) {
        all += (all.empty() ? "" : ", ") + each;
    }
    return all;
}

std::string text_of_stability(const ode::periodic_orbit& orbit) {
    switch (orbit.stability) {
        case ode::orbit_stability::attracting:
            return "orbitally asymptotically stable: all multipliers but one are less than 1 in absolute value";
        case ode::orbit_stability::on_circle:
            return "linearly stable up to the multipliers that are exactly 1: all others are simple and of absolute "
                   "value 1; stability of the nonlinear equations does not follow";
        case ode::orbit_stability::unstable: return "unstable: a multiplier is greater than 1 in absolute value";
        case ode::orbit_stability::undecided: break;
    }
    return "not decided by the multipliers";
}

// Nothing for an isolated orbit without further questions.
std::vector<answer_note> notes_of_orbit(const ode::periodic_orbit& orbit, const ode::orbit_question& question) {
    std::vector<answer_note> notes;
    if (!orbit.held.empty()) {
        notes.push_back({"given", "the orbit is one of a family; kept as given: " + joined_by_commas(orbit.held)});
    }
    if (orbit.by_reversal) {
        notes.push_back({"symmetry", "proved at half the period, by a reversal of time"});
    }
    for (const std::string& each : orbit.integrals) {
        notes.push_back({"integral", each});
    }
    if (notes.empty() && !question.multipliers && !question.period) {
        return notes;
    }
    notes.push_back({"period", orbit.is_shortest_period ? "no shorter time is a period"
                                                        : "whether a shorter time is a period is not proved"});
    for (std::size_t k = 0; k < orbit.multipliers.size(); ++k) {
        if (!orbit.multipliers[k].reason.empty()) {
            notes.push_back({"multiplier " + std::to_string(k + 1), "exactly 1, by " + orbit.multipliers[k].reason});
        }
    }
    if (question.multipliers) {
        notes.push_back({"stability", text_of_stability(orbit)});
    }
    return notes;
}

}  // namespace

ode::number typed_period(const ode::equation_system& of, const std::string& typed) {
    const auto refuse = [&](const std::string& reason) { throw error(error_kind::argument, "period", typed, reason); };
    const ode::expression period = ode::parse_condition(of, typed + " = 0");
    if (period.kind() != ode::node_kind::constant) {
        refuse("is not constant");
    }
    if (period.constant().sign() <= 0) {
        refuse("is not positive");
    }
    return period.constant();
}

answer find_periodic_orbit(const problem& of, const request& how, const orbit_options& options) {
    const ode::explicit_system system(of.equations());
    ode::orbit_question question{how.printed_digits(), std::nullopt, options.multipliers};
    if (!options.period.empty()) {
        question.period = typed_period(of.equations(), options.period);
    }
    std::optional<ode::periodic_orbit> first;
    answer result = found_by(how, [&](long digits, const ode::proof_route& route) {
        question.digits = digits;
        const auto orbit = ode::proved_periodic_orbit(system, question, route, watch_of(how));
        if (!first) {
            first = orbit;
        }
        return values_of_orbit(orbit);
    });
    for (auto& row : result.rows) {
        if (row.back().text == "0" && row.back().bound != "0") {
            row.back().text = "";  // only a bound is known
        }
    }
    result.notes = notes_of_orbit(*first, question);
    return result;
}

}  // namespace libration
