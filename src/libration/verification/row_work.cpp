#include "row_work.hpp"

#include <algorithm>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/precision.hpp"

namespace libration::ode {

namespace {

constexpr long steps_of_mean = 512;

}  // namespace

void row_work::begin(const number& time, const std::string& text, int direction) {
    time_ = time;
    text_ = text;
    forward_ = direction >= 0;
    cost_ = 0;
    marked_.reset();
    mean_.reset();
    const auto& limit = given_up_[forward_ ? 1 : 0];
    if (limit && ((time - *limit) * number(rational(direction))).sign() >= 0) {
        throw work_limit(error_kind::undecided, error_subject::time, text,
                         "is beyond the time of another row, which was not reached");
    }
}

void row_work::add(const proved_march& march) {
    if (march.steps() < steps_) {  // another one
        steps_ = 0;
        marked_.reset();
        mean_.reset();
    }
    const double limbs = std::max(1.0, static_cast<double>(march.bits()) / 64);
    cost_ += static_cast<double>(march.steps() - steps_) * per_step_ * limbs * limbs;
    steps_ = march.steps();
    if (cost_ > most) {
        give_up(march, "the limit of work per row is exceeded");
    }
    if (is_out_of_reach(march)) {
        give_up(march, "more than " + std::to_string(proved_march::most_steps) + " more of their length are needed");
    }
}

bool row_work::is_out_of_reach(const proved_march& march) {
    if (marked_ && steps_ - marked_steps_ < steps_of_mean) {
        return false;
    }
    const precision_scope scope(20);
    const mpfr here = midpoint_of(march.reached());
    std::optional<mpfr> mean;
    bool out_of_reach = false;
    if (marked_) {
        mean = mpfr(abs(mpfr(here - *marked_))) / (steps_ - marked_steps_);
        const mpfr missing = abs(mpfr(constant_value<mpfr>::of(time_) - here));
        out_of_reach = mean_ && *mean < 2 * *mean_ && missing > *mean * proved_march::most_steps;
    }
    mean_ = mean;
    marked_ = here;
    marked_steps_ = steps_;
    return out_of_reach;
}

void row_work::give_up(const proved_march& march, const std::string& reason) {
    given_up_[forward_ ? 1 : 0] = time_;
    const precision_scope scope(20);
    throw work_limit(error_kind::undecided, error_subject::time, text_,
                     "is not reached: the proof has reached " + to_decimal(midpoint_of(march.reached()), 6) + " in " +
                         std::to_string(march.steps()) + " steps, and " + reason);
}

}  // namespace libration::ode
