#include "motion/problem_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/proved_answer.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"

namespace libration {

namespace {

constexpr std::size_t parts_of_search = 1000;
constexpr int interrupted_code = 1;

// The progress of a search: of the time up to its end, else of its events and of the horizon of the next one. It does
// not decrease when a run restarts.
class search_progress {
public:
    search_progress(const ode::explicit_system& system, const ode::event_request& request)
        : shown_("reference", parts_of_search),
          count_(static_cast<double>(request.count)),
          horizon_(static_cast<double>(request.horizon.value_or(ode::zero_search::usual_horizon))) {
        const precision_scope scope(20);
        origin_ = ode::constant_value<mpfr>::of(system.point());
        if (request.before && !request.horizon) {
            whole_ = abs(ode::constant_value<mpfr>::of(*request.before) - origin_);
        }
    }

    void reached(const ball& time, long bits, std::size_t known) {
        steps_ = bits == bits_ && known == known_ ? steps_ + 1 : 0;
        bits_ = bits;
        known_ = known;
        const double part = std::clamp(whole_ > 0 ? of_time(time) : of_steps(), 0.0, 1.0);
        const auto now = static_cast<std::size_t>(part * static_cast<double>(parts_of_search));
        if (now > done_) {
            shown_.step(now - done_);
            done_ = now;
        }
    }

private:
    double of_time(const ball& time) const {
        const precision_scope scope(20);
        return mpfr(abs(midpoint_of(time) - origin_) / whole_).convert_to<double>();
    }
    double of_steps() const {
        return (static_cast<double>(known_) + std::min(static_cast<double>(steps_) / horizon_, 1.0)) / count_;
    }

    progress shown_;
    mpfr origin_;
    mpfr whole_ = mpfr(0);
    double count_, horizon_;
    long steps_ = 0;
    long bits_ = 0;
    std::size_t known_ = 0;
    std::size_t done_ = 0;
};

// The results of a search up to a signal that ends it, written in one thread and read in another.
class known_so_far {
public:
    /// All events are copied when a run begins, since the one before may have added digits to them.
    void tell(const ball& reached, long bits, const std::vector<ode::known_event>& known) {
        const std::lock_guard lock(mutex_);
        reached_ = reached;
        if (bits != bits_) {
            events_.clear();
            bits_ = bits;
        }
        events_.insert(events_.end(), known.begin() + static_cast<std::ptrdiff_t>(events_.size()), known.end());
    }

    /// Writes the events, reports the time reached, and ends the process.
    [[noreturn]] void end(const ode::explicit_system& system, const ode::event_request& request, long digits,
                          const std::function<void(const partial_table&)>& write) {
        const std::lock_guard lock(mutex_);
        try {
            if (!events_.empty()) {
                write(events_table(answer_of(names_of_state(system), ode::event_report{events_, {}, {}}), digits));
            }
            const precision_scope scope(20);
            say_line(fmt::format("the search for events was interrupted about time {}, with {} of {} events proved",
                                 reached_ ? to_decimal(midpoint_of(*reached_), 12) : "of the start", events_.size(),
                                 request.count));
        } catch (const std::exception& problem) {
            say_line(problem.what());
        }
        std::_Exit(interrupted_code);
    }

private:
    std::mutex mutex_;
    std::optional<ball> reached_;
    std::vector<ode::known_event> events_;
    long bits_ = 0;  // of the run
};

void check_events(const ode::explicit_system& system, ode::event_request request, long digits,
                  const event_searcher& search, const std::vector<ode::known_event>& first) {
    if (first.empty()) {
        return;
    }
    request.count = static_cast<long>(first.size());
    const auto report = search(request, digits + ode::more_digits_of_second_proof, ode::proof_route::second(), {});
    const auto& second = report.events;
    if (second.size() < first.size()) {
        throw error(report.missing.value());
    }
    const auto names = names_of_state(system);
    const auto require_same = [](const ode::known_value& a, const ode::known_value& b, const std::string& what) {
        if (a.decimal && b.decimal) {
            require_agreement(*a.decimal, *b.decimal, what);
        }
    };
    for (std::size_t i = 0; i < first.size(); ++i) {
        const std::string event = fmt::format(" of event {}", i + 1);
        require_same(first[i].time, second[i].time, "the time" + event);
        for (std::size_t j = 0; j < names.size(); ++j) {
            require_same(first[i].values[j], second[i].values[j], names[j] + event);
        }
    }
}

}  // namespace

partial_table problem_events(const ode::explicit_system& system, const ode::event_request& request, long digits,
                             const ode::proof_route& route, bool check, const event_searcher& search,
                             const std::function<void(const partial_table&)>& write) {
    const auto checked = checked_products(check);
    search_progress shown(system, request);
    known_so_far known;
    const at_ending_signal interrupted([&] { known.end(system, request, digits, write); });
    const auto report = search(request, digits, route,
                               [&](const ball& reached, long bits, const std::vector<ode::known_event>& events) {
                                   shown.reached(reached, bits, events.size());
                                   known.tell(reached, bits, events);
                               });
    if (check) {
        check_events(system, request, digits, search, report.events);
    }
    return events_table(answer_of(names_of_state(system), report), digits);
}

}  // namespace libration
