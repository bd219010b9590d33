#include "libration/asymptotics/circle_mean.hpp"

#include <cmath>
#include <numbers>

#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int deepest_sharp_arc = 14;
constexpr int deepest_tip_arc = 4;
constexpr int deepest_arc = 26;

struct arc_bounds {
    magnitude above;
    double below = 0;
};

class arc_sum {
public:
    arc_sum(const charted_covering& covering, double rho, const tip_bound& of_tip)
        : covering_(covering), rho_(rho), of_tip_(of_tip) {}

    // The integral of |y| over the angles of all arcs of the upper half plane.
    magnitude of_all() {
        for (const covered_cell& each : covering_.cells()) {
            if (each.cell.r2 == rho_) {
                add({rho_, rho_, each.cell.a1, each.cell.a2}, each, 0);
            }
        }
        return sum_;
    }

private:
    void add(const plane_cell& arc, const covered_cell& of, int depth) {
        const arc_bounds bounds = bounds_over(arc, of);
        const bool finite = bounds.above.is_finite();
        const double above = bounds.above.above();
        const bool sharp = of.in_tip ? above <= 2 * bounds.below || depth >= deepest_tip_arc
                                     : above <= 1.2 * bounds.below || depth >= deepest_sharp_arc;
        if (finite && (sharp || above * (arc.a2 - arc.a1) < 1e-3 * sum_.above())) {
            // Wider by the rounding of the ends.
            sum_ += bounds.above * magnitude::at_least((arc.a2 - arc.a1) * (1 + 1e-12) + 1e-15, 0);
            return;
        }
        if (depth >= deepest_arc) {
            const std::complex<double> place = arc.corners().front();
            throw error(error_kind::undecided, error_subject::problem, "",
                        "is not proved to be bounded on |t - t0| = " + std::to_string(rho_) + " near " +
                            std::to_string(place.real()) + " + " + std::to_string(place.imag()) +
                            "i: a singularity is on the circle or close to it; take another rho with --within");
        }
        const double middle = (arc.a1 + arc.a2) / 2;
        add({rho_, rho_, arc.a1, middle}, of, depth + 1);
        add({rho_, rho_, middle, arc.a2}, of, depth + 1);
    }

    arc_bounds bounds_over(const plane_cell& arc, const covered_cell& of) const {
        const complex_ball over = arc.enclosure();
        arc_bounds result{infinite(), 0};
        if (of.in_tip) {
            result.above = of_tip_(of.holder, over);
            result.below = result.above.above() / 4;
            return result;
        }
        const covering_piece& piece = covering_.pieces()[of.holder];
        try {
            const complex_ball y = covering_.atlas().value(piece.chart, piece.disc.over(over));
            if (is_finite(y.re) && is_finite(y.im)) {
                result.above = size_of(y);
                result.below = std::hypot(magnitude::below(y.re).above(), magnitude::below(y.im).above());
            }
        } catch (const precision_exhausted&) {
            // the enclosure of the arc leaves the disc
        }
        return result;
    }

    static magnitude infinite() { return magnitude(1U) / magnitude(0U); }

    const charted_covering& covering_;
    double rho_;
    const tip_bound& of_tip_;
    magnitude sum_;
};

}  // namespace

magnitude circle_mean(const charted_covering& covering, double rho, const tip_bound& of_tip) {
    const precision_scope few(20);
    const magnitude sum = arc_sum(covering, rho, of_tip).of_all();
    return sum * magnitude::at_least(1 / std::numbers::pi * (1 + 1e-12), 0);
}

}  // namespace libration::ode
