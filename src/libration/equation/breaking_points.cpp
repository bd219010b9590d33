#include "libration/equation/breaking_points.hpp"

namespace libration::ode {

breaking_points::breaking_points(const number& start, const std::vector<number>& delays)
    : delays_(delays), points_{start}, next_(delays.size()) {}

const number& breaking_points::operator[](std::size_t k) {
    while (points_.size() <= k) {
        number least = points_[next_[0]] + delays_[0];
        std::vector<std::size_t> at_least{0};
        for (std::size_t j = 1; j < delays_.size(); ++j) {
            const number sum = points_[next_[j]] + delays_[j];
            const int sign = (sum - least).sign();
            if (sign < 0) {
                least = sum;
                at_least.clear();
            }
            if (sign <= 0) {
                at_least.push_back(j);
            }
        }
        for (const std::size_t j : at_least) {
            ++next_[j];
        }
        points_.push_back(least);
    }
    return points_[k];
}

}  // namespace libration::ode
