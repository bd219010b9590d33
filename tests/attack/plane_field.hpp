// Solutions of equations in a plane whose right-hand side is constant where u and v keep their signs.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "libration/number/exact.hpp"

namespace libration::attack {

struct plane_vector {
    rational u = 0;
    rational v = 0;

    friend bool operator==(const plane_vector&, const plane_vector&) = default;
};

/// u' and v' by the signs -1, 0, 1 of u and v, as written.
using sign_field = std::function<plane_vector(int sign_of_u, int sign_of_v)>;

/// Where the solutions from a point are at a time.
struct plane_solution {
    enum class number { one, several, none, unknown };

    number how_many = number::unknown;
    plane_vector end;           ///< of the only one
    bool on_a_surface = false;  ///< the only one stays on u = 0 or v = 0 for some time
};

/// In the sense of Filippov: u', v' in the convex hull of the limits from the quadrants; or of Caratheodory: as written,
/// at almost all times. By all ways to leave each point that is reached: into a quadrant if its field leads into it,
/// along a half-axis or at rest if a value of the right-hand side there does; along a half-axis to which the fields of
/// both sides are tangent as written there, if that is tangent, too. `unknown` if the field turns around the
/// origin in all quadrants, or after many pieces.
plane_solution filippov_solution(const sign_field& field, const plane_vector& start, const rational& time);
plane_solution caratheodory_solution(const sign_field& field, const plane_vector& start, const rational& time);

/// What both have in common. A u or v that is 0 at first and whose derivative is 0 for all signs stays 0: then the
/// right-hand side is the one written for 0.
struct known_end {
    bool is_known = false;
    std::optional<plane_vector> end;  ///< none if there is more than one solution
    bool on_a_surface = false;        ///< a solution stays on a surface for some time
};
known_end end_of(const sign_field& field, const plane_vector& start, const rational& time);

}  // namespace libration::attack
