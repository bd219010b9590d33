// What is enclosed of the solutions from a box of initial values and parameters: their values in spans of time, or their
// events.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/proved/proved_march.hpp"
#include "set_problem.hpp"

namespace libration::ode {

/// What all solutions of a box have in common, in one span of time or at one event.
struct set_image {
    std::vector<closed_interval> values;  ///< of the unknowns of the problem; of an event its time first
    /// Of each value with respect to each number of the box, over the whole box; rows are empty if not requested.
    ball_matrix derivatives;
};

/// The result of a run from a box: the images in order, empty if they are not reached.
struct set_run_result {
    std::vector<std::optional<set_image>> images;
    bool complete = true;
    /// If it is not complete: the time up to which all solutions of the box are proved to exist, and the derivatives
    /// there; of an event also the reason, and whether the parts of the box may be complete.
    ball reached;
    bool forward = true;
    ball_matrix derivatives = {};
    std::string reason = {};
    bool may_divide = true;
    long steps = 0;  ///< in both directions
};

class set_question {
public:
    /// All arguments must outlive it.
    set_question(const set_problem& of, long bits, const march_watch& watch, const proof_route& route)
        : of_(of), bits_(bits), watch_(watch), route_(route) {}
    set_question(const set_question&) = delete;
    set_question& operator=(const set_question&) = delete;
    virtual ~set_question() = default;

    const set_problem& problem() const { return of_; }
    virtual set_run_result enclosed_from(const number_box& box, bool with_derivatives) const = 0;
    /// Whether the whole box is divided to narrow the bounds of this image.
    virtual bool is_narrowed(std::size_t image) const = 0;

protected:
    const set_problem& of_;
    long bits_;
    const march_watch& watch_;
    const proof_route& route_;
};

/// The precision in which the solutions of a box are enclosed: of `digits` digits if no interval has a width, else 64
/// bits beyond those that distinguish the ends of the narrowest one. Throws error of the kind undecided if a million
/// bits do not.
long bits_of_sets(const set_problem& of, long digits);

/// For wide boxes, whose steps are short because of their width: fewer terms, and not by collocation, which would take
/// them for stiff.
proof_route route_for(const number_box& box, const proof_route& given);

/// " for x(0) in [0.9, 1.1], b in [1, 2], one of 8 parts"; nothing of a problem without sets.
std::string text_of_part(const number_box& part, const std::vector<std::string>& names, std::size_t parts);

}  // namespace libration::ode
