#include "libration/expansion/placed_steps.hpp"

namespace libration::ode {

std::vector<int> steps_in_chains(const tape& of) {
    const std::vector<tape_step>& steps = of.steps();
    const int count = static_cast<int>(steps.size());
    const auto is_computed = [&](int i) {
        const operation kind = steps[static_cast<std::size_t>(i)].kind;
        return kind != operation::state && kind != operation::companion;
    };
    std::vector<int> missing(steps.size());  // operands that are not yet computed
    std::vector<std::vector<int>> users(steps.size());
    for (int i = 0; i < count; ++i) {
        const tape_step& step = steps[static_cast<std::size_t>(i)];
        for (const int operand : {step.left, step.right}) {
            if (is_computed(i) && operand >= 0) {
                // A companion is there with the step before it.
                int from = operand;
                while (steps[static_cast<std::size_t>(from)].kind == operation::companion) {
                    --from;
                }
                if (is_computed(from)) {
                    ++missing[static_cast<std::size_t>(i)];
                    users[static_cast<std::size_t>(from)].push_back(i);
                }
            }
        }
    }
    std::vector<int> order;
    std::vector<bool> done(steps.size());
    for (int i = 0; i < count; ++i) {
        for (int next = i; next >= 0 && is_computed(next) && !done[static_cast<std::size_t>(next)];) {
            order.push_back(next);
            done[static_cast<std::size_t>(next)] = true;
            int chained = -1;
            for (const int user : users[static_cast<std::size_t>(next)]) {
                if (--missing[static_cast<std::size_t>(user)] == 0 && chained < 0) {
                    chained = user;
                }
            }
            next = chained;
        }
    }
    return order;
}

}  // namespace libration::ode
