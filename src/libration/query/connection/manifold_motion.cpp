// The motion on the invariant manifold of an end: theorem W2.
#include <algorithm>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "manifold_end.hpp"

namespace libration::ode {

namespace {

magnitude largest_coordinate(const std::vector<complex_ball>& theta) {
    magnitude result;
    for (const complex_ball& each : theta) {
        result = std::max(result, size_of_complex(each));
    }
    return result;
}

}  // namespace

std::vector<complex_ball> manifold_end::coordinates(const std::vector<ball>& theta) const {
    std::vector<complex_ball> result;
    for (std::size_t j = 0; j < plan_.size(); ++j) {
        result.push_back(plan_.ends_pair(j) ? conjugate(result.back())
                                            : complex_ball(theta[j], plan_.begins_pair(j) ? theta[j + 1] : ball(0)));
    }
    return result;
}

std::optional<std::vector<std::vector<ball>>> manifold_end::along(const std::vector<ball>& numbers,
                                                                  const std::vector<ball>& theta,
                                                                  const std::vector<ball>& times, int degree) const {
    degree = std::max(degree, least_degree());
    std::vector<complex_ball> box;
    for (const ball& each : numbers) {
        box.emplace_back(each, ball(0));
    }
    const auto points = series(box, false, degree);
    const auto tails = points && points->moves_linearly() ? points->tails() : std::nullopt;
    if (!tails) {
        return std::nullopt;
    }
    const auto start = coordinates(theta);
    std::vector<std::vector<ball>> result;
    for (const ball& time : times) {
        std::vector<complex_ball> now;
        for (std::size_t j = 0; j < start.size(); ++j) {
            const complex_ball exponent = points->rates()[j].value * complex_ball(time, ball(0));
            const ball size = exp(exponent.re);
            now.push_back(start[j] * complex_ball(size * cos(exponent.im), size * sin(exponent.im)));
        }
        const magnitude radius = largest_coordinate(now);
        if (!(radius < magnitude(1U))) {
            return std::nullopt;
        }
        const magnitude power = pow(radius, static_cast<unsigned long>(degree) + 1);
        const auto p = points->at(now);
        auto& state = result.emplace_back();
        for (std::size_t i = 0; i < given_moving_.size(); ++i) {
            state.push_back(widened(p.value[i].value.re, (*tails)[i] * power));
        }
    }
    return result;
}

}  // namespace libration::ode
