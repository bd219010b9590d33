#include "model_range.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "libration/ode/ball/step_pieces.hpp"
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
    std::size_t most = 0;
    for (std::size_t j = 1; j < variables; ++j) {
        if (of.nonlinear_share(most) < of.nonlinear_share(j)) {
            most = j;
        }
    }
    return most;
}

ball least_upper_bound(const taylor_model& of, std::size_t variables, long log2_of_excess) {
    const magnitude tolerance = of.width() * magnitude::of(1, log2_of_excess);
    const int most_divisions = 1 << std::min(-log2_of_excess, log2_of_most_divisions);
    std::priority_queue parts(is_lower, std::vector<part>{{upper_bound(of.range()), of}});
    for (int k = 0; k < most_divisions; ++k) {
        const taylor_model model = parts.top().model;
        if (model.nonlinear_width() <= tolerance) {
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

ball narrow_range(const taylor_model& of, long log2_of_excess) {
    const std::size_t variables = of.in().variables();
    return hull(-least_upper_bound(ball(-1) * of, variables, log2_of_excess),
                least_upper_bound(of, variables, log2_of_excess));
}

}  // namespace libration::ode
