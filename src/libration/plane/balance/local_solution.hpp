// The local solutions at a balance for given parameters: coefficients, variables, and values at a base.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "local_field.hpp"

namespace libration::ode {

using complex_row = std::vector<complex_ball>;
using complex_matrix = std::vector<complex_row>;

complex_ball middle_of(const complex_ball& z);
// An approximate inverse of the midpoints. Throws precision_exhausted if there is none.
complex_matrix inverse_near(complex_matrix a);
complex_row product(const complex_matrix& a, const complex_row& b);
complex_row product_of_polynomials(const complex_row& a, const complex_row& b);

struct local_model {
    complex_row x;
    complex_row scales;  // S
    balance_field<complex_ball> field;
    balance_series<complex_ball> series;
};

// Parameters x: t* - t0, the finite limits, the free log S, and the coefficients at the growing resonances.
class local_solution {
public:
    local_solution(dominant_balance balance, complex_ball origin)
        : balance_(std::move(balance)), field_(balance_), origin_(std::move(origin)) {}
    local_solution(const local_solution&) = delete;
    local_solution& operator=(const local_solution&) = delete;

    void set_base(std::complex<double> base) { base_ = base; }
    const dominant_balance& balance() const { return balance_; }
    const local_field& field() const { return field_; }
    const complex_ball& origin() const { return origin_; }
    std::size_t size() const { return balance_.orders.size(); }
    std::size_t first_growing() const { return 1 + balance_.finite.size() + balance_.free.size(); }
    // Of the variables.
    std::vector<quadratic_number> weights() const;
    complex_row finite_of(const complex_row& x) const {
        return {x.begin() + 1, x.begin() + 1 + static_cast<std::ptrdiff_t>(balance_.finite.size())};
    }

    local_model model_at(const complex_row& x, const weighted_monomials& monomials);
    // theta = x^weight times a polynomial in log x: its coefficients, by variable.
    std::vector<complex_row> variables_of(const local_model& model, const complex_row& x,
                                          const weighted_monomials& monomials) const;
    struct base_values {
        complex_row unknowns;  // x^-m S (limit + polynomial)
        complex_row theta;
        complex_row front;  // x^-m S
    };
    base_values values_at_base(const local_model& model, const complex_row& x,
                               const weighted_monomials& monomials) const;
    // Their derivatives by the parameters, by difference quotients, of models for those that the coefficients depend on.
    complex_matrix slopes_at(const local_model& model, const complex_row& x, const std::vector<magnitude>& steps,
                             const weighted_monomials& monomials);

private:
    bool has_step() const { return balance_.step != 0; }

    dominant_balance balance_;
    local_field field_;
    complex_ball origin_;
    std::complex<double> base_;
    std::optional<balance_series<complex_ball>> known_series_;  // if they do not depend on the parameters
    std::size_t known_count_ = 0;
    long known_bits_ = 0;
};

}  // namespace libration::ode
