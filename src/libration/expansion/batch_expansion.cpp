#include "libration/expansion/batch_expansion.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "batch_vectors.hpp"

namespace libration::ode {

template class step_arrays<lane_numbers>;

struct batch_expansion::program {
    lane_program of;
    std::vector<lane_numbers> ahead;  // two for each step
    std::function<void(int, int)> otherwise;
};

// Translates the steps of a tape, and finds those that depend on parameters alone.
class batch_expansion::program_builder {
public:
    explicit program_builder(batch_expansion& to) : to_(to), steps_(to.tape_.steps()) {}

    lane_program run() {
        lane_program made;
        for (int n = 0; n <= to_.order_; ++n) {
            made.degrees.emplace_back(n);
        }
        to_.program_->ahead.resize(2 * steps_.size());
        made.steps_until = to_.order_ - *std::ranges::min_element(to_.tape_.orders());
        fixed_ = std::vector<bool>(steps_.size(), false);
        mark_parameters();
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            add(made, static_cast<int>(i));
        }
        std::size_t component = 0;
        for (std::size_t k = 0; k < to_.tape_.orders().size(); ++k) {
            const auto order = static_cast<std::size_t>(to_.tape_.orders()[k]);
            add_states(made, to_.tape_.outputs()[k], component, order);
            component += order;
        }
        return made;
    }

private:
    const tape_step& step_at(int i) const { return steps_[static_cast<std::size_t>(i)]; }
    bool is_fixed(int i) const { return fixed_[static_cast<std::size_t>(i)]; }
    double* array(int i) const { return to_.arrays_.array(i)->lane.data(); }
    const double* operand(int i) const { return i < 0 ? nullptr : array(i); }

    void mark_parameters() {
        for (std::size_t i = 0; i < to_.components_.size(); ++i) {
            if (to_.parameters_[i]) {
                const auto place =
                    (to_.components_[i] - to_.arrays_.array(0)) / static_cast<std::ptrdiff_t>(to_.arrays_.length());
                fixed_[static_cast<std::size_t>(place)] = true;
            }
        }
    }

    bool depends_on_parameters_alone(const tape_step& step) const {
        switch (step.kind) {
            case operation::constant: return true;
            case operation::state:
            case operation::variable:
            case operation::by_variable:
            case operation::delayed: return false;
            case operation::sum:
            case operation::difference:
            case operation::scaled:
            case operation::raised:
            case operation::product:
            case operation::square:
            case operation::quotient:
            case operation::slope:
            case operation::square_root:
            case operation::power:
            case operation::function:
            case operation::primitive:
            case operation::companion: break;
        }
        return is_fixed(step.left) && (step.right < 0 || is_fixed(step.right));
    }

    // A parameter on either side is one factor for all coefficients.
    lane_operation product_of(const tape_step& step) const {
        return is_fixed(step.left) || is_fixed(step.right) ? lane_operation::lane_multiple : lane_operation::product;
    }

    static lane_operation function_of(const tape_step& step) {
        static constexpr std::array<std::pair<function_kind, lane_operation>, 6> in_vectors{
            {{function_kind::sin, lane_operation::sine_cosine},
             {function_kind::sinh, lane_operation::hyperbolic_sine_cosine},
             {function_kind::exp, lane_operation::exponential},
             {function_kind::log, lane_operation::logarithm},
             {function_kind::tan, lane_operation::tangent},
             {function_kind::tanh, lane_operation::hyperbolic_tangent}}};
        const auto* const found =
            std::ranges::find(in_vectors, step.function, [](const auto& each) { return each.first; });
        return found == in_vectors.end() ? lane_operation::other : found->second;
    }

    lane_operation kind_of(const tape_step& step) const {
        switch (step.kind) {
            case operation::sum: return lane_operation::sum;
            case operation::difference: return lane_operation::difference;
            case operation::scaled: return lane_operation::multiple;
            case operation::raised: return lane_operation::copy;
            case operation::product: return product_of(step);
            case operation::square: return lane_operation::square;
            case operation::quotient:
                return is_fixed(step.right) ? lane_operation::lane_quotient : lane_operation::quotient;
            case operation::slope: return lane_operation::slope;
            case operation::square_root: return lane_operation::square_root;
            case operation::primitive: return lane_operation::primitive;
            case operation::power: return lane_operation::power;
            case operation::function: return function_of(step);
            case operation::constant:
            case operation::variable:
            case operation::state:
            case operation::by_variable:
            case operation::delayed:
            case operation::companion: break;
        }
        return lane_operation::other;
    }

    lane_step made_of(const tape_step& step, int index) const {
        const bool swapped = step.kind == operation::product && is_fixed(step.left);
        const bool has_next = static_cast<std::size_t>(index) + 1 < steps_.size();
        return {kind_of(step),
                index,
                array(index),
                has_next ? array(index + 1) : nullptr,
                operand(swapped ? step.right : step.left),
                operand(swapped ? step.left : step.right),
                operand(step.derivative),
                step.constant < 0 ? static_cast<double>(step.numerator)
                                  : to_.arrays_.constants()[static_cast<std::size_t>(step.constant)][0],
                degree(step.denominator),
                to_.program_->ahead[2 * static_cast<std::size_t>(index)].lane.data()};
    }

    // Whether coefficient 0 follows the rule of the others.
    static bool from_zero(lane_operation kind) {
        switch (kind) {
            case lane_operation::sum:
            case lane_operation::difference:
            case lane_operation::multiple:
            case lane_operation::lane_multiple:
            case lane_operation::product:
            case lane_operation::square:
            case lane_operation::quotient:
            case lane_operation::lane_quotient:
            case lane_operation::slope: return true;
            case lane_operation::copy:
            case lane_operation::square_root:
            case lane_operation::primitive:
            case lane_operation::sine_cosine:
            case lane_operation::hyperbolic_sine_cosine:
            case lane_operation::exponential:
            case lane_operation::logarithm:
            case lane_operation::tangent:
            case lane_operation::hyperbolic_tangent:
            case lane_operation::power:
            case lane_operation::other: break;
        }
        return false;
    }

    void add(lane_program& made, int index) {
        const tape_step& step = step_at(index);
        if (step.kind == operation::companion) {
            fixed_[static_cast<std::size_t>(index)] = is_fixed(index - 1);
            return;
        }
        if (step.kind == operation::state) {
            return;
        }
        if (step.kind == operation::constant) {
            to_.arrays_.compute(index, 0);
            fixed_[static_cast<std::size_t>(index)] = true;
            return;
        }
        fixed_[static_cast<std::size_t>(index)] = depends_on_parameters_alone(step);
        lane_step translated = made_of(step, index);
        if (!is_fixed(index)) {
            made.later.push_back(translated);
        }
        if (!from_zero(translated.kind)) {
            translated.kind = lane_operation::other;
        }
        made.first.push_back(translated);
    }

    // The slope of the highest of the derivatives of an unknown is a step, that of the others the next one.
    void add_states(lane_program& made, int output, std::size_t component, std::size_t order) const {
        const double* above = array(output);
        for (std::size_t j = order; j-- > 0;) {
            lane_numbers* const here = to_.components_[component + j];
            if (!to_.parameters_[component + j]) {
                made.states.push_back({here->lane.data(), above});
            }
            above = here->lane.data();
        }
    }

    batch_expansion& to_;
    const std::vector<tape_step>& steps_;
    std::vector<bool> fixed_;
};

batch_expansion::batch_expansion(const explicit_system& system, int order, std::vector<bool> parameters)
    : tape_(tape::about_points(system)),
      order_(order),
      parameters_(std::move(parameters)),
      arrays_(tape_, order, nullptr),
      program_(std::make_unique<program>()) {
    std::vector<std::size_t> first(tape_.orders().size(), 0);
    for (std::size_t k = 0; k + 1 < first.size(); ++k) {
        first[k + 1] = first[k] + static_cast<std::size_t>(tape_.orders()[k]);
    }
    components_.resize(names_of_state(system).size());
    parameters_.resize(components_.size(), false);
    for (const tape_state& each : tape_.states()) {
        components_[first[static_cast<std::size_t>(each.unknown)] + static_cast<std::size_t>(each.derivative)] =
            arrays_.array(each.step);
    }
    for (std::size_t i = 0; i < components_.size(); ++i) {
        if (!parameters_[i]) {
            moving_.push_back(components_[i]->lane.data());
            places_.push_back(i);
        }
    }
    values_.resize(moving_.size());
    program_->of = program_builder(*this).run();
    program_->otherwise = [this](int step, int n) { compute(step, n); };
}

batch_expansion::~batch_expansion() = default;

void batch_expansion::about(const lane_numbers& points, std::span<const lane_numbers> states) {
    arrays_.begin_at(points);
    for (std::size_t i = 0; i < components_.size(); ++i) {
        *components_[i] = states[i];
    }
    run_batch(program_->of, program_->otherwise);
}

void batch_expansion::at(const lane_numbers& distances, std::span<lane_numbers> states) const {
    batch_values(moving_, order_, distances.lane.data(), values_.data()->lane.data());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        states[places_[i]] = values_[i];
    }
}

lane_numbers batch_expansion::sizes(int n) const {
    lane_numbers result;
    batch_sizes(moving_, n, result.lane.data());
    return result;
}

void batch_expansion::compute(int step, int n) { arrays_.compute(step, n); }

}  // namespace libration::ode
