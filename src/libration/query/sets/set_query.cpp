#include "set_query.hpp"

#include <algorithm>
#include <cmath>

#include "../../equation/bound_text.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The bits of the solutions beyond those that distinguish the ends of the narrowest interval.
constexpr long bits_below_the_box = 64;

// Of the ends of the intervals, to measure their widths; doubled until it suffices.
constexpr long first_bits_of_box = 256;
constexpr long most_bits_of_box = 1'000'000;

// log2 of the ends of the narrowest interval, relative to its width; std::nullopt if no interval has one.
std::optional<double> narrowness_of(const set_problem& of) {
    std::optional<double> most;
    const number_box box = of.box();
    for (std::size_t j = 0; j < box.size(); ++j) {
        if (of.is_wide(j)) {
            const magnitude size = std::max(magnitude(box[j].lower), magnitude(box[j].upper));
            most = std::max(most.value_or(0), log_of(size) - log_of(radius_of(box[j])));
        }
    }
    return most;
}

}  // namespace

long bits_of_sets(const set_problem& of, long digits) {
    const auto found = with_doubled_bits(first_bits_of_box, most_bits_of_box, [&](long bits) -> std::optional<long> {
        const precision_scope scope(decimal_digits(bits));
        const auto narrowness = narrowness_of(of);
        if (!narrowness) {
            return bits_of_first_run(digits);
        }
        return *narrowness < static_cast<double>(bits) / 2
                   ? std::optional(static_cast<long>(std::ceil(*narrowness)) + bits_below_the_box)
                   : std::nullopt;
    });
    if (!found) {
        throw error(error_kind::undecided, error_subject::problem, "",
                    "has an interval that a million bits do not distinguish from a number");
    }
    return *found;
}

bool is_wide(const number_box& box) {
    constexpr long narrow = -12;
    return std::ranges::any_of(box, [](const closed_interval& each) {
        const magnitude size = std::max(magnitude(each.lower), magnitude(each.upper));
        return !(radius_of(each) <= size * magnitude::of(1, narrow));
    });
}

proof_route route_for(const number_box& box, const proof_route& given) {
    constexpr int fewer_terms = 12;
    proof_route route = given;
    if (is_wide(box)) {
        route.more_terms -= fewer_terms;
        route.integrator =
            given.integrator == integrator_choice::automatic ? integrator_choice::taylor : given.integrator;
    }
    return route;
}

std::vector<width_shares> shares_of(const ball_matrix& derivatives, const number_box& box) {
    std::vector<width_shares> result;
    for (const auto& row : derivatives) {
        auto& of_value = result.emplace_back();
        for (std::size_t j = 0; j < row.size(); ++j) {
            of_value.push_back(magnitude::midpoint_of(row[j]) * radius_of(box[j]));
        }
    }
    return result;
}

bool is_defined_at_corners(const set_problem& of, const number_box& box) {
    constexpr std::size_t most_sides = 8;  // of all of whose corners the values are computed
    const polynomial_form form = lifted(of.system());
    const ball point = constant_value<ball>::of(of.system().point());
    const std::size_t sides = std::min(box.size(), most_sides);
    for (std::size_t corner = 0; corner < std::size_t{1} << sides; ++corner) {
        number_box at;
        for (std::size_t j = 0; j < box.size(); ++j) {
            const ball& end = (corner >> std::min(j, most_sides - 1) & 1U) == 0 ? box[j].lower : box[j].upper;
            at.push_back({end, end});
        }
        if (!std::ranges::all_of(lifted_values(form, point, of.states_of(at).hull()),
                                 [](const ball& each) { return is_finite(each); })) {
            return false;
        }
    }
    return true;
}

std::string text_of_reach(const ball& reached, bool begins, bool forward) {
    return "is not reached by every solution: " +
           (begins ? "all of them are proved to exist up to " + proved_reach_text(reached, forward)
                   : "no step from the initial point is proved, because the equations or their polynomial form may be "
                     "singular on the set");
}

std::string text_of_part(const number_box& part, const std::vector<std::string>& names, std::size_t parts) {
    std::string text;
    for (std::size_t j = 0; j < part.size(); ++j) {
        text += (j == 0 ? " for " : ", ") + names[j] + " in " + interval_text(part[j].lower, part[j].upper);
    }
    return text + (parts > 1 ? ", one of " + std::to_string(parts) + " parts" : "");
}

}  // namespace libration::ode
