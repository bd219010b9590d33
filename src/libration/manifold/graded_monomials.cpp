#include "graded_monomials.hpp"

namespace libration::ode {

graded_monomials::graded_monomials(std::size_t variables, int highest) : variables_(variables), steps_(variables) {
    std::size_t step = 1;
    for (std::size_t j = 1; j < variables; ++j, step *= static_cast<std::size_t>(highest) + 1) {
        steps_[j] = step;
    }
    for (int degree = 0; degree <= highest; ++degree) {
        all_.emplace_back();
        std::vector<int> exponents(variables);
        extend(exponents, 1, degree, 0);
    }
}

std::size_t graded_monomials::places(int degree) const { return 1 + static_cast<std::size_t>(degree) * steps_.back(); }

void graded_monomials::extend(std::vector<int>& exponents, std::size_t j, int left, std::size_t place) {
    if (j >= variables_) {
        exponents.front() = left;
        all_.back().push_back({exponents, place});
        return;
    }
    for (int m = 0; m <= left; ++m) {
        exponents[j] = m;
        extend(exponents, j + 1, left - m, place + static_cast<std::size_t>(m) * steps_[j]);
    }
    exponents[j] = 0;
}

}  // namespace libration::ode
