// A box of initial values and parameters in parts, each with the enclosures of its solutions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "set_query.hpp"

namespace libration::ode {

/// The side of a part that is widest relative to the whole box; std::nullopt if none has a width. For choices.
std::optional<std::size_t> widest_side(const number_box& part, const number_box& whole);

/// A box divided in the middle of a side.
std::array<number_box, 2> halves(const number_box& box, std::size_t side);

/// The parts of a box and what their runs prove; how it is divided affects no proof.
class subdivision {
public:
    /// Divides the whole box into at most so many parts, until all of them are complete and sharp.
    subdivision(number_box whole, const set_query& question, bool with_derivatives, std::size_t most_parts);

    const number_box& whole() const { return whole_; }
    std::size_t parts() const { return parts_.size(); }
    /// Of all runs, also those of parts that were divided afterwards.
    long steps() const { return steps_; }
    /// Of all solutions of the box; std::nullopt for one that not all parts reach.
    const std::vector<std::optional<set_image>>& images() const { return images_; }
    /// The part that ends first, if one does; one whose parts would not be complete has priority.
    const set_run_result* first_end() const;
    const number_box& box_of_first_end() const;

private:
    struct part {
        number_box box;
        set_run_result run;
    };
    struct division {
        std::size_t part = 0, side = 0;
    };

    part enclosed(const number_box& box);
    void unite();
    std::optional<std::size_t> index_of_first_end() const;
    std::optional<division> next_division() const;
    std::optional<division> of_ending_part() const;
    std::optional<division> of_widest_part() const;
    std::size_t least_certain_side(const part& of, std::size_t image, std::size_t value) const;

    number_box whole_;
    const set_query& question_;
    bool with_derivatives_;
    std::vector<part> parts_;
    std::vector<std::optional<set_image>> images_;
    long steps_ = 0;
};

}  // namespace libration::ode
