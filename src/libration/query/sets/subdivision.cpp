#include "subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "libration/scalar/ball/predicates.hpp"
#include "part_run.hpp"

namespace libration::ode {

namespace {

// a/b of two widths, for choices.
double ratio_of_widths(const magnitude& a, const magnitude& b) { return std::exp2(log_of(a) - log_of(b)); }

}  // namespace

std::optional<std::size_t> widest_side(const number_box& part, const number_box& whole) {
    std::optional<std::size_t> widest;
    double most = 0;
    for (std::size_t j = 0; j < part.size(); ++j) {
        const double share = has_width(part[j]) ? ratio_of_widths(radius_of(part[j]), radius_of(whole[j])) : 0;
        if (share > most) {
            most = share;
            widest = j;
        }
    }
    return widest;
}

std::array<number_box, 2> halves(const number_box& box, std::size_t side) {
    std::array<number_box, 2> result{box, box};
    result[0][side].upper = result[1][side].lower = middle_of(box[side]);
    return result;
}

subdivision::subdivision(number_box whole, const set_query& question, bool with_derivatives, std::size_t most_parts)
    : whole_(std::move(whole)), question_(question), with_derivatives_(with_derivatives) {
    parts_.push_back(enclosed(whole_));
    unite();
    while (parts_.size() < most_parts) {
        const auto next = next_division();
        if (!next) {
            break;
        }
        const auto [lower, upper] = halves(parts_[next->part].box, next->side);
        parts_[next->part] = enclosed(lower);
        parts_.push_back(enclosed(upper));
        unite();
    }
}

subdivision::part subdivision::enclosed(const number_box& box) {
    part made{box, best_run(question_, box, with_derivatives_)};
    steps_ += made.run.steps;
    return made;
}

// The images that all parts reach.
void subdivision::unite() {
    images_ = parts_.front().run.images;
    for (std::size_t p = 1; p < parts_.size(); ++p) {
        for (std::size_t i = 0; i < images_.size(); ++i) {
            const auto& more = parts_[p].run.images[i];
            if (!images_[i] || !more) {
                images_[i].reset();
                continue;
            }
            for (std::size_t k = 0; k < more->values.size(); ++k) {
                extend(images_[i]->values[k], more->values[k]);
                for (std::size_t j = 0; j < whole_.size(); ++j) {
                    ball& derivative = images_[i]->derivatives[k][j];
                    derivative = hull(derivative, more->derivatives[k][j]);
                }
            }
        }
    }
}

std::optional<std::size_t> subdivision::index_of_first_end() const {
    const ball start = constant_value<ball>::of(question_.problem().system().point());
    const auto distance = [&](std::size_t p) { return midpoint_alone(abs(parts_[p].run.reached - start)); };
    std::optional<std::size_t> first;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        if (!parts_[p].run.may_divide) {
            return p;
        }
        if (!parts_[p].run.complete && (!first || exactly_less(distance(p), distance(*first)))) {
            first = p;
        }
    }
    return first;
}

const set_run_result* subdivision::first_end() const {
    const auto first = index_of_first_end();
    return first ? &parts_[*first].run : nullptr;
}

const number_box& subdivision::box_of_first_end() const {
    const auto first = index_of_first_end();
    return first ? parts_[*first].box : whole_;
}

std::optional<subdivision::division> subdivision::next_division() const {
    bool wide = false;
    for (std::size_t j = 0; j < whole_.size(); ++j) {
        wide = wide || question_.problem().is_wide(j);
    }
    const bool may_divide = std::ranges::all_of(parts_, [](const part& each) { return each.run.may_divide; });
    return !wide || !may_divide ? std::nullopt : index_of_first_end() ? of_ending_part() : of_widest_part();
}

// The part that ends first, along the side that contributes most to the width of a value there.
std::optional<subdivision::division> subdivision::of_ending_part() const {
    const std::size_t index = *index_of_first_end();
    const part& ends = parts_[index];
    division found{index, widest_side(ends.box, whole_).value_or(0)};
    double most = 0;
    for (const width_shares& shares : ends.run.shares) {
        const magnitude sum = std::accumulate(shares.begin(), shares.end(), magnitude());
        for (std::size_t j = 0; j < shares.size() && sum.is_finite() && !sum.is_zero(); ++j) {
            if (const double share = ratio_of_widths(shares[j], sum); share > most) {
                most = share;
                found.side = j;
            }
        }
    }
    return has_width(ends.box[found.side]) ? std::optional(found) : std::nullopt;
}

// Of the parts that determine a bound of a value that is not monotone, the one with the largest excess, along the side
// whose derivative is the least certain.
std::optional<subdivision::division> subdivision::of_widest_part() const {
    std::optional<division> found;
    double most = negligible_excess;
    for (std::size_t i = 0; i < images_.size(); ++i) {
        for (std::size_t k = 0; question_.is_narrowed(i) && k < images_[i]->values.size(); ++k) {
            const closed_interval& whole = images_[i]->values[k];
            if (!has_width(whole) || is_monotone(images_[i]->derivatives[k])) {
                continue;
            }
            for (std::size_t p = 0; p < parts_.size(); ++p) {
                const closed_interval& here = parts_[p].run.images[i]->values[k];
                const bool determines =
                    !exactly_less(whole.lower, here.lower) || !exactly_less(here.upper, whole.upper);
                if (const double excess = determines ? excess_of(*parts_[p].run.images[i], k, parts_[p].box, whole) : 0;
                    excess > most) {
                    most = excess;
                    found = division{p, least_certain_side(parts_[p], i, k)};
                }
            }
        }
    }
    return found;
}

std::size_t subdivision::least_certain_side(const part& of, std::size_t image, std::size_t value) const {
    std::size_t found = widest_side(of.box, whole_).value_or(0);
    magnitude largest;
    const set_image& here = *of.run.images[image];
    for (std::size_t j = 0; j < whole_.size(); ++j) {
        const auto width = here.excess.empty() ? magnitude::radius_of(here.derivatives[value][j]) * radius_of(of.box[j])
                                               : here.excess[value].shares[j];
        if (largest < width) {
            largest = width;
            found = j;
        }
    }
    return found;
}

}  // namespace libration::ode
