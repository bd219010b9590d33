#include "libration/problem/proved_answer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libration/number/two_proofs.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/states.hpp"

namespace libration {

namespace {

constexpr const char* rigour_of_proofs = "proved";

// Where a relation as written decides, for solutions that remain on a switching surface.
std::vector<answer_note> notes_of_relations(const std::vector<std::string>& by_relation) {
    std::vector<answer_note> notes;
    for (const std::string& each : by_relation) {
        notes.push_back({"relation", "the two sides of `" + each +
                                         "` remain equal for some time, in which the relation as written decides"});
    }
    return notes;
}

void require_agreement_of(const ode::known_value& a, const ode::known_value& b, const std::string& what) {
    if (a.decimal && b.decimal) {
        require_agreement(*a.decimal, *b.decimal, what);
    }
}

void require_same_events(const std::vector<std::string>& quantities, const std::vector<ode::known_event>& first,
                         const ode::event_report& second) {
    if (second.events.size() < first.size()) {
        throw error(second.missing.value());
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        const std::string event = " of event " + std::to_string(i + 1);
        require_agreement_of(first[i].time, second.events[i].time, "the time" + event);
        for (std::size_t j = 0; j < quantities.size(); ++j) {
            require_agreement_of(first[i].values[j], second.events[i].values[j], quantities[j] + event);
        }
    }
}

}  // namespace

answer_value value_in_answer(const known_value& value) {
    return value.decimal ? answer_value{value.decimal->text, value.decimal->uncertainty}
                         : answer_value{"", value.bound};
}

answer answer_of(std::vector<std::string> names, const ode::partial_trajectory& found) {
    answer result{.names = std::move(names), .rows = {}, .rigour = rigour_of_proofs};
    for (const auto& state : found.states) {
        std::ranges::transform(state, std::back_inserter(result.rows.emplace_back()), value_in_answer);
    }
    result.missing = found.missing;
    result.collocation = found.collocation;
    result.notes = notes_of_relations(found.by_relation);
    return result;
}

answer events_by(const std::vector<std::string>& quantities, const request& how, const ode::event_watch& watch,
                 const event_searcher& search) {
    const auto checked = checked_products(how.check);
    ode::proof_route route;
    route.integrator = how.integrator;
    const ode::event_report found = search(how.printed_digits(), route, watch);
    if (how.check && !found.events.empty()) {
        require_same_events(
            quantities, found.events,
            search(how.printed_digits() + ode::more_digits_of_second_proof, ode::proof_route::second(), {}));
    }
    return answer_of(quantities, found);
}

answer answer_of(const std::vector<std::string>& quantities, const ode::event_report& found) {
    answer result{.names = {"time"}, .rows = {}, .rigour = rigour_of_proofs};
    result.names.insert(result.names.end(), quantities.begin(), quantities.end());
    for (const ode::known_event& event : found.events) {
        auto& row = result.rows.emplace_back();
        row.push_back(value_in_answer(event.time));
        std::ranges::transform(event.values, std::back_inserter(row), value_in_answer);
    }
    result.missing = found.missing;
    result.collocation = found.collocation;
    result.notes = notes_of_relations(found.by_relation);
    return result;
}

}  // namespace libration
