#include "branch_search.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "../equation/bound_text.hpp"
#include "../event/exact_zero.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The number of steps by which the searches advance in turn.
constexpr long steps_in_turn = 1;

// The end of a search: no later than the given one and the end of a ball.
void shorten(std::optional<number>& end, const ball& time) {
    const ball last = upper_bound(time);
    if (!end || certainly_less(last, enclosed_number(*end))) {
        end = number_of(last);
    }
}

}  // namespace

branch_search::branch_search(const explicit_system& system, std::vector<watched_surface> surfaces, ball begins,
                             long bits, step_sequence& along)
    : system_(system), begins_(std::move(begins)), bits_(bits), along_(along) {
    for (watched_surface& each : surfaces) {
        watched_.push_back({std::move(each)});
    }
}

std::nullopt_t branch_search::ended(path_end why, const std::string& reason) {
    end_ = why;
    reason_ = reason;
    return std::nullopt;
}

long branch_search::steps() const {
    long sum = 0;
    for (const watched& each : watched_) {
        sum += each.search ? each.search->steps() : 0;
    }
    return sum;
}

long branch_search::most_steps() const {
    long most = 0;
    for (const watched& each : watched_) {
        most = std::max(most, each.search ? each.search->steps() : 0);
    }
    return most;
}

void branch_search::resume(std::size_t surface) {
    watched_[surface].found.reset();
    watched_[surface].passed = watched_[surface].of.of.time.has_value();
}

// The first known time after the beginning; sets end_ if it is not distinguished from the beginning.
std::optional<std::size_t> branch_search::first_known_time(const std::optional<number>& end) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        const auto& time = watched_[i].of.of.time;
        if (!time || watched_[i].passed) {
            continue;
        }
        const bool exact_beginning = !watched_[i].of.start || !watched_[i].of.start->begins;
        const number gone = *time - system_.point();
        if (exact_beginning ? gone.sign() <= 0 : certainly_less(enclosed_number(*time), begins_)) {
            continue;
        }
        if (!exact_beginning && !certainly_less(begins_, enclosed_number(*time))) {
            ended(path_end::undecided, "the event before it and `" + watched_[i].of.of.text +
                                           "` are not distinguished in time by " + std::to_string(bits_) + " bits");
        }
        const bool asked = !end || (*time - *end).sign() <= 0;
        if (asked && (!first || (*time - *watched_[*first].of.of.time).sign() < 0)) {
            first = i;
        }
    }
    return first;
}

// Reads why the search for a surface paused. The search is over unless it may continue.
void branch_search::read_end(watched& each, bool has_end, long horizon) {
    const zero_search& search = *each.search;
    const ball reached = search.reached();
    switch (search.end()) {
        case search_end::none: break;
        case search_end::time: each.over = true; break;
        case search_end::horizon:
            if (!has_end && each.steps >= horizon) {
                ended(path_end::horizon, "");
            }
            break;
        case search_end::precision:
            if (along_[search.number_of_step()] != nullptr) {
                ended(path_end::precision, "");
                break;
            }
            each.over = true;
            each.limit = reached;
            each.why = path_end::precision;
            break;
        case search_end::steps:
            each.over = true;
            each.limit = reached;
            each.why = path_end::steps;
            each.reason = "the step size falls below its minimum at time " + proved_reach_text(reached, true) +
                          " (probably a singularity)";
            break;
        case search_end::undecided:
            each.over = true;
            each.limit = search.undecided().from;
            each.why = path_end::undecided;
            if (!search.undecided().value.is_finite() || !search.undecided().slope.is_finite()) {
                each.reason = "`" + each.of.of.text + "` is not enclosed in " +
                              interval_text(search.undecided().from, search.undecided().to) +
                              ", as where it has no value";
                break;
            }
            each.reason = "`" + each.of.of.text + "` is not decided by " + std::to_string(bits_) +
                          " bits: its two sides may be equal in " +
                          interval_text(search.undecided().from, search.undecided().to) +
                          ", where they differ by at most " + upper_bound_text(search.undecided().value.exact()) +
                          " and their derivatives by at most " + upper_bound_text(search.undecided().slope.exact()) +
                          ", as where a solution touches the surface without crossing it";
            break;
    }
}

bool branch_search::is_last_before_end(std::size_t surface) const {
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        const watched& each = watched_[i];
        const bool at_end = each.limit && (each.why == path_end::steps || each.why == path_end::precision);
        if (each.found || (i != surface && !each.of.of.time && !(at_end && each.search->is_decided()))) {
            return false;
        }
    }
    return true;
}

// The surfaces whose searches continue, those first whose tangents at the beginning of the next step are 0 first: the end of
// the other searches is then early.
std::vector<branch_search::watched*> branch_search::in_order(const std::optional<number>& end) {
    std::vector<std::pair<double, watched*>> open;
    for (watched& each : watched_) {
        if (each.found || each.over || each.of.of.time) {
            continue;
        }
        if (!each.search) {
            each.search = each.of.start
                              ? std::make_unique<zero_search>(system_, each.of.of.g, along_, *each.of.start, bits_)
                              : std::make_unique<zero_search>(system_, each.of.of.g, along_, bits_);
        }
        open.emplace_back(0, &each);
    }
    if (open.size() > 1 && (!end || certainly_less(along_.reached(), enclosed_number(*end)))) {
        for (auto& [distance, each] : open) {
            distance = each->search->distance_by_tangent();
        }
        std::ranges::stable_sort(open, {}, &std::pair<double, watched*>::first);
    }
    std::vector<watched*> order;
    std::ranges::transform(open, std::back_inserter(order), &std::pair<double, watched*>::second);
    return order;
}

// False if the search may continue.
bool branch_search::advance(watched& each, const std::optional<number>& end, long horizon) {
    auto event = each.search->next(each.of.way, end, steps_in_turn);
    if (!event) {
        each.steps += steps_in_turn;
        read_end(each, end.has_value(), horizon);
        return each.over;
    }
    if (each.of.start && each.of.start->begins && !certainly_less(*each.of.start->begins, event->time)) {
        ended(path_end::undecided, "the event before it and `" + each.of.of.text +
                                       "` are not distinguished in time by " + std::to_string(bits_) + " bits");
    }
    each.found = std::move(event);
    return true;
}

std::optional<found_crossing> branch_search::next(const std::optional<number>& end, long horizon) {
    end_ = path_end::none;
    reached_.reset();
    for (watched& each : watched_) {
        each.over = each.limit.has_value();  // the end may be a later one
    }
    const auto known = first_known_time(end);
    std::optional<number> bound = end;
    if (known) {
        bound = watched_[*known].of.of.time;
    }
    for (const watched& each : watched_) {
        if (each.found) {
            shorten(bound, each.found->time);
        }
    }
    bool all = false;
    while (!all && end_ == path_end::none) {
        all = true;
        for (watched* const each : in_order(bound)) {
            all = advance(*each, bound, horizon) && all;
            if (end_ != path_end::none) {
                return std::nullopt;
            }
            if (each->found) {
                shorten(bound, each->found->time);
            }
        }
        forget_searched_steps();
    }
    return end_ == path_end::none ? first_of(known) : std::nullopt;
}

// Except the last one of them: a search that ends with a step is at the next one.
void branch_search::forget_searched_steps() {
    std::size_t first = std::numeric_limits<std::size_t>::max();
    for (const watched& each : watched_) {
        first = each.search ? std::min(first, each.search->number_of_step()) : first;
    }
    if (first > 0 && first < std::numeric_limits<std::size_t>::max()) {
        along_.forget_before(first - 1);
    }
}

// The first of the crossings that were found.
std::optional<found_crossing> branch_search::first_of(const std::optional<std::size_t>& known) {
    std::optional<std::size_t> first = known;
    ball time;
    if (known) {
        time = enclosed_number(*watched_[*known].of.of.time);
        reach(time);
    }
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        const auto& found = watched_[i].found;
        if (found) {
            reach(found->time);
        }
        if (found && (!first || certainly_less(upper_bound(found->time), upper_bound(time)))) {
            first = i;
            time = found->time;
        }
    }
    const watched* blocking = nullptr;
    for (const watched& each : watched_) {
        if (each.limit && (!first || !certainly_less(time, *each.limit)) &&
            (blocking == nullptr || certainly_less(lower_bound(*each.limit), lower_bound(*blocking->limit)))) {
            blocking = &each;
        }
    }
    if (blocking != nullptr) {
        reach(*blocking->limit);
        return ended(blocking->why, blocking->reason);
    }
    return first ? crossing_at(*first, time) : ended(path_end::time, "");
}

// Nothing is crossed before this time, as far as it is concerned.
void branch_search::reach(const ball& time) {
    const ball lower = lower_bound(time);
    if (!reached_ || certainly_less(lower, *reached_)) {
        reached_ = lower;
    }
}

// The first crossing, with the others at the same exact time; std::nullopt if it is not separated from another one.
std::optional<found_crossing> branch_search::crossing_at(std::size_t first, const ball& time) {
    std::vector<std::size_t> near{first};
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        const auto& known = watched_[i].of.of.time;
        const bool overlapping = watched_[i].found
                                     ? overlaps(watched_[i].found->time, time)
                                     : known && !watched_[i].passed && overlaps(enclosed_number(*known), time);
        if (i != first && overlapping && !(known && watched_[first].of.of.time)) {
            near.push_back(i);
        }
    }
    found_crossing result{near, {}, watched_[first].found, watched_[first].of.of.time};
    if (result.event && result.event->exactly) {
        result.exactly = std::exchange(result.event, std::nullopt)->exactly;
    }
    if (near.size() > 1) {
        result.event.reset();
        result.exactly = common_time(near);
        if (!result.exactly) {
            return ended(path_end::undecided, "`" + watched_[near[0]].of.of.text + "` and `" +
                                                  watched_[near[1]].of.of.text +
                                                  "` are crossed at the same time, or are not distinguished by " +
                                                  std::to_string(bits_) + " bits");
        }
    }
    for (const std::size_t i : near) {
        const auto& found = watched_[i].found;
        result.crossed.push_back({watched_[i].of.of, found ? found->way : crossing::up});
    }
    return result;
}

// Known exactly, or a fraction, or one of pi.
std::optional<number> branch_search::common_time(const std::vector<std::size_t>& surfaces) const {
    std::vector<number> candidates;
    for (const std::size_t i : surfaces) {
        if (const auto& known = watched_[i].of.of.time) {
            candidates = {*known};
            break;
        }
        std::ranges::copy(simple_numbers_in(watched_[i].found->time), std::back_inserter(candidates));
    }
    const auto at = std::ranges::find_if(candidates, [&](const number& time) {
        return std::ranges::all_of(surfaces, [&](std::size_t i) { return is_zero_at(watched_[i], time); });
    });
    return at == candidates.end() ? std::nullopt : std::optional(*at);
}

// Whether the zero that was found is at exactly this time.
bool branch_search::is_zero_at(const watched& each, const number& time) {
    if (const auto& known = each.of.of.time) {
        return (*known - time).sign() == 0;
    }
    return !each.of.of.g.has_unknowns() && contains(each.found->time, enclosed_number(time)) &&
           is_exact_zero(each.of.of.g, time);
}

}  // namespace libration::ode
