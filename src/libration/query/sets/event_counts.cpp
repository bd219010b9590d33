#include "libration/query/sets/event_counts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <set>
#include <utility>

#include "../../equation/bound_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"
#include "part_run.hpp"
#include "set_run.hpp"
#include "subdivision.hpp"

namespace libration::ode {

namespace {

constexpr long first_cells = 64;
// Of the cells of a part that may be divided, and of one that may not.
constexpr int usual_halvings = 2;
constexpr int most_halvings = 5;

// Of the difference of the sides of the condition and of its derivatives along all solutions of a part over a span of
// time; 0 if it is not proved.
using proved_signs = std::array<int, 3>;

struct time_cell {
    number from, to;  // in the direction of the search
    std::optional<proved_signs> signs = {};
};

// The cells from `first` to before `last`, between others with a sign.
struct window {
    std::size_t first, last;
};

// The numbers that a part proves, or the reason if they are not decided.
struct part_counts {
    std::set<long> counts;
    std::string reason;
    bool may_divide = true;
};

class count_question {
public:
    count_question(const set_problem& of, const event_count_request& asked, long bits, const march_watch& watch,
                   const proof_route& route)
        : of_(of),
          asked_(asked),
          forward_((asked.before - of.system().point()).sign() > 0),
          bits_(bits),
          watch_(watch),
          route_(route),
          form_(of.system()) {
        functions_[0] = form_.in_leaves(of.condition());
        functions_[1] = form_.slope_of(functions_[0]);
        functions_[2] = form_.slope_of(functions_[1]);
    }

    part_counts of_part(const number_box& part, int halvings) {
        const number length = (asked_.before - of_.system().point()) / number(first_cells);
        std::vector<time_cell> cells;
        for (long i = 0; i < first_cells; ++i) {
            const number& start = of_.system().point();
            cells.push_back({start + length * number(i), start + length * number(i + 1)});
        }
        part_counts result;
        for (; find_signs(cells, part, result); --halvings) {
            result.counts = {0};
            std::vector<window> open;
            for (const window& each : windows_of(cells)) {
                const auto numbers = counts_in(cells, each);
                if (numbers.empty()) {
                    open.push_back(each);
                }
                add(result.counts, numbers);
            }
            if (open.empty()) {
                return result;
            }
            if (halvings == 0) {
                result.reason = "is not decided: the condition may hold in " + text_of(cells, open.front());
                break;
            }
            halve(cells, open);
        }
        result.counts.clear();
        return result;
    }

    long steps() const { return steps_; }

private:
    time_span span_of(const time_cell& cell) const {
        return forward_ ? time_span{cell.from, cell.to} : time_span{cell.to, cell.from};
    }

    // Of the cells without signs. False if not all solutions reach the last of them.
    bool find_signs(std::vector<time_cell>& cells, const number_box& part, part_counts& result) {
        std::vector<time_span> spans;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells[i].signs) {
                spans.push_back(span_of(cells[i]));
                places.push_back(i);
            }
        }
        const span_question question(of_, std::move(spans), bits_, watch_, route_);
        const set_run_result run = best_run(question, part, false);
        steps_ += run.steps;
        if (!run.complete) {
            result.reason = text_of_reach(run.reached, run.begins, forward_);
            result.may_divide = run.may_divide && middle_is_complete(question, part);
            return false;
        }
        const std::vector<ball> start = of_.states_of(part).hull();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const time_span over = span_of(cells[places[i]]);
            const ball time = hull(constant_value<ball>::of(over.from), constant_value<ball>::of(over.to));
            std::vector<ball> state = start;  // constant, except the unknowns of the problem
            for (std::size_t k = 0; k < of_.own().size(); ++k) {
                state[of_.own()[k]] = ball_of(run.images[i]->values[k]);
            }
            cells[places[i]].signs = signs_at(state, time);
        }
        return true;
    }

    // The single solution from the middle of a part that is not complete is in one of its parts.
    static bool middle_is_complete(const span_question& question, const number_box& part) {
        number_box middle;
        for (const closed_interval& each : part) {
            middle.push_back({middle_of(each), middle_of(each)});
        }
        return question.enclosed_from(middle, false).complete;
    }

    proved_signs signs_at(const std::vector<ball>& state, const ball& time) const {
        expression_values<ball> values(form_.leaves, time);
        for (const ball& each : state) {
            values.push_back(each);
        }
        proved_signs signs{};
        for (std::size_t i = 0; i < signs.size(); ++i) {
            try {
                signs[i] = known_sign(values.of(functions_[i]));
            } catch (const precision_exhausted&) {
                signs[i] = 0;
            }
        }
        return signs;
    }

    static std::vector<window> windows_of(const std::vector<time_cell>& cells) {
        std::vector<window> found;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if ((*cells[i].signs)[0] != 0) {
                continue;
            }
            if (found.empty() || found.back().last != i) {
                found.push_back({i, i});
            }
            ++found.back().last;
        }
        return found;
    }

    // The sign that a function has in all cells of a window, or 0.
    static int sign_in(const std::vector<time_cell>& cells, const window& at, std::size_t function) {
        const int first = (*cells[at.first].signs)[function];
        for (std::size_t i = at.first; i < at.last; ++i) {
            if ((*cells[i].signs)[function] != first) {
                return 0;
            }
        }
        return first;
    }

    // The possible numbers of events in a window; none if they are not decided.
    std::vector<long> counts_in(const std::vector<time_cell>& cells, const window& at) const {
        if (at.first == 0 || at.last == cells.size()) {
            return {};  // the sign at its end is not proved
        }
        const int before = (*cells[at.first - 1].signs)[0];
        const int after = (*cells[at.last].signs)[0];
        const int curvature = sign_in(cells, at, 2);
        if (sign_in(cells, at, 1) == 0 && curvature == 0) {
            return {};
        }
        if (before != after) {
            const bool up = (before < 0) == forward_;
            return {asked_.way == crossing::any || (asked_.way == crossing::up) == up ? 1 : 0};
        }
        // A function that is monotone, or convex and negative at both ends, has no zero.
        if (sign_in(cells, at, 1) != 0 || before * curvature < 0) {
            return {0};
        }
        return {0, asked_.way == crossing::any ? 2 : 1};
    }

    static void add(std::set<long>& to, const std::vector<long>& numbers) {
        std::set<long> sums;
        for (const long a : to) {
            for (const long b : numbers) {
                sums.insert(a + b);
            }
        }
        to = std::move(sums);
    }

    static void halve(std::vector<time_cell>& cells, const std::vector<window>& open) {
        std::vector<time_cell> finer;
        auto next = open.begin();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            while (next != open.end() && next->last <= i) {
                ++next;
            }
            if (next == open.end() || i < next->first) {
                finer.push_back(std::move(cells[i]));
                continue;
            }
            const number middle = (cells[i].from + cells[i].to) / number(2);
            finer.push_back({cells[i].from, middle});
            finer.push_back({middle, cells[i].to});
        }
        cells = std::move(finer);
    }

    std::string text_of(const std::vector<time_cell>& cells, const window& at) const {
        const time_span over = forward_ ? time_span{cells[at.first].from, cells[at.last - 1].to}
                                        : time_span{cells[at.last - 1].to, cells[at.first].from};
        return interval_text(lower_bound(constant_value<ball>::of(over.from)),
                             upper_bound(constant_value<ball>::of(over.to)));
    }

    const set_problem& of_;
    const event_count_request& asked_;
    bool forward_;
    long bits_;
    const march_watch& watch_;
    const proof_route& route_;
    first_order_form form_;
    std::array<expression, 3> functions_;  // in leaves
    long steps_ = 0;
};

}  // namespace

possible_counts event_counts(const equation_system& given, const event_count_request& asked, const march_watch& watch,
                             const proof_route& route) {
    const set_problem problem(given, asked.condition);
    if ((asked.before - problem.system().point()).sign() == 0) {
        throw error(error_kind::argument, error_subject::before, text_of_time(asked.before),
                    "is the initial point: give a later or an earlier time");
    }
    const long bits = bits_of_sets(problem, asked.digits);
    const precision_scope scope(decimal_digits(bits));
    count_question question(problem, asked, bits, watch, route);
    const number_box whole = problem.box();
    std::deque<number_box> parts{whole};
    std::set<long> counts;
    possible_counts result;
    while (!parts.empty()) {
        const number_box part = parts.front();
        parts.pop_front();
        const auto side = result.parts < asked.most_parts ? widest_side(part, whole) : std::nullopt;
        const part_counts found = question.of_part(part, side ? usual_halvings : most_halvings);
        counts.insert(found.counts.begin(), found.counts.end());
        if (!found.counts.empty()) {
            continue;
        }
        if (!side || !found.may_divide) {
            result.missing = error(error_kind::undecided, "number of events before", text_of_time(asked.before),
                                   found.reason + text_of_part(part, problem.sets(), result.parts));
            break;
        }
        for (const number_box& half : halves(part, *side)) {
            parts.push_back(half);
        }
        ++result.parts;
    }
    result.steps = question.steps();
    if (!result.missing) {
        result.counts.assign(counts.begin(), counts.end());
    }
    return result;
}

}  // namespace libration::ode
