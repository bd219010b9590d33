// A proved solution with limits at infinity, on the whole line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../algebra/dense_matrix.hpp"
#include "connection_map.hpp"
#include "orbit_symmetry.hpp"

namespace libration::ode {

/// The solution for an enclosed zero of a connection_map: by the flow from its start up to the time T of the map, and by theorem W2
/// beyond it, and before the start of an orbit from an equilibrium. That orbit is given up to a shift of the time: t = 0 is where, for the first
/// unknown y with a limit at -inf and a part of the slowest rate r there, y = y(-inf) +- exp(r t) + smaller terms as t -> -inf; without such a part, where the series of the
/// unstable manifold is left.
class connection_orbit {
public:
    /// `unknowns` are the names of the free numbers, `x` all unknowns of the map.
    connection_orbit(connection_map map, std::vector<std::string> unknowns, std::vector<limit_condition> limits,
                     std::vector<ball> x);

    /// Of one end: the solution has this symmetry, which gives the other half.
    void reflect(const orbit_symmetry& by);

    /// Those that move at each end, with a limit there.
    const std::vector<std::string>& quantities() const { return names_; }
    /// Towards which end of the half-line.
    int direction() const { return map_.direction(); }
    /// The time, in phase, from which on the solution is on the manifold of the end.
    ball joining_time() const;

    /// The quantities at times in any order, with so many bits. std::nullopt if more bits or digits of the unknowns are needed, or if the
    /// solution is not proved to exist up to a time.
    std::optional<std::vector<std::vector<ball>>> states(const std::vector<ball>& times, long bits) const;
    /// The limits of the quantities, exactly those of the equilibrium, as t -> inf or -inf.
    std::vector<ball> limits(int direction) const;

    /// y = y(-inf) - exp(0.7 t) + smaller terms as t -> -inf, which fixes t = 0, in words.
    std::string phase() const;
    /// The A of y = y(inf) + A exp(-r t) + smaller terms, r the slowest rate of an end, a real one of no other direction, for each limit at that end: "amplitude of y".
    std::vector<std::pair<std::string, ball>> amplitudes() const;
    /// The rates of departure from the first equilibrium, the slowest first: "rate 1 at -inf".
    std::vector<std::pair<std::string, ball>> rates_at_start() const;
    /// Of an orbit with two ends the angle in (0, pi/2] at t = 0, orthogonally to the orbit, between the tangent spaces of the unstable manifold of
    /// the first equilibrium and of the stable one of the second, in the space of the quantities and the unknown parameters. Of spaces of
    /// dimensions above one it is that of Gram's determinants, whose sine is the product of the sines of the principal angles
    /// [MiaoBenIsrael1992]. std::nullopt if more bits are needed.
    std::optional<ball> angle(long bits) const;

private:
    ball image(std::size_t quantity, const ball& value) const;
    std::optional<std::vector<std::vector<ball>>> states_of_half(const std::vector<ball>& times, long bits) const;
    struct slowest {
        std::size_t direction;
        ball rate;  // > 0
        std::vector<std::vector<complex_ball>> columns;
    };
    std::optional<slowest> slowest_of(const manifold_end& end, const std::vector<ball>& numbers) const;
    ball amplitude_at(const manifold_end& end, const slowest& by, const std::string& name, const ball& theta) const;
    std::optional<std::vector<std::vector<ball>>> marched(const std::vector<ball>& times, long bits) const;
    std::optional<std::vector<std::vector<ball>>> on_manifold(const manifold_end& end, const std::vector<ball>& numbers,
                                                              const std::vector<ball>& theta,
                                                              const std::vector<ball>& times, long bits) const;
    std::vector<ball> theta_at_end() const;
    std::optional<dense_matrix> flow_to(const ball& time, const std::vector<ball>& start, long bits,
                                        std::vector<ball>& state) const;
    ball along_solution(const ball& time) const;

    connection_map map_;
    std::vector<std::string> unknowns_;
    std::vector<limit_condition> limits_;
    std::vector<ball> x_;
    std::vector<std::string> names_;
    std::vector<std::size_t> places_;                  // of the names in the form
    std::vector<std::optional<number>> twice_centre_;  // of the quantities that a symmetry reflects; or empty
    ball phase_;                                       // the time of the map at t = 0
    std::string of_phase_;                             // the unknown that fixes it
    int sign_of_phase_ = 1;
    ball rate_of_phase_;
};

}  // namespace libration::ode
