#include "libration/ode/proved/solution_sets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "../needed_bits.hpp"
#include "divided_box.hpp"

namespace libration::ode {

namespace {

// The bits of the solutions beyond those that distinguish the ends of the narrowest interval.
constexpr long bits_below_the_box = 64;
// The most faces of a box that are enclosed.
constexpr std::size_t most_faces = 256;

// Of the ends of the intervals, to measure their widths; doubled until it suffices.
constexpr long first_bits_of_box = 256;

// log2 of the ends of the narrowest interval, relative to its width; std::nullopt if no interval has one.
std::optional<double> narrowness_of(const set_problem& of) {
    std::optional<double> most;
    const number_box box = of.box();
    for (std::size_t j = 0; j < box.size(); ++j) {
        if (of.is_wide(j)) {
            const magnitude size = std::max(magnitude(box[j].lower), magnitude(box[j].upper));
            most = std::max(most.value_or(0), log_of(size) - log_of(radius_of(box[j])));
        }
    }
    return most;
}

long bits_of_sets(const set_problem& of, long digits) {
    for (long bits = first_bits_of_box; bits <= most_bits; bits *= 2) {
        const precision_scope scope(decimal_digits(bits));
        const auto narrowness = narrowness_of(of);
        if (!narrowness) {
            return bits_of_digits(digits) + first_guard_bits;
        }
        if (*narrowness < static_cast<double>(bits) / 2) {
            return static_cast<long>(std::ceil(*narrowness)) + bits_below_the_box;
        }
    }
    throw error(error_kind::undecided, "problem", "",
                "has an interval that a million bits do not distinguish from a number");
}

std::string text_of_box(const number_box& box, const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t j = 0; j < box.size(); ++j) {
        text += (j == 0 ? "" : ", ") + names[j] + " in " + "[" + bound_text(box[j].lower, MPFR_RNDD) + ", " +
                bound_text(box[j].upper, MPFR_RNDU) + "]";
    }
    return text;
}

// The bounds of a value that is monotone in some numbers of a box: the solutions from a face of it, where each of these
// is at an end.
class box_faces {
public:
    box_faces(const number_box& whole, const set_run_request& how) : whole_(whole), how_(how) {}

    // Narrows what is known of a span.
    void narrow(enclosed_span& known, std::size_t span) {
        for (std::size_t k = 0; k < known.values.size(); ++k) {
            closed_interval& value = known.values[k];
            if (const auto* const lowest = value_on(known.derivatives[k], -1, span, k);
                lowest != nullptr && exactly_less(value.lower, lowest->lower)) {
                value.lower = lowest->lower;
            }
            if (const auto* const highest = value_on(known.derivatives[k], 1, span, k);
                highest != nullptr && exactly_less(highest->upper, value.upper)) {
                value.upper = highest->upper;
            }
        }
    }

    std::size_t size() const { return runs_.size(); }
    long steps() const { return steps_; }

private:
    // The enclosure of a value on the face that contains its lowest (side -1) or highest (1) value; null if it is
    // monotone in no number, or that face is not enclosed.
    const closed_interval* value_on(const std::vector<ball>& derivatives, int side, std::size_t span,
                                    std::size_t value) {
        std::vector<int> ends;
        bool any = false;
        for (std::size_t j = 0; j < whole_.size(); ++j) {
            const int direction = direction_of(derivatives[j]);
            ends.push_back(!has_width(whole_[j]) || direction == 2 ? -1 : direction * side);
            any = any || (has_width(whole_[j]) && ends.back() != 0);
        }
        if (!any || (runs_.size() == most_faces && !runs_.contains(ends))) {
            return nullptr;
        }
        const auto& enclosed = run_on(ends).spans[span];
        return enclosed ? &enclosed->values[value] : nullptr;
    }

    const set_run_result& run_on(const std::vector<int>& ends) {
        const auto known = runs_.find(ends);
        if (known != runs_.end()) {
            return known->second;
        }
        number_box face = whole_;
        for (std::size_t j = 0; j < face.size(); ++j) {
            if (ends[j] != 0) {
                const ball end = ends[j] < 0 ? face[j].lower : face[j].upper;
                face[j] = {end, end};
            }
        }
        set_run_request how = how_;
        how.with_derivatives = false;
        const auto& made = runs_.emplace(ends, enclosed_from(face, how)).first->second;
        steps_ += made.steps;
        return made;
    }

    const number_box& whole_;
    const set_run_request& how_;
    std::map<std::vector<int>, set_run_result> runs_;  // by the end of each number, 0 for the whole side
    long steps_ = 0;
};

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

error end_of(const divided_box& box, const set_problem& of, const time_span& missing) {
    const set_run_result& first = *box.first_end();
    const number& time = first.forward ? missing.to : missing.from;
    std::string reason = "is not reached by every solution: all of them are proved to exist up to " +
                         proved_reach_text(first.reached, first.forward);
    if (!of.sets().empty()) {
        reason += ", and the enclosure ends first for " + text_of_box(box.box_of_first_end(), of.sets()) + ", one of " +
                  std::to_string(box.parts()) + " parts: choose earlier times, narrower intervals or more parts";
    }
    return {error_kind::undecided, "time", text_of_time(time), reason};
}

}  // namespace

set_enclosures enclosed_solutions(const equation_system& given, const set_request& asked, const march_watch& watch,
                                  const proof_route& route) {
    const set_problem problem(given);
    const long bits = bits_of_sets(problem, asked.digits);
    const precision_scope scope(decimal_digits(bits));
    const auto spans = with_ends(asked.spans);
    const set_run_request how{problem, spans, bits, !problem.sets().empty(), watch, route};
    const divided_box divided(problem.box(), how, asked.most_parts);
    box_faces faces(divided.whole(), how);
    set_enclosures result;
    result.names = problem.names();
    result.parts = divided.parts();
    for (std::size_t i = 0; i < asked.spans.size(); ++i) {
        auto known = divided.spans()[i];
        if (!known) {
            result.values.emplace_back();
            if (!result.missing) {
                result.missing = end_of(divided, problem, asked.spans[i]);
            }
            continue;
        }
        if (how.with_derivatives) {
            faces.narrow(*known, i);
        }
        result.values.push_back(std::move(known->values));
    }
    result.faces = faces.size();
    result.steps = divided.steps() + faces.steps();
    return result;
}

}  // namespace libration::ode
