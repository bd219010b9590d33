#include "libration/query/sets/set_events.hpp"

#include <utility>

#include "box_faces.hpp"
#include "event_question.hpp"
#include "subdivision.hpp"

namespace libration::ode {

namespace {

error end_of(const subdivision& box, const set_problem& of, std::size_t event) {
    return {error_kind::undecided, "event", std::to_string(event),
            box.first_end()->reason + text_of_part(box.box_of_first_end(), of.sets(), box.parts())};
}

}  // namespace

set_events enclosed_events(const equation_system& given, const set_event_request& asked, const march_watch& watch,
                           const proof_route& route) {
    const set_problem problem(given, asked.condition);
    const long bits = bits_of_sets(problem, asked.digits);
    const precision_scope scope(decimal_digits(bits));
    const bool with_derivatives = !problem.sets().empty();
    const event_question question(problem, asked, bits, watch, route);
    const subdivision divided(problem.box(), question, with_derivatives, asked.most_parts);
    box_faces faces(divided.whole(), question);
    set_events result;
    result.names = problem.names();
    result.parts = divided.parts();
    for (std::size_t k = 0; k < divided.images().size(); ++k) {
        auto known = divided.images()[k];
        if (!known) {
            result.missing = end_of(divided, problem, k + 1);
            break;
        }
        if (with_derivatives) {
            faces.narrow(*known, k);
        }
        const std::vector<closed_interval> of_own(known->values.begin() + 1, known->values.end());
        result.events.push_back({known->values.front(), problem.all_values(of_own)});
    }
    result.faces = faces.size();
    result.steps = divided.steps() + faces.steps();
    return result;
}

}  // namespace libration::ode
