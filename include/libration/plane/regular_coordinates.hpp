// Coordinates in which poles become zeros, so that the equation is regular there.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// For equations whose singularities are poles by their form [Okamoto1979]:
///     y' = A(t) + B(t) y + C(t) y^2,                                             poles of order 1,
///     y'' = a2 y^2 + b y + c(t),  c'' = 0,                                       poles of order 2,
///     y'' = a3 y^3 + a2 y^2 + b(t) y + c,  b'' = 0, and b' = 0 or a2 = 0,        poles of order 1.
/// With v = 1/y the first becomes v' = -C - B v - A v^2. For the others let p = y'/y^2,
///     h = y'^2 - (a3/2) y^4 - (2 a2/3) y^3 - b y^2 - 2 c y,
/// and g = h + k y'/y, k = 2 b'/a3 or, for the second, 6 c'/a2. Then
///     v' = -p,  p' = -a2/3 - b v - 3 c v^2 - 2 (g v^3 - k p v^2),  g' = -k (c v + g v^2 - k p v),
///     p^2 = a3/2 + (2 a2/3) v + b v^2 + 2 c v^3 + g v^4 - k p v^3,
/// all polynomials. Proof. h' = -b' y^2 - 2 c' y; p^2 = y'^2/y^4 is h v^4 plus the terms subtracted in h; p' = y''/y^2
/// - 2 y p^2; and (y'/y)' = y''/y - p^2/v^2 = (a3/2) y^2 + (a2/3) y - c v - h v^2, so that h' = -k ((y'/y)' + c v + h
/// v^2).
class regular_coordinates {
public:
    /// Returns std::nullopt for other systems.
    static std::optional<regular_coordinates> of(const explicit_system& system);

    /// The order of every pole.
    int order() const { return order_; }
    /// v, or v, p, g, without initial values.
    const explicit_system& system() const { return system_; }
    /// The index of the one with a simple zero at a pole: v, or p at a pole of order 2, where v is 0 too if `factor` is
    /// nonzero.
    std::size_t simple_zero() const { return order_ == 2 ? 1 : 0; }

    /// The coordinates at a time, from y or y and y'; y must be nonzero.
    template <field R>
    std::vector<R> from(const R& time, const std::vector<R>& state) const {
        const R v = R(1) / state[0];
        if (state.size() == 1) {
            return {v};
        }
        expression_values<R> at({}, time);
        const R& y = state[0];
        const R& slope = state[1];
        const R square = y * y;
        const R h = slope * slope - at.of(a3_) * square * square / 2 - at.of(a2_) * square * y * 2 / 3 -
                    at.of(b_) * square - at.of(c_) * y * 2;
        return {v, slope / square, h + at.of(k_) * slope / y};
    }

    /// The derivatives of the coordinates.
    template <field R>
    std::vector<R> slopes(const R& time, const std::vector<R>& coordinates) const {
        expression_values<R> at(leaves_, time);
        for (const R& each : coordinates) {
            at.push_back(each);
        }
        std::vector<R> result;
        for (const expression& each : system_.right()) {
            result.push_back(at.of(each));
        }
        return result;
    }

    /// p^2 = v factor for poles of order 2.
    template <field R>
    R factor(const R& time, const std::vector<R>& coordinates) const {
        expression_values<R> at({}, time);
        const R& v = coordinates[0];
        return at.of(a2_) * 2 / 3 + at.of(b_) * v + at.of(c_) * v * v * 2 + coordinates[2] * v * v * v -
               at.of(k_) * coordinates[1] * v * v;
    }

private:
    regular_coordinates(int order, std::vector<expression> leaves, explicit_system system)
        : order_(order), leaves_(std::move(leaves)), system_(std::move(system)) {}

    int order_;
    std::vector<expression> leaves_;
    explicit_system system_;
    expression a3_, a2_, b_, c_, k_;
};

}  // namespace libration::ode
