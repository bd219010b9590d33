// A step of theorem K in integers, with few bits.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "../../integration/collocation/tube_proof.hpp"
#include "libration/integration/collocation/tube.hpp"

namespace libration::ode {

/// 2^-k (a_0 + sum_(j > 0) 2 a_j T_j(x)): integers a_0, a_1, ... with the exponent k in another place.
using integer_list = std::vector<ball>;

/// The numbers of a step in a certificate; matrices by rows. W is the approximate inverse of V.
struct certificate_step {
    ball length;
    std::vector<long> scales;
    std::vector<std::size_t> blocks;
    long curve_bits = 0;             ///< the exponent of p
    std::vector<long> frame_bits;    ///< of each column of V
    std::vector<long> inverse_bits;  ///< of each row of W
    std::vector<integer_list> curve, frame, inverse;
    std::vector<magnitude> first, last;
};

/// A rule of collocation_integrator (tube_rule): rounds the polynomials of each step to integers, as coarse as possible
/// without an essential loss of the radii, and proves the tube from the rounded ones.
class step_rounding {
public:
    /// Radii of scaled unknowns below 2^-negligible_bits need not be smaller; polynomials have at most `finest` bits behind
    /// the point.
    step_rounding(long negligible_bits, long finest) : negligible_bits_(negligible_bits), finest_(finest) {}

    std::optional<solution_tube> tube(tube_proof& by, const tube_candidate& found, const tube_set& start);
    /// The last step for which a tube was proved; std::nullopt before the first.
    const std::optional<certificate_step>& step() const { return step_; }

private:
    /// Exponents of p, of slow columns of V, of slow and of fast rows of W.
    struct exponents {
        long curve = 40, frame = 20, slow_rows = 20, fast_rows = 16;
    };
    struct attempt;

    long negligible_bits_, finest_;
    exponents last_;
    std::optional<certificate_step> step_;
};

}  // namespace libration::ode
