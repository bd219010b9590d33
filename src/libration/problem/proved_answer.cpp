#include "libration/problem/proved_answer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

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

}  // namespace

answer_value value_in_answer(const ode::known_value& value) {
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
