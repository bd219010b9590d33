#include "libration/integration/collocation/collocation_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../algebra/rounded_matrix.hpp"
#include "collocation_solver.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "step_control.hpp"

namespace libration::ode {

namespace {

// From so many unknowns on values at nodes cost less than coefficients.
constexpr std::size_t least_unknowns_at_nodes = 7;

// Steps of many unknowns are expensive: the first one is tried with this multiple of the length that is given, half of
// the number of steps over which the solution is smooth.
constexpr double first_growth_of_many = 16;

std::vector<long double> rounded_constants(const polynomial_map& map) {
    const precision_scope scope(40);
    std::vector<long double> result;
    for (const number& each : map.constants()) {
        result.push_back(as_long_double(constant_value<ball>::of(each)));
    }
    return result;
}

}  // namespace

struct collocation_integrator::parts {
    parts(const polynomial_form& of, long bits, int more_terms, const tuning& by)
        : map(of),
          accuracy(collocation_accuracy::for_bits(bits, more_terms)),
          constants(map.enclosed_constants(accuracy.product_bits)),
          guide(map, rounded_constants(map)) {
        accuracy.slowest_fast = by.slowest_fast;
        accuracy.digits_below_width = by.digits_below_width;
    }

    // The costly parts, needed for the first step.
    void make_ready() {
        if (!nodes) {
            nodes = std::make_unique<collocation_points>(accuracy.degree, accuracy.product_bits);
            proof = std::make_unique<tube_proof>(map, accuracy.product_bits, accuracy.frame_bits, accuracy.node_bits);
            solver = std::make_unique<collocation_solver>(map, guide, *nodes, accuracy, constants);
        }
    }

    // The smallest scales: the errors of a step are then as many digits below the width of the set as the tuning states.
    // Where errors determine the width, it grows from step to step without such a distance.
    std::vector<magnitude> floors() const {
        const auto lower = static_cast<long>((accuracy.accepted - accuracy.digits_below_width) * std::log2(10.));
        std::vector<magnitude> result;
        for (std::size_t i = 0; i < map.size(); ++i) {
            result.push_back(set.reach(i).shifted(lower));
        }
        return result;
    }

    void change_length(double factor) {
        next = exactly(as_double(next) * factor);
        arb_set_round(next.handle(), next.handle(), bits_of_length);
        next = midpoint_alone(next);
    }

    // True if the step of the present length is proved; otherwise changes the length.
    bool attempt(const std::shared_ptr<parts>& self) {
        const step_interval on{time, next};
        const auto ended = solver->solve(on, aimed, floors());
        if (ended != collocation_solver::outcome::solved) {
            change_length(ended == collocation_solver::outcome::too_long ? length_growth::reduction(solver->factor())
                                                                         : 0.5);
            return false;
        }
        const double factor = solver->factor();
        auto candidate = solver->candidate(!rule && map.size() >= least_size_in_double);
        auto proved = candidate ? proved_tube(*candidate) : std::nullopt;
        if (!proved) {
            change_length(0.5);
            return false;
        }
        tube = std::make_shared<step_tube>(self, std::move(*proved));
        const precision_scope scope(decimal_digits(accuracy.product_bits));
        found_end = end_of(candidate->curve, candidate->scales);
        growth.accept(factor);
        return true;
    }

    std::optional<solution_tube> proved_tube(const tube_candidate& found) const {
        if (rule) {
            return rule(*proof, found, set);
        }
        const bool few = map.size() < least_unknowns_at_nodes;
        return proof->tube(found, set, few ? supremum_rule::coefficients : supremum_rule::nodes);
    }

    static constexpr slong bits_of_length = 24;

    polynomial_map map;
    collocation_accuracy accuracy;
    std::vector<ball> constants;
    stiff_guide guide;
    std::unique_ptr<collocation_points> nodes;
    std::unique_ptr<tube_proof> proof;
    std::unique_ptr<collocation_solver> solver;
    ball time, next;
    tube_set set;
    // The set about the end of the last curve that was found. If a rule rounds the curve, the centre of the set is moved
    // by more than the errors of a step: in fast modes an initial layer that would keep steps short.
    tube_set aimed;
    std::vector<ball> found_end;
    std::shared_ptr<const step_tube> tube;
    tube_rule rule;
    length_growth growth;
    int without_fast = 0;
};

collocation_integrator::collocation_integrator(const polynomial_form& of, long bits, int more_terms, const tuning& by)
    : parts_(std::make_shared<parts>(of, bits, more_terms, by)) {}
collocation_integrator::~collocation_integrator() = default;

void collocation_integrator::prove_by(tube_rule rule) { parts_->rule = std::move(rule); }

bool collocation_integrator::is_smooth_over(const ball& time, const std::vector<ball>& state,
                                            const ball& length) const {
    std::vector<long double> start;
    for (const ball& each : state) {
        start.push_back(as_long_double(each));
        if (start.size() <= parts_->map.given() && start.back() == 0 && arb_is_zero(each.handle()) == 0) {
            return false;  // below the range of double
        }
    }
    return parts_->guide.is_smooth_over_steps(as_long_double(time), start, as_long_double(length), parts_->map.given());
}

void collocation_integrator::begin(const ball& time, tube_set start, const ball& length) {
    parts_->make_ready();
    parts_->time = time;
    parts_->set = std::move(start);
    parts_->aimed = parts_->set;
    parts_->next = length;
    parts_->change_length(parts_->map.size() < least_size_in_double ? 1 : first_growth_of_many);
    parts_->tube.reset();
    parts_->growth.restart();
    parts_->without_fast = 0;
}

bool collocation_integrator::prepare() {
    for (int rejected = 0; !parts_->tube && rejected < length_growth::most_rejections; ++rejected) {
        if (parts_->attempt(parts_)) {
            return true;
        }
        parts_->growth.restart();
    }
    return parts_->tube != nullptr;
}

const ball& collocation_integrator::length() const { return parts_->tube->length(); }

const ball& collocation_integrator::next_length() const { return parts_->next; }

std::vector<ball> collocation_integrator::values_at(const ball& distance) const {
    return parts_->tube->values_at(distance);
}

std::shared_ptr<const step_tube> collocation_integrator::prepared() const { return parts_->tube; }

std::vector<ball> step_tube::values_at(const ball& distance) const {
    const precision_scope scope(decimal_digits(by_->accuracy.product_bits));
    return tube_.values_at(distance);
}

std::vector<ball> step_tube::slopes_at(const ball& distance) const {
    const precision_scope scope(decimal_digits(by_->accuracy.product_bits));
    std::call_once(has_slope_errors_, [this] { slope_errors_ = by_->proof->slope_errors(tube_); });
    return tube_.slopes_at(distance, *slope_errors_);
}

tube_set step_tube::end() const { return tube_.end(by_->accuracy.product_bits, by_->accuracy.frame_bits); }

void collocation_integrator::step() {
    parts& now = *parts_;
    arb_add(now.time.handle(), now.time.handle(), now.tube->length().handle(), ARF_PREC_EXACT);
    now.without_fast = now.tube->tube().slow == now.map.size() ? now.without_fast + 1 : 0;
    now.set = now.tube->end();
    now.aimed = now.set;
    now.aimed.centre = std::move(now.found_end);
    now.tube.reset();
    now.change_length(now.growth.factor());
}

const ball& collocation_integrator::reached() const { return parts_->time; }
int collocation_integrator::degree() const { return parts_->accuracy.degree; }
long collocation_integrator::bits() const { return parts_->accuracy.bits; }
const tube_set& collocation_integrator::set() const { return parts_->set; }
int collocation_integrator::steps_without_fast_modes() const { return parts_->without_fast; }

}  // namespace libration::ode
