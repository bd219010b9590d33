#include "libration/verification/problem_truths.hpp"

#include <algorithm>
#include <utility>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/dependency.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/decimal.hpp"
#include "row_work.hpp"

namespace libration::ode {

namespace {

constexpr long first_guard = 20;
constexpr long second_guard = 45;
constexpr long first_proof_bits = 96;
constexpr long most_proof_bits = 200'000;
constexpr long most_error_bits = 4'096;

bool is_start(const explicit_system& system, const exact& time) {
    const auto plain = (as_exact_real(time) - system.point()).plain();
    return plain && plain->coefficient == 0;
}

}  // namespace

std::vector<solution_component> components_of(const explicit_system& system) {
    std::vector<solution_component> all;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 0; j < system.unknowns()[i].order; ++j) {
            all.push_back({i, static_cast<std::size_t>(j)});
        }
    }
    return all;
}

namespace {

std::vector<std::string> unknowns_of(const explicit_system& system, const std::vector<solution_component>& asked) {
    std::vector<std::string> names;
    names.reserve(asked.size());
    for (const solution_component& each : asked) {
        names.push_back(system.unknowns()[each.unknown].name);
    }
    return names;
}

}  // namespace

problem_truths::problem_truths(const explicit_system& system, equation_system equations,
                               const std::vector<solution_component>& asked)
    : system_(subsystem_with(system, unknowns_of(system, asked)).system), equations_(std::move(equations)) {
    const auto index_of = ode::places_of(system_.unknowns());
    const auto all = components_of(system_);
    for (const solution_component& each : asked) {
        asked_.push_back({index_of.at(system.unknowns()[each.unknown].name), each.derivative});
        const auto found = std::ranges::find_if(all, [&](const solution_component& other) {
            return other.unknown == asked_.back().unknown && other.derivative == each.derivative;
        });
        places_.push_back(static_cast<std::size_t>(found - all.begin()));
    }
}

// Two integrations, and their positions.
struct problem_truths::march_pair {
    long digits;
    std::unique_ptr<taylor_march<mpfr>> first;
    std::unique_ptr<taylor_march<mpfr>> second;

    march_pair(const explicit_system& system, long printed) : digits(printed) {
        first = made(system, first_guard);
        second = made(system, second_guard);
    }

    std::unique_ptr<taylor_march<mpfr>> made(const explicit_system& system, long guard) const {
        const precision_scope scope(digits + guard);
        return std::make_unique<taylor_march<mpfr>>(system);
    }

    solution_state<mpfr> state(taylor_march<mpfr>& march, const exact& time, long guard) const {
        const precision_scope scope(digits + guard);
        return march.advance_to(constant_value<mpfr>::of(as_exact_real(time)));
    }
};

problem_truths::march_pair& problem_truths::marches(long digits) {
    auto& made = by_digits_[digits];
    if (!made) {
        made = std::make_shared<march_pair>(system_, digits);
    }
    return *made;
}

// A proved integration that continues from one time to the next, and from the start if it needs more bits.
struct problem_truths::proved_way {
    const explicit_system& system;
    run_bits bits;
    bool with_derivative;
    row_work work;
    std::unique_ptr<proved_march> march = {};
    double reached = 0;  // the latest end of a proved step
    number latest = {};

    // use(state), a std::optional, at a time; without one the error maps need more bits, too. std::nullopt if no bits
    // within the limits suffice.
    template <class Use>
    std::invoke_result_t<Use&, const std::vector<ball>&> at(const exact& time, const Use& use) {
        const number at = as_exact_real(time);
        const int direction = (at - system.point()).sign();
        work.begin(at, time.text, direction);
        return with_more_precision(bits.bits, most_proof_bits, [&](long& next) {
            if (!march || ((at - latest) * number(rational(direction))).sign() < 0) {
                march = std::make_unique<proved_march>(
                    system, bits.bits,
                    [this](const ball& end, long /*bits*/) {
                        reached = midpoint_of(end).convert_to<double>();
                        work.add(*march);
                    },
                    bits.error_bits);
                if (with_derivative) {
                    march->keep_derivative();
                }
            }
            latest = at;
            const auto state = march->at(at);
            auto result = state ? use(*state) : std::nullopt;
            if (!state && march->end() == stop::step_too_small) {
                next = most_proof_bits + 1;
            } else if (!result) {
                march.reset();
                bits = {2 * bits.bits, state ? 2 * bits.error_bits : bits.error_bits};
                next = bits.bits = bits.error_bits <= most_error_bits ? bits.bits : most_proof_bits + 1;
            }
            return result;
        });
    }
};

// All unknowns and their lower derivatives, in order. More bits are used if the enclosure becomes too wide.
std::vector<ball> problem_truths::proved_state(const exact& time, long digits) {
    auto& way = proved_by_digits_[digits];
    if (!way) {
        way = std::make_shared<proved_way>(proved_way{system_,
                                                      {.bits = bits_of_digits(digits) + first_proof_bits},
                                                      false,
                                                      row_work(components_of(system_).size())});
    }
    auto state = way->at(time, [](const std::vector<ball>& found) { return std::optional(found); });
    if (!state) {
        throw error(
            error_kind::undecided, error_subject::time, time.text,
            "is not reached: the solution is proved to exist up to about " + to_decimal(way->reached, 6) +
                ", where a singularity is near, or more digits are lost than the limits of the precision allow");
    }
    return *std::move(state);
}

bool problem_truths::proves(const exact& time) {
    if (!system_.singular() || is_start(system_, time)) {
        return true;
    }
    if (!provable_) {
        try {
            const proved_march first(system_, first_proof_bits);
            provable_ = true;
        } catch (const error&) {  // theorem S does not apply to it
            provable_ = false;
        }
    }
    return *provable_ && (as_exact_real(time) - system_.point()).sign() > 0;
}

std::vector<true_value> problem_truths::truths_at(const exact& time, long digits) {
    std::vector<true_value> truths;
    if (is_start(system_, time)) {
        for (const auto& [unknown, derivative] : asked_) {
            const number& value = system_.starts()[unknown][derivative];
            truths.push_back({constant_value<ball>::of(value), value.fraction()});
        }
        return truths;
    }
    if (proves(time)) {
        const auto state = proved_state(time, digits);
        for (const std::size_t place : places_) {
            truths.push_back({state[place]});
        }
        return truths;
    }
    march_pair& pair = marches(digits);
    const auto a = pair.state(*pair.first, time, first_guard);
    const auto b = pair.state(*pair.second, time, second_guard);
    const precision_scope scope(digits + second_guard);
    const mpfr last = pow(mpfr(10), static_cast<int>(-digits));
    for (const auto& [unknown, derivative] : asked_) {
        const mpfr& here = b[unknown][derivative];
        const mpfr apart = abs(mpfr(a[unknown][derivative] - here)) * 16 + abs(here) * last;
        truths.push_back({enclose(ball(here), ball(apart))});
    }
    return truths;
}

// Of the compared components at a state, by the right-hand sides.
std::vector<mpfr> problem_truths::slopes_of(const exact& time, const solution_state<mpfr>& state) const {
    const auto t = constant_value<mpfr>::of(as_exact_real(time));
    const tape tape = tape::about_points(system_);
    taylor_expansion<mpfr> there(tape, 1);
    there.about(t, state);
    std::vector<mpfr> slopes;
    for (const auto& [unknown, derivative] : asked_) {
        slopes.push_back(there.coefficients(static_cast<int>(unknown), static_cast<int>(derivative))[1]);
    }
    return slopes;
}

std::vector<mpfr> problem_truths::slopes_at(const exact& time, long digits) {
    if (is_start(system_, time)) {
        return {};
    }
    const auto state = proves(time) ? midpoints_of(proved_state(time, digits))
                                    : marches(digits).state(*marches(digits).second, time, second_guard);
    const precision_scope scope(digits_of_row_numbers);
    return slopes_of(time, state);
}

// The unknowns with their derivatives, of the values in their order.
solution_state<mpfr> problem_truths::midpoints_of(const std::vector<ball>& values) const {
    solution_state<mpfr> state(system_.unknowns().size());
    auto next = values.begin();
    for (std::size_t i = 0; i < state.size(); ++i) {
        for (int k = 0; k < system_.unknowns()[i].order; ++k) {
            state[i].push_back(midpoint_of(*next++));
        }
    }
    return state;
}

// |t y'|/max(1, |y|) of the first column, from a singular initial point.
std::string problem_truths::condition_of_slope(const exact& time, long digits) {
    if (time.is_zero()) {
        return "0";
    }
    if (is_start(system_, time)) {
        return "inf";
    }
    march_pair& pair = marches(digits);
    const auto state = pair.state(*pair.second, time, second_guard);
    const precision_scope scope(digits + second_guard);
    const mpfr t = constant_value<mpfr>::of(as_exact_real(time));
    const mpfr slope = slopes_of(time, state).front();
    const mpfr size = abs(state[asked_.front().unknown][asked_.front().derivative]);
    return to_decimal(mpfr(abs(mpfr(t * slope)) / (size > 1 ? size : mpfr(1))), 3);
}

// An integration with its derivative by initial values and parameters.
struct problem_truths::dependent_way {
    dependent_way(const equation_system& equations, const std::vector<std::string>& unknowns)
        : on(equations, unknowns),
          way{on.system(), {.bits = first_proof_bits}, true, row_work(on.system().unknowns().size())} {}

    std::size_t place_of(const std::string& name) const {
        return static_cast<std::size_t>(std::ranges::find(on.names(), name) - on.names().begin());
    }

    dependence on;
    proved_way way;
};

// Three digits. std::nullopt if this many bits do not decide them.
std::optional<std::vector<moved_value>> problem_truths::moved_at(const exact& time) {
    if (!dependent_) {
        dependent_ = std::make_shared<dependent_way>(equations_, unknowns_of(system_, asked_));
    }
    proved_way& way = dependent_->way;
    return way.at(time, [&](const std::vector<ball>& state) {
        return dependent_->on.moved(*way.march, as_exact_real(time), state, 0);
    });
}

std::string problem_truths::condition_at(const exact& time, long digits) {
    std::optional<std::vector<moved_value>> moved;
    try {
        if (system_.singular() && (is_start(system_, time) || !proves(time))) {
            return condition_of_slope(time, digits);
        }
        moved = moved_at(time);
    } catch (const work_limit&) {
        return "";
    } catch (const error&) {
        if (!system_.singular()) {
            throw;
        }
        return condition_of_slope(time, digits);  // an initial value fixed by the equation
    }
    if (!moved) {
        return "inf";
    }
    const auto truths = truths_at(time, digits);
    const precision_scope few(20);
    mpfr largest(0);
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const auto& [unknown, derivative] = asked_[i];
        const std::string name = primed(system_.unknowns()[unknown].name, static_cast<int>(derivative));
        const moved_value& own = (*moved)[dependent_->place_of(name)];
        const mpfr size = abs(midpoint_of(truths[i].value()));
        const mpfr sum = own.by_start + own.by_parameters + own.by_time;
        largest = std::max(largest, mpfr(sum / (size > 1 ? size : mpfr(1))));
    }
    return to_decimal(largest, 3);
}

row_question problem_truths::at(const exact& time) {
    row_question question;
    question.proved = proves(time);
    question.first_digits = [](long places) { return (places + 29) / 10 * 10; };
    question.truths = [this, time](long digits) { return truths_at(time, digits); };
    question.slopes = [this, time](long digits) { return slopes_at(time, digits); };
    question.condition = [this, time](long digits) { return condition_at(time, digits); };
    return question;
}

}  // namespace libration::ode
