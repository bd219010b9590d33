#include "libration/integration/taylor/batch_march.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace libration::ode {

std::vector<std::size_t> in_order_of_steps(double begin, std::span<const double> times) {
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const bool forward = times[a] >= begin;
        return forward != (times[b] >= begin) ? forward : forward ? times[a] < times[b] : times[a] > times[b];
    });
    return order;
}

namespace {

constexpr long rounds_between_calls = 1L << 12;

}  // namespace

// One run: what each lane is doing.
class batch_march::integration {
public:
    integration(batch_march& by, const batch_request& request, std::span<double> values)
        : by_(by),
          request_(request),
          values_(values),
          order_(in_order_of_steps(request.begin, request.times)),
          solutions_(by.size() == 0 ? 0 : request.states.size() / by.size()),
          lengths_(by.accuracy_),
          states_(by.size()),
          reached_(by.size()) {
        std::ranges::fill(values_, std::numeric_limits<double>::quiet_NaN());
    }

    void run(const std::function<void(std::size_t)>& finished) {
        if (solutions_ == 0) {
            return;
        }
        for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
            begin_next(lane);
        }
        std::size_t reported = 0;
        for (long round = 1; active_ > 0; ++round) {
            by_.expansion_.about(centres_, states_);
            measure();
            write_reached();
            step();
            if (finished && (finished_ != reported || round % rounds_between_calls == 0)) {
                reported = finished_;
                finished(finished_);
            }
        }
    }

private:
    // taylor_step in double, which is computed once for the same exponents: they are integers that change little.
    class step_lengths {
    public:
        struct length {
            double value = 0;
            bool unlimited = false;
        };

        explicit step_lengths(const step_accuracy& accuracy) : accuracy_(accuracy) {}

        // From the largest coefficients of the two last degrees.
        length of(long size, double last_but_one, double last) {
            const long a = exponent_in(size, last_but_one);
            const long b = exponent_in(size, last);
            entry& known = entries_[(31 * static_cast<std::size_t>(a) + static_cast<std::size_t>(b)) % entries_.size()];
            if (!known.used || known.a != a || known.b != b) {
                known = {true, a, b, computed(a, b)};
            }
            return known.result;
        }

    private:
        struct entry {
            bool used = false;
            long a = 0;
            long b = 0;
            length result;
        };

        static long exponent_in(long size, double x) {
            const long exponent = binary_exponent(x);
            return exponent == exponent_of_zero ? exponent : exponent - size;
        }

        length computed(long last_but_one, long last) const {
            const std::vector<coefficient_size> sizes{{accuracy_.order - 1, last_but_one}, {accuracy_.order, last}};
            const step_length h = accuracy_.bits == 0 ? taylor_step(0, sizes) : taylor_step(0, sizes, accuracy_);
            return {std::ldexp(static_cast<double>(h.mantissa), static_cast<int>(h.exponent)), h.mantissa == 0};
        }

        step_accuracy accuracy_;
        std::array<entry, 256> entries_;
    };

    // The progress of a solution through the times in order_.
    struct traveller {
        bool active = false;
        std::size_t solution = 0;
        std::size_t next = 0;  // in order_
        int way = 0;           // of the steps since the initial point; 0 before the first one
        long steps = 0;        // since the last time that was reached
        bool unlimited = false;
        double length = 0;
        bool restarts = false;
    };

    double time_of(std::size_t next) const { return request_.times[order_[next]]; }
    int way_to(std::size_t next) const { return time_of(next) < request_.begin ? -1 : 1; }

    void put_at_start(std::size_t lane, std::size_t solution) {
        centres_[lane] = request_.begin;
        for (std::size_t i = 0; i < by_.size(); ++i) {
            states_[i][lane] = request_.states[solution * by_.size() + i];
        }
    }

    // The next solution takes the lane; if there is none, the first one stays there without being observed.
    void begin_next(std::size_t lane) {
        traveller& of = lanes_[lane];
        active_ -= of.active ? 1 : 0;
        of = traveller{};
        of.active = begun_ < solutions_;
        of.solution = of.active ? begun_++ : 0;
        active_ += of.active ? 1 : 0;
        put_at_start(lane, of.solution);
    }

    // The length of the step in each lane, like taylor_march::measure.
    void measure() {
        const batch_expansion& expansion = by_.expansion_;
        const int order = expansion.order();
        const lane_numbers first = expansion.sizes(0);
        const lane_numbers last_but_one = expansion.sizes(order - 1);
        const lane_numbers last = expansion.sizes(order);
        for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
            traveller& of = lanes_[lane];
            const bool finite =
                std::isfinite(first[lane]) && std::isfinite(last_but_one[lane]) && std::isfinite(last[lane]);
            const long size = std::max(1L, binary_exponent(first[lane]));
            const step_lengths::length h =
                finite ? lengths_.of(size, last_but_one[lane], last[lane]) : step_lengths::length{};
            of.unlimited = h.unlimited;
            of.length = h.value;
        }
    }

    bool reaches(std::size_t lane, double time) const {
        return lanes_[lane].unlimited || std::abs(time - centres_[lane]) <= lanes_[lane].length;
    }

    // Whether the next time of a lane is within its current step.
    bool is_next_reached(std::size_t lane) const {
        const traveller& of = lanes_[lane];
        if (!of.active || of.restarts || of.next == order_.size()) {
            return false;
        }
        return (of.way == 0 || way_to(of.next) == of.way) && reaches(lane, time_of(of.next));
    }

    // The values at all times within the current steps, a time of each lane at once.
    void write_reached() {
        for (;;) {
            std::array<bool, batch_lanes> writes{};
            lane_numbers distances(0);
            for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
                writes[lane] = is_next_reached(lane);
                if (writes[lane]) {
                    distances[lane] = time_of(lanes_[lane].next) - centres_[lane];
                }
            }
            if (std::ranges::find(writes, true) == writes.end()) {
                return;
            }
            by_.expansion_.at(distances, reached_);
            for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
                if (writes[lane]) {
                    write(lane);
                }
            }
        }
    }

    void write(std::size_t lane) {
        traveller& of = lanes_[lane];
        const std::size_t row = of.solution * request_.times.size() + order_[of.next];
        const bool finite =
            std::ranges::all_of(by_.written_, [&](std::size_t i) { return std::isfinite(reached_[i][lane]); });
        if (!finite) {
            end_way(of);
            return;
        }
        double* to = values_.data() + row * by_.written_.size();
        for (const std::size_t i : by_.written_) {
            *to++ = reached_[i][lane];
        }
        ++of.next;
        of.steps = 0;
    }

    // Leaves out the other times on the same side of the initial point.
    void end_way(traveller& of) const {
        const int way = way_to(of.next);
        while (of.next < order_.size() && way_to(of.next) == way) {
            ++of.next;
        }
        of.restarts = true;
    }

    bool can_step(std::size_t lane) const {
        const traveller& of = lanes_[lane];
        return of.length > 0 && centres_[lane] + of.length / 64 != centres_[lane] &&
               of.steps < taylor_march<double>::most_steps;
    }

    // Every lane to the end of its step, back to the initial point, or to the next solution.
    void step() {
        lane_numbers distances(0);
        for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
            traveller& of = lanes_[lane];
            if (!of.active || of.next == order_.size()) {
                continue;
            }
            of.restarts = of.restarts || (of.way != 0 && way_to(of.next) != of.way);
            if (!of.restarts && !can_step(lane)) {
                end_way(of);
            }
            if (!of.restarts) {
                of.way = way_to(of.next);
                const double to = centres_[lane] + of.length * of.way;
                distances[lane] = to - centres_[lane];
                centres_[lane] = to;
                ++of.steps;
            }
        }
        by_.expansion_.at(distances, states_);
        for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
            settle(lane);
        }
    }

    void settle(std::size_t lane) {
        traveller& of = lanes_[lane];
        if (!of.active) {
            put_at_start(lane, of.solution);
        } else if (of.next == order_.size()) {
            ++finished_;
            begin_next(lane);
        } else if (of.restarts) {
            of.restarts = false;
            of.way = 0;
            of.steps = 0;
            put_at_start(lane, of.solution);
        }
    }

    batch_march& by_;
    const batch_request& request_;
    std::span<double> values_;
    std::vector<std::size_t> order_;
    std::size_t solutions_;
    std::size_t begun_ = 0;
    std::size_t finished_ = 0;
    std::size_t active_ = 0;
    std::array<traveller, batch_lanes> lanes_;
    step_lengths lengths_;
    lane_numbers centres_;
    std::vector<lane_numbers> states_;   // at the centres
    std::vector<lane_numbers> reached_;  // at times that are written
};

batch_march::batch_march(const explicit_system& system, const step_accuracy& accuracy, std::vector<bool> parameters)
    : expansion_(system, accuracy.order, std::move(parameters)), accuracy_(accuracy) {
    for (const unknown_function& each : system.unknowns()) {
        orders_.push_back(each.order);
    }
    if (!hidden_parts(system).empty()) {
        alone_.emplace(system, accuracy);
    }
    for (std::size_t i = 0; i < expansion_.size(); ++i) {
        if (!expansion_.parameters()[i]) {
            written_.push_back(i);
        }
    }
}

void batch_march::run_alone(const batch_request& request, std::span<double> values,
                            const std::function<void(std::size_t)>& finished) {
    std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
    const auto order = in_order_of_steps(request.begin, request.times);
    const std::size_t solutions = size() == 0 ? 0 : request.states.size() / size();
    for (std::size_t k = 0; k < solutions; ++k) {
        const auto start = request.states.subspan(k * size(), size());
        solution_state<double> state;
        for (auto next = start.begin(); const int each : orders_) {
            state.emplace_back(next, next + each);
            next += each;
        }
        alone_->begin_at(request.begin, std::move(state));
        std::array<bool, 2> ended{};  // backwards and forwards
        for (const std::size_t at : order) {
            bool& ended_here = ended[request.times[at] >= request.begin ? 1 : 0];
            if (ended_here) {
                continue;
            }
            std::vector<double> reached;
            try {
                for (const auto& of_unknown : alone_->advance_to(request.times[at])) {
                    reached.insert(reached.end(), of_unknown.begin(), of_unknown.end());
                }
            } catch (const error& problem) {
                if (!problem.is_about(error_subject::time)) {
                    throw;
                }
            }
            const auto finite = [&](std::size_t i) { return std::isfinite(reached[i]); };
            ended_here = reached.empty() || !std::ranges::all_of(written_, finite);
            double* to = values.data() + (k * request.times.size() + at) * written_.size();
            for (std::size_t i = 0; !ended_here && i < written_.size(); ++i) {
                to[i] = reached[written_[i]];
            }
        }
        if (finished) {
            finished(k + 1);
        }
    }
}

void batch_march::run(const batch_request& request, std::span<double> values,
                      const std::function<void(std::size_t)>& finished) {
    if (alone_) {
        run_alone(request, values, finished);
    } else {
        integration(*this, request, values).run(finished);
    }
}

}  // namespace libration::ode
