#include "libration/ode/proved/proved_trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long first_guard_bits = 64;
// A value that so many runs, each with more bits, do not tell from 0 is taken for one.
constexpr int most_runs_at_zero = 6;
constexpr long most_bits = 1'000'000;
constexpr long largest_growth = 6;

long bits_of_digits(long digits) { return digits * 3322 / 1000 + 4; }

// A time in the order in which a march comes to it.
struct asked_time {
    std::size_t index;
    bool forward;
};

std::vector<asked_time> in_order(const explicit_system& system, const std::vector<number>& times) {
    const precision_scope scope(40);
    std::vector<mpfr> gone;
    for (const number& each : times) {
        gone.push_back(constant_value<mpfr>::of(each - system.point()));
    }
    std::vector<asked_time> order;
    for (std::size_t i = 0; i < times.size(); ++i) {
        order.push_back({i, !(gone[i] < 0)});
    }
    std::ranges::stable_sort(order, [&](const asked_time& a, const asked_time& b) {
        return a.forward != b.forward ? a.forward : abs(gone[a.index]) < abs(gone[b.index]);
    });
    return order;
}

class proving_runs {
public:
    proving_runs(const explicit_system& system, const std::vector<number>& times, long digits, const march_watch& watch)
        : system_(system), times_(times), digits_(digits), watch_(watch), order_(in_order(system, times)) {}

    std::vector<std::vector<proved_decimal>> result() {
        long bits = bits_of_digits(digits_) + first_guard_bits;
        while (!complete(bits)) {
            bits = next_;
            if (bits > most_bits) {
                throw error(error_kind::undecided, "time", text_of(unproved_), "is not proved by a million bits");
            }
        }
        return std::move(values_);
    }

private:
    // One run; where it does not prove every digit, next_ is the precision of another one.
    bool complete(long bits) {
        values_.assign(times_.size(), {});
        std::optional<proved_march> march;
        bool forward = true;
        for (const asked_time& each : order_) {
            if (!march || each.forward != forward) {
                forward = each.forward;
                march.emplace(system_, bits, watch_);
            }
            unproved_ = each.index;
            const auto state = march->at(times_[each.index]);
            if (!state) {
                require_more_bits(*march, forward);
                next_ = bits_to_go_on(*march, bits);
                return false;
            }
            if (!printed(*state, each.index, bits)) {
                return false;
            }
        }
        return true;
    }

    bool printed(const std::vector<ball>& state, std::size_t time, long bits) {
        for (const ball& value : state) {
            const auto decimal = to_proved_decimal(value, digits_);
            if (!decimal) {
                next_ = bits_for(value, bits);
                return false;
            }
            values_[time].push_back(*decimal);
        }
        return true;
    }

    long bits_for(const ball& value, long bits) {
        if (!contains_zero(value)) {
            return bits + bits_of_digits(digits_ - proved_digits(value, digits_)) + bits / 32 + 8;
        }
        if (++runs_at_zero_ >= most_runs_at_zero) {
            throw error(error_kind::undecided, "time", text_of(unproved_),
                        "has a value that " + std::to_string(bits) + " bits do not tell from 0");
        }
        return 2 * bits;
    }

    void require_more_bits(const proved_march& march, bool forward) const {
        if (march.end() == march_end::precision) {
            return;
        }
        const precision_scope scope(20);
        const mpfr reached = midpoint_of(forward ? lower_bound(march.reached()) : upper_bound(march.reached()));
        const std::string until = reached == 0 ? "0" : parts_of(reached, 12, forward ? MPFR_RNDD : MPFR_RNDU).text();
        throw error(error_kind::undecided, "time", text_of(unproved_),
                    "is not reached: the solution is proved to exist up to " + until +
                        ", where the steps become too small, as they do near a singularity");
    }

    // As many bits as were lost until here, for every further stretch of time, and some more.
    long bits_to_go_on(const proved_march& march, long bits) const {
        const precision_scope scope(20);
        const mpfr gone = abs(midpoint_of(march.reached() - constant_value<ball>::of(system_.point())));
        const mpfr asked = abs(constant_value<mpfr>::of(times_[order_.back().index] - system_.point()));
        const mpfr here = abs(constant_value<mpfr>::of(times_[unproved_] - system_.point()));
        const mpfr far = std::max(asked, here);
        const mpfr times = gone == 0 ? mpfr(largest_growth) : mpfr(far / gone * 21 / 20);
        const long wanted = times > largest_growth ? largest_growth * bits : mpfr(times * bits).convert_to<long>();
        return std::max(bits + bits / 4, wanted + bits_of_digits(digits_) + first_guard_bits);
    }

    std::string text_of(std::size_t time) const {
        const precision_scope scope(20);
        return to_decimal(constant_value<mpfr>::of(times_[time]), 12);
    }

    const explicit_system& system_;
    const std::vector<number>& times_;
    long digits_;
    const march_watch& watch_;
    std::vector<asked_time> order_;
    std::vector<std::vector<proved_decimal>> values_;
    std::size_t unproved_ = 0;
    int runs_at_zero_ = 0;
    long next_ = 0;
};

}  // namespace

std::vector<std::vector<proved_decimal>> proved_trajectory(const explicit_system& system,
                                                           const std::vector<number>& times, long digits,
                                                           const march_watch& watch) {
    return proving_runs(system, times, digits, watch).result();
}

}  // namespace libration::ode
