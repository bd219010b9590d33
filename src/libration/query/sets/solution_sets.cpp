#include "libration/query/sets/solution_sets.hpp"

#include <utility>

#include "../../equation/bound_text.hpp"
#include "box_faces.hpp"
#include "set_run.hpp"
#include "subdivision.hpp"

namespace libration::ode {

namespace {

// The spans, and behind them the times of their ends, where excess is measured.
std::vector<time_span> with_ends(const std::vector<time_span>& spans) {
    std::vector<time_span> all = spans;
    for (const time_span& each : spans) {
        if ((each.to - each.from).sign() != 0) {
            all.insert(all.end(), {at_time(each.from), at_time(each.to)});
        }
    }
    return all;
}

error end_of(const subdivision& box, const set_problem& of, const time_span& missing) {
    const set_run_result& first = *box.first_end();
    const number& time = first.forward ? missing.to : missing.from;
    std::string reason = text_of_reach(first.reached, first.begins, first.forward);
    if (!of.sets().empty()) {
        reason += ", and the enclosure ends first" + text_of_part(box.box_of_first_end(), of.sets(), box.parts()) +
                  (first.begins       ? ": choose earlier times, narrower intervals or more parts"
                   : first.may_divide ? ": choose narrower intervals or more parts"
                                      : ": choose narrower intervals");
    }
    return {error_kind::undecided, error_subject::time, text_of_time(time), reason};
}

}  // namespace

set_enclosures enclosed_solutions(const equation_system& given, const set_request& asked, const march_watch& watch,
                                  const proof_route& route) {
    const set_problem problem(given);
    const long bits = bits_of_sets(problem, asked.digits);
    const precision_scope scope(decimal_digits(bits));
    const bool with_derivatives = !problem.sets().empty();
    const span_question question(problem, with_ends(asked.spans), bits, watch, route);
    const subdivision divided(problem.box(), question, with_derivatives, asked.most_parts);
    box_faces faces(divided.whole(), question);
    set_enclosures result;
    result.names = problem.names();
    result.parts = divided.parts();
    for (std::size_t i = 0; i < asked.spans.size(); ++i) {
        auto known = divided.images()[i];
        if (!known) {
            result.values.emplace_back();
            if (!result.missing) {
                result.missing = end_of(divided, problem, asked.spans[i]);
            }
            continue;
        }
        if (with_derivatives) {
            faces.narrow(*known, i);
        }
        result.values.push_back(problem.all_values(known->values));
    }
    result.faces = faces.size();
    result.steps = divided.steps() + faces.steps();
    return result;
}

}  // namespace libration::ode
