// Matrices of numbers of a quadratic field, exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/algebra/rational_polynomial.hpp"
#include "quadratic_number.hpp"

namespace libration::ode {

using surd_matrix = std::vector<std::vector<quadratic_number>>;

// Reduces rows in place, with 1 at the pivots and 0 elsewhere in their columns, of which there may be more than the ones that are searched; the columns of
// the pivots by row.
std::vector<std::size_t> reduce_rows(surd_matrix& a, std::size_t columns);
// A basis of the x with a x = 0.
std::vector<std::vector<quadratic_number>> null_space(surd_matrix a, std::size_t columns);
surd_matrix inverse_of(const surd_matrix& a);
// By the method of Faddeev and LeVerrier.
rational_polynomial characteristic_of(const std::vector<std::vector<rational>>& k);
// The root of a square.
std::optional<rational> rational_root(const rational& x);

}  // namespace libration::ode
