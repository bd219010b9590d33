// Monomials in several variables, degree by degree, with places that add up in products.
#pragma once

#include <cstddef>
#include <vector>

namespace libration::ode {

/// The monomials theta^m of each degree up to a highest one. A monomial is at the place sum_{j > 1} m_j stride^(j-2), stride
/// = highest degree + 1, among those of its degree: the place in a product is the sum of the places.
class graded_monomials {
public:
    struct monomial {
        std::vector<int> exponents;
        std::size_t place;
    };

    graded_monomials(std::size_t variables, int highest);

    std::size_t variables() const { return variables_; }
    const std::vector<monomial>& of_degree(int degree) const { return all_[static_cast<std::size_t>(degree)]; }
    /// The number of places of a degree.
    std::size_t places(int degree) const;
    /// The step of the place for theta_j instead of theta_0.
    std::size_t step_of(std::size_t j) const { return steps_[j]; }

private:
    void extend(std::vector<int>& exponents, std::size_t j, int left, std::size_t place);

    std::size_t variables_;
    std::vector<std::size_t> steps_;
    std::vector<std::vector<monomial>> all_;
};

}  // namespace libration::ode
