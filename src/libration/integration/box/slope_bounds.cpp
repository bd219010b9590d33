#include "slope_bounds.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "../../expansion/set_values.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/scalar/ball/failure.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

slope_bounds::differentiated::differentiated(const explicit_system& of)
    : system(first_order_form(of).about_points(of.point())) {
    std::map<std::string, std::size_t> places;
    for (const unknown_function& each : system.unknowns()) {
        places.emplace(each.name, places.size());
    }
    for (std::size_t i = 0; i < system.right().size(); ++i) {
        std::set<std::size_t> occurring;
        each_leaf(system.right()[i], [&](const expression& leaf) {
            if (leaf.kind() == node_kind::unknown) {
                occurring.insert(places.at(leaf.name()));
            }
        });
        for (const std::size_t j : occurring) {
            expression by = partial(system.right()[i], unknown(system.unknowns()[j].name));
            if (!by.is(0)) {
                entries.push_back({i, j});
                derivatives.push_back(std::move(by));
            }
        }
    }
}

slope_bounds::slope_bounds(const explicit_system& of) : slope_bounds(differentiated(of)) {}

slope_bounds::slope_bounds(const differentiated& of)
    : entries_(of.entries),
      size_(of.system.unknowns().size()),
      tape_(tape::about_points(of.system, of.derivatives)),
      values_(tape_, 1) {}

std::optional<slope_matrix> slope_bounds::over(const ball& time, const std::vector<ball>& box, int direction) {
    try {
        values_.about(time, as_state(box));
    } catch (const precision_exhausted&) {
        return std::nullopt;
    }
    slope_matrix result;
    result.diagonal.assign(size_, ball(0));
    std::size_t next = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        const ball& right = values_.right_side(static_cast<int>(i))[0];
        if (!is_finite(right)) {
            return std::nullopt;
        }
        result.vanishing.push_back(arb_is_zero(right.handle()) != 0);
        for (; next < entries_.size() && entries_[next].row == i; ++next) {
            const ball& slope = values_.watched(static_cast<int>(next))[0];
            if (!is_finite(slope)) {
                return std::nullopt;
            }
            if (entries_[next].column == i) {
                result.diagonal[i] = upper_bound(direction < 0 ? -slope : slope);
            } else {
                result.columns.push_back(entries_[next].column);
                result.beside.emplace_back(slope);
            }
        }
        result.first.push_back(result.columns.size());
    }
    return result;
}

}  // namespace libration::ode
