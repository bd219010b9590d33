// What is enclosed of the solutions from a box of initial values and parameters: their values in spans of time, or their
// events.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/integration/integration.hpp"
#include "set_problem.hpp"

namespace libration::ode {

/// How much a number of the box contributes to the width of a value; for choices on which no proof depends.
using width_shares = std::vector<magnitude>;

/// By how much an enclosure by Taylor models exceeds the range of a value at most, and shares of that.
struct model_excess {
    magnitude width;
    width_shares shares;
};

/// What all solutions of a box have in common, in one span of time or at one event.
struct set_image {
    std::vector<closed_interval> values;  ///< of the unknowns of the problem; of an event its time first
    /// Of each value with respect to each number of the box, over the whole box; rows are empty if not requested.
    ball_matrix derivatives;
    std::vector<model_excess> excess = {};  ///< of each value, if it is enclosed by Taylor models
};

/// The result of a run from a box: the images in order, empty if they are not reached.
struct set_run_result {
    std::vector<std::optional<set_image>> images;
    bool complete = true;
    /// If it is not complete: the time up to which all solutions of the box are proved to exist, and the shares of each
    /// value there, if they are known; of an event also the reason, and whether the parts of the box may be complete.
    ball reached;
    bool begins = true;  ///< whether a step from the initial point is proved
    bool forward = true;
    std::vector<width_shares> shares = {};
    std::string reason = {};
    bool may_divide = true;
    long steps = 0;  ///< in both directions
};

class set_query {
public:
    /// All arguments must outlive it.
    set_query(const set_problem& of, long bits, const march_watch& watch, const proof_route& route)
        : of_(of), bits_(bits), watch_(watch), route_(route) {}
    set_query(const set_query&) = delete;
    set_query& operator=(const set_query&) = delete;
    virtual ~set_query() = default;

    const set_problem& problem() const { return of_; }
    virtual set_run_result enclosed_from(const number_box& box, bool with_derivatives) const = 0;
    /// enclosed_from() without the images of spans from one time to another, which take the most time.
    virtual set_run_result enclosed_at_times(const number_box& box, bool with_derivatives) const {
        return enclosed_from(box, with_derivatives);
    }
    /// Whether there are such images.
    virtual bool has_spans() const { return false; }
    /// The same by Taylor models, for boxes on which the solutions are not close to linear; std::nullopt if that is not
    /// supported.
    virtual std::optional<set_run_result> enclosed_by_models(const number_box& /*box*/,
                                                             bool /*with_derivatives*/) const {
        return std::nullopt;
    }
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

/// Whether a number of the box varies by more than 2^-12 of its size.
bool is_wide(const number_box& box);

/// For wide boxes, whose steps are short because of their width: fewer terms, and not by collocation, which would take
/// them for stiff.
proof_route route_for(const number_box& box, const proof_route& given);

/// The shares by derivatives with respect to the numbers of a box, a row for each value.
std::vector<width_shares> shares_of(const ball_matrix& derivatives, const number_box& box);

/// Whether parts of a box from which no step is proved may have one, because the polynomial form of the equations is
/// defined at all corners of the box, of which each part of a part has one.
bool is_defined_at_corners(const set_problem& of, const number_box& box);

/// Of a time or an event that is not reached by every solution of a box: up to where they are proved to exist.
std::string text_of_reach(const ball& reached, bool begins, bool forward);

/// " for x(0) in [0.9, 1.1], b in [1, 2], one of 8 parts"; nothing of a problem without sets.
std::string text_of_part(const number_box& part, const std::vector<std::string>& names, std::size_t parts);

}  // namespace libration::ode
