#include "verify/problem_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/taylor_expansion.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "motion/motion_cells.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr long first_guard = 20;
constexpr long second_guard = 45;
constexpr long first_proof_bits = 96;
constexpr long most_proof_bits = 200'000;
constexpr long most_error_bits = 4'096;

bool is_start(const ode::explicit_system& system, const exact& time) {
    const auto plain = (as_expression(time) - system.point()).plain();
    return plain && plain->coefficient == 0;
}

}  // namespace

problem_layout::problem_layout(ode::explicit_system system, ode::equation_system equations)
    : system_(std::move(system)), equations_(std::move(equations)) {
    for (std::size_t i = 0; i < system_.unknowns().size(); ++i) {
        const auto& unknown = system_.unknowns()[i];
        for (int j = 0; j < unknown.order; ++j) {
            names_.push_back(ode::primed(unknown.name, j));
            all_.push_back({i, static_cast<std::size_t>(j)});
        }
    }
}

std::vector<known_column> problem_layout::known() const {
    std::vector<known_column> columns{{"time", {"time", system_.variable()}}};
    for (const std::string& name : names_) {
        columns.push_back({name});
    }
    return columns;
}

void problem_layout::read(const column_names& names) {
    time_ = names.find("time");
    if (!time_) {
        throw input_error(
            fmt::format("{} has no column time: its columns are {}: {}", names.file(), names.listed(), mapping_remedy));
    }
    own_time_ = names.own(*time_);
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (const auto at = names.find(names_[i])) {
            compared_.push_back({names_[i], *at});
            components_.push_back(all_[i]);
        }
    }
    if (compared_.empty()) {
        throw input_error(fmt::format("{} has none of the columns {} of the problem: its columns are {}: {}",
                                      names.file(), listed(names_), names.listed(), mapping_remedy));
    }
}

std::size_t problem_layout::place_of(const component& of) const {
    const auto found = std::ranges::find_if(
        all_, [&](const component& each) { return each.unknown == of.unknown && each.derivative == of.derivative; });
    return static_cast<std::size_t>(found - all_.begin());
}

exact problem_layout::time(const std::vector<std::string>& cells, bool as_double) const {
    return reading_cell({trimmed(cells[*time_]), own_time_}, [&](const std::string& text) {
        const exact time = time_in(text);
        if (time.has_periods()) {
            throw error(error_kind::argument, "time", text, "is a multiple of a period, which a problem has not");
        }
        return as_double ? nearest_double(time) : time;
    });
}

// Two marches, and where they are.
struct problem_questions::march_pair {
    long digits;
    std::unique_ptr<ode::taylor_march<mpfr>> first;
    std::unique_ptr<ode::taylor_march<mpfr>> second;

    march_pair(const ode::explicit_system& system, long printed) : digits(printed) {
        first = made(system, first_guard);
        second = made(system, second_guard);
    }

    std::unique_ptr<ode::taylor_march<mpfr>> made(const ode::explicit_system& system, long guard) const {
        const precision_scope scope(digits + guard);
        return std::make_unique<ode::taylor_march<mpfr>>(system);
    }

    ode::solution_state<mpfr> state(ode::taylor_march<mpfr>& march, const exact& time, long guard) const {
        const precision_scope scope(digits + guard);
        return march.advance_to(ode::constant_value<mpfr>::of(as_expression(time)));
    }
};

problem_questions::march_pair& problem_questions::marches(long digits) {
    auto& made = by_digits_[digits];
    if (!made) {
        made = std::make_shared<march_pair>(layout_.system(), digits);
    }
    return *made;
}

// A proved march with its latest time, and its bits.
struct problem_questions::proved_way {
    std::unique_ptr<ode::proved_march> march;
    ode::number latest;
    long bits = 0;
};

// All unknowns and their lower derivatives, in order. More bits where the enclosure becomes too wide on the way.
std::vector<ball> problem_questions::proved_state(const exact& time, long digits) {
    const auto& system = layout_.system();
    const ode::number at = as_expression(time);
    auto& way = proved_by_digits_[digits];
    if (!way) {
        way = std::make_shared<proved_way>();
        way->bits = digits * 3322 / 1000 + first_proof_bits;
    }
    const int direction = (at - system.point()).sign();
    while (way->bits <= most_proof_bits) {
        if (!way->march || ((at - way->latest) * ode::number(rational(direction))).sign() < 0) {
            way->march = std::make_unique<ode::proved_march>(system, way->bits);
        }
        way->latest = at;
        if (const auto state = way->march->at(at)) {
            return *state;
        }
        if (way->march->end() == ode::march_end::steps) {
            break;
        }
        way->march.reset();
        way->bits *= 2;
    }
    throw error(error_kind::undecided, "time", time.text, "is not reached by a proof: a singularity is near, or chaos");
}

std::vector<true_value> problem_questions::truths_at(const exact& time, long digits) {
    const auto& system = layout_.system();
    std::vector<true_value> truths;
    if (is_start(system, time)) {
        for (const auto& [unknown, derivative] : layout_.components()) {
            const ode::number& value = system.starts()[unknown][derivative];
            truths.push_back({ode::constant_value<ball>::of(value), value.fraction()});
        }
        return truths;
    }
    if (!system.singular()) {
        const auto state = proved_state(time, digits);
        for (const auto& each : layout_.components()) {
            truths.push_back({state[layout_.place_of(each)]});
        }
        return truths;
    }
    march_pair& pair = marches(digits);
    const auto a = pair.state(*pair.first, time, first_guard);
    const auto b = pair.state(*pair.second, time, second_guard);
    const precision_scope scope(digits + second_guard);
    const mpfr last = pow(mpfr(10), static_cast<int>(-digits));
    for (const auto& [unknown, derivative] : layout_.components()) {
        const mpfr& here = b[unknown][derivative];
        const mpfr apart = abs(mpfr(a[unknown][derivative] - here)) * 16 + abs(here) * last;
        truths.push_back({enclose(ball(here), ball(apart))});
    }
    return truths;
}

// |t y'|/max(1, |y|) of the first column, from a singular start.
std::string problem_questions::condition_of_slope(const exact& time, long digits) {
    const auto& system = layout_.system();
    const auto [unknown, derivative] = layout_.components().front();
    if (time.is_zero()) {
        return "0";
    }
    if (is_start(system, time)) {
        return "inf";
    }
    march_pair& pair = marches(digits);
    const auto state = pair.state(*pair.second, time, second_guard);
    const precision_scope scope(digits + second_guard);
    const mpfr t = ode::constant_value<mpfr>::of(as_expression(time));
    const ode::tape tape = ode::tape::about_points(system);
    ode::taylor_expansion<mpfr> there(tape, 1);
    there.about(t, state);
    const mpfr slope = there.coefficients(static_cast<int>(unknown), static_cast<int>(derivative))[1];
    const mpfr size = abs(state[unknown][derivative]);
    return to_decimal(mpfr(abs(mpfr(t * slope)) / (size > 1 ? size : mpfr(1))), 3);
}

// A march that keeps its derivative by starts and parameters, and where it was asked last.
struct problem_questions::dependent_way {
    explicit dependent_way(const ode::equation_system& equations) : on(equations) {}

    ode::dependence on;
    std::unique_ptr<ode::proved_march> march;
    ode::number latest;
    long bits = first_proof_bits;
    long error_bits = ode::proved_march::usual_error_bits;
};

// Three digits. Nothing where so many bits do not settle them.
std::optional<std::vector<ode::moved_value>> problem_questions::moved_at(const ode::number& time) {
    if (!dependent_) {
        dependent_ = std::make_shared<dependent_way>(layout_.equations());
    }
    dependent_way& way = *dependent_;
    const auto& system = way.on.system();
    const int direction = (time - system.point()).sign();
    while (way.bits <= most_proof_bits && way.error_bits <= most_error_bits) {
        if (!way.march || ((time - way.latest) * ode::number(rational(direction))).sign() < 0) {
            way.march = std::make_unique<ode::proved_march>(system, way.bits, ode::march_watch(), way.error_bits);
            way.march->keep_derivative();
        }
        way.latest = time;
        if (const auto state = way.march->at(time)) {
            if (auto moved = way.on.moved(*way.march, time, *state, 0)) {
                return moved;
            }
            way.error_bits *= 2;
        } else if (way.march->end() == ode::march_end::steps) {
            return std::nullopt;
        }
        way.march.reset();
        way.bits *= 2;
    }
    return std::nullopt;
}

std::string problem_questions::condition_at(const exact& time, long digits) {
    if (layout_.system().singular()) {
        return condition_of_slope(time, digits);
    }
    const auto moved = moved_at(as_expression(time));
    if (!moved) {
        return "inf";
    }
    const auto truths = truths_at(time, digits);
    const precision_scope few(20);
    mpfr largest(0);
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const ode::moved_value& own = (*moved)[layout_.place_of(layout_.components()[i])];
        const mpfr size = abs(midpoint_of(truths[i].value()));
        const mpfr sum = own.by_start + own.by_parameters + own.by_time;
        largest = std::max(largest, mpfr(sum / (size > 1 ? size : mpfr(1))));
    }
    return to_decimal(largest, 3);
}

row_question problem_questions::read(const std::vector<std::string>& cells) {
    const exact time = layout_.time(cells, rules_.inputs_are_doubles);
    row_question question;
    question.first_digits = [](long places) { return (places + 29) / 10 * 10; };
    question.truths = [this, time](long digits) { return truths_at(time, digits); };
    question.condition = [this, time](long digits) { return condition_at(time, digits); };
    return question;
}

}  // namespace libration
