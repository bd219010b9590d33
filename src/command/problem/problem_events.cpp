#include "problem_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/constant_value.hpp"
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
        if (whole_ == 0 && std::chrono::steady_clock::now() - start_ > next_line_) {
            tell_how_far(time);
        }
    }

private:
    // Of a search without an end.
    void tell_how_far(const ball& time) {
        const precision_scope scope(20);
        say_line(fmt::format("event {} is not found up to time {} in {} s: --before TIME ends the search", known_ + 1,
                             to_decimal(midpoint_of(time), 6), next_line_.count()));
        next_line_ *= 6;
    }

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
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::seconds next_line_{10};
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
    [[noreturn]] void end(const solution& of, const ode::event_request& request, long digits,
                          const std::function<void(const partial_table&)>& write) {
        const std::lock_guard lock(mutex_);
        try {
            if (!events_.empty()) {
                write(events_table(answer_of(of.quantities(), ode::event_report{events_, {}, {}}), digits));
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

}  // namespace

partial_table problem_events(const solution& of, const ode::explicit_system& system, const ode::event_request& request,
                             const libration::request& how, const std::function<void(const partial_table&)>& write) {
    const long digits = how.printed_digits();
    search_progress shown(system, request);
    known_so_far known;
    const at_ending_signal interrupted([&] { known.end(of, request, digits, write); });
    return events_table(of.events(request, how,
                                  [&](const ball& reached, long bits, const std::vector<ode::known_event>& events) {
                                      shown.reached(reached, bits, events.size());
                                      known.tell(reached, bits, events);
                                  }),
                        digits);
}

}  // namespace libration
