#include "model_range.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr long log2_of_most_divisions = 10;

struct part {
    ball upper;
    taylor_model model;
};

bool is_lower(const part& a, const part& b) { return exactly_less(a.upper, b.upper); }

std::size_t most_nonlinear(const taylor_model& of, std::size_t variables) {
    std::vector<magnitude> shares;
    for (std::size_t j = 0; j < variables; ++j) {
        shares.push_back(of.nonlinear_share(j));
    }
    return static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

ball least_upper_bound(const taylor_model& of, std::size_t variables, long log2_of_excess,
                       const std::optional<ball>& enough) {
    const magnitude tolerance = of.width() * magnitude::of(1, log2_of_excess);
    const int most_divisions = 1 << std::min(-log2_of_excess, log2_of_most_divisions);
    std::priority_queue parts(is_lower, std::vector<part>{{upper_bound(of.range()), of}});
    for (int k = 0; k < most_divisions; ++k) {
        const taylor_model model = parts.top().model;
        if (model.nonlinear_width() <= tolerance || (enough && !exactly_less(*enough, parts.top().upper))) {
            break;
        }
        parts.pop();
        const std::size_t variable = most_nonlinear(model, variables);
        for (const bool upper : {false, true}) {
            taylor_model half = model.on_half(variable, upper);
            ball bound = upper_bound(half.range());
            parts.push({std::move(bound), std::move(half)});
        }
    }
    return parts.top().upper;
}

}  // namespace

ball narrow_range(const taylor_model& of, long log2_of_excess, const std::optional<enough_bounds>& enough) {
    const std::size_t variables = of.in().variables();
    std::optional<ball> above, below;
    if (enough) {
        above = enough->upper;
        below = -enough->lower;
    }
    return hull(-least_upper_bound(ball(-1) * of, variables, log2_of_excess, below),
                least_upper_bound(of, variables, log2_of_excess, above));
}

}  // namespace libration::ode
