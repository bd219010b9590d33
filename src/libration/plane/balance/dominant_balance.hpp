// The leading behaviour of a polynomial system at a movable singularity, by exact arithmetic.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "field_terms.hpp"
#include "surd_matrix.hpp"

namespace libration::ode {

// What the limit of x^m y is: nonzero; 0; or, with m = 0 and no influence on the others there, any number.
enum class balance_role { nonzero, zero, finite };

// c t^s y^e in the derivative of y_i, which is x^excess relative to x y_i' in size; for excess 0 with a share w, the limit of
// its quotient by x dy_i/dx (of y_i for a vanishing one).
struct balance_term {
    std::size_t row = 0;
    field_term of;
    rational excess;
    std::optional<rational> share = {};
};

// y_i = x^-m_i S_i V_i, x = 1 - (t - t0)/(t* - t0), with V = 1, 0, or any number at x = 0. Then
//     x dV_i/dx = m_i V_i + sum of w V^e + terms with positive powers of x,
// and the shares w are rational: every rational guess of them with sum of w = -m_i is that of exact numbers S_i near the observed ones if the
// equations c S^e/S_i = -w/(t* - t0) are consistent, which exact arithmetic decides (a product of powers of w/c along each relation of
// their exponents is 1). The matrix of the linear terms is then rational. Its eigenvalues are the resonances: -1, 0 as
// often as the S_i and finite limits have free parameters, and the others with positive real parts.
struct dominant_balance {
    std::vector<rational> orders;  // m
    std::vector<balance_role> roles;
    std::vector<balance_term> terms;
    rational step;                    // all positive powers of x are multiples of it; 0 without any
    std::vector<std::size_t> finite;  // parameters: the finite limits,
    std::vector<std::size_t> free;    // then log S of these
    std::vector<std::size_t> pivots;  // log S of these follow from the equations of these terms:
    std::vector<std::size_t> equations;
    std::vector<std::vector<rational>> inverse;  // log S_pivots = inverse (logs of the equations - free columns)
    std::vector<std::complex<double>> factors;   // c of each equation, about
    std::complex<double> place;                  // t* - t0, about
    std::vector<long> turns;                     // multiples of 2 pi i in the logs
    std::vector<quadratic_number> eigenvalues;   // of V - limit = Q w, by component of w
    surd_matrix columns, inverse_columns;        // Q, Q^-1
    std::size_t translation = 0;                 // the component with -1
    std::vector<std::size_t> growing;            // those with positive real parts

    // Exponents of an equation of a term.
    std::vector<int> exponents_of(const balance_term& term) const;
};

// Observed values of the unknowns at x = 2^-level and at twice this x, and t* - t0.
struct balance_sample {
    std::complex<double> place;
    double origin = 0;
    int level = 0;
    std::vector<std::complex<double>> values = {}, before = {};
};

// The principal log of an exact number, plus the principal log of z/near: continuous in z about it.
complex_number<ball> logarithm_near(const complex_number<ball>& z, std::complex<double> near);

// Throws error of the kind undecided, with the reason, for a leading behaviour that is not of this form.
dominant_balance dominant_balance_of(const std::vector<std::vector<field_term>>& rows, const balance_sample& sample);

[[noreturn]] void refuse_balance(const std::complex<double>& place, const std::string& why);

// Sets the eigenvalues and their vectors from the terms. Throws error as dominant_balance_of.
void set_resonances(dominant_balance& of);

}  // namespace libration::ode
