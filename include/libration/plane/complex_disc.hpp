// Proved enclosures of the solution of any system in the complex t-plane: theorems T and V about any point of a path.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/integration/lohner_set.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/integration/singular_step.hpp"

namespace libration::ode {

using complex_ball = complex_number<ball>;

/// An enclosure of the solution at the time t0 + offset, t0 the initial point:
///     Re y_i in Re centre_i + 2^scales_i e_i,  Im y_i in Im centre_i + 2^scales_i e_(d+i),  e in the error set,
/// centre and offset exact. The scales follow the sizes of the unknowns, which differ by powers of the distance near a
/// singularity: without them an error set there would be only as accurate as its worst unknown.
struct complex_set {
    complex_ball offset;
    std::vector<complex_ball> centre;
    std::vector<long> scales;
    lohner_set errors;
};

/// A system for complex times: the data shared by the discs about points of its paths.
class complex_flow {
public:
    /// The minimum working precision of the centres, and that of the error maps.
    static constexpr long usual_error_bits = 96;

    /// The initial point may be regular singular (singular_step.hpp, whose errors it throws). If the polynomial form of
    /// the system needs a multivalued function (a logarithm, a root), that function is a separate unknown along each
    /// path: its branch is chosen only once.
    complex_flow(const explicit_system& system, long bits, const proof_route& route = {});
    /// For a system without initial values (explicit_system::first_order) and externally given sets.
    static complex_flow about_points(const explicit_system& system, long bits, const proof_route& route = {});

    /// The initial values of the system.
    complex_set start() const;
    long bits() const { return bits_; }
    const proof_route& route() const { return route_; }
    /// Number of given unknowns, with lower derivatives; they come first.
    std::size_t given() const { return given_; }

private:
    friend class complex_disc;
    struct without_start {};
    complex_flow(const explicit_system& system, long bits, const proof_route& route, without_start);

    path_form form_;
    tape tape_, varied_tape_;
    std::size_t given_ = 0;
    long bits_;
    proof_route route_;
    ball origin_;
    std::shared_ptr<const singular_series> singular_;  ///< about the initial point if that is singular
    std::vector<ball> start_;
};

/// Theorem T about a set, for its centre in high precision, and for the whole set with its variations in low precision:
/// every solution that starts in the set is analytic in |s| < radius().
class complex_disc {
public:
    /// Throws precision_exhausted if the set is too wide for any radius, or if a function of it is not finite.
    complex_disc(const complex_flow& flow, complex_set about);
    /// About the initial point, which may be singular: then by theorem S.
    explicit complex_disc(const complex_flow& flow);

    const complex_set& about() const { return set_; }
    const magnitude& radius() const { return singular_ ? singular_->radius() : set_tail_->radius; }
    /// Theorem V: the set at t0 + offset, |offset - about().offset| < radius(); offset exact.
    complex_set moved_to(const complex_ball& offset) const;
    /// The unknowns at every t0 + offset of a ball inside the disc, over the whole set. Not about a singular initial
    /// point.
    std::vector<complex_ball> values_over(const complex_ball& offset) const;
    /// An enclosure, over the whole set, of
    ///     int ((z - centre)/scale)^power y_unknown(t0 + z) dz
    /// along the straight line from about().offset to `offset` inside the disc, `scale` exact and nonzero. Not from a
    /// singular initial point.
    complex_ball integral(std::size_t unknown, const complex_ball& offset, const complex_ball& centre,
                          const ball& scale, int power) const;

private:
    void expand();
    std::vector<complex_ball> image_at(const complex_ball& distance) const;
    ball_matrix scaled_map(const complex_ball& distance, const std::vector<long>& scales) const;

    const complex_flow* flow_;
    complex_set set_;
    long bits_;
    std::unique_ptr<taylor_expansion<complex_ball>> of_centre_, of_set_;
    std::optional<tail_bound> tail_, set_tail_;
    std::shared_ptr<const singular_series> singular_;  ///< instead of these, about a singular initial point
};

/// The set of these enclosures, a box, at t0 + offset; offset exact.
complex_set set_about(const complex_ball& offset, const std::vector<complex_ball>& values);

/// The enclosures of the unknowns over a set.
std::vector<complex_ball> values_of(const complex_set& set);

/// a - b of exact numbers, exactly.
complex_ball exact_difference(const complex_ball& a, const complex_ball& b);

/// The midpoint, rounded to the working precision, as an exact number.
complex_ball exact_midpoint(const complex_ball& z);

/// Whether |z| < r for every number of the ball.
bool certainly_within(const complex_ball& z, const magnitude& r);

}  // namespace libration::ode
