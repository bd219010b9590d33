#include "first_step.hpp"

namespace libration::ode {

std::vector<ball> singular_first_step::values(const ball& distance) const {
    const precision_scope scope(decimal_digits(bits_) + 10);
    return first_.series->at(distance);
}

ball_matrix singular_first_step::derivative(const ball& distance) const {
    return product(derivative_beyond_start(of_, distance, error_bits_, route_), *from().derivative);
}

flow_state singular_first_step::end() const {
    flow_state result{end_time(), box_around(first_.state, bits_), {}, {}};
    if (from().derivative) {
        result.derivative = derivative(length());
    }
    return result;
}

}  // namespace libration::ode
