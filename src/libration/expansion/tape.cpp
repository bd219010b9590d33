#include "libration/expansion/tape.hpp"

#include <algorithm>
#include <string>

#include "libration/scalar/error.hpp"
#include "singular_check.hpp"
#include "tape_builder.hpp"

namespace libration::ode {

namespace {

constexpr int largest_stride = 12;
constexpr int last_resonance = 4096;

// (n/root)(n/root - 1) .. (n/root - q + 1) - sum weights of one unknown: 0 if its coefficient n is free.
rational indicial_factor(const std::vector<number>& weights, int order, int root, int n, const std::string& name) {
    rational falling = 1;
    rational factor = 0;
    for (int l = 0; l < order; ++l) {
        const auto weight = weights[static_cast<std::size_t>(l)].fraction();
        if (!weight) {
            refuse(name, {}, "has an indicial equation whose numbers are not fractions: give parameters as fractions");
        }
        factor -= *weight * falling;
        falling *= rational(n - l * root, root);
    }
    return factor + falling;
}

void require_determined(const explicit_system& of) {
    const singular_start& start = *of.singular();
    for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
        const unknown_function& unknown = of.unknowns()[i];
        const auto& weights = start.right[i].weights;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const bool coupled = k != i && std::ranges::any_of(weights[k], [](const number& w) {
                                     return !(w.fraction() && *w.fraction() == 0);
                                 });
            if (coupled) {
                refuse(primed(unknown.name, unknown.order), {},
                       "is coupled to " + of.unknowns()[k].name +
                           " by its singular initial point: use one equation of higher order, without one of them");
            }
        }
        for (int n = 1; n <= last_resonance; ++n) {
            const bool given = n % start.root == 0 && n / start.root < unknown.order;
            if (!given && indicial_factor(weights[i], unknown.order, start.root, n, unknown.name) == 0) {
                const std::string power = start.root == 1
                                              ? std::to_string(n)
                                              : "(" + std::to_string(n) + "/" + std::to_string(start.root) + ")";
                refuse(
                    unknown.name, {},
                    "has no unique series at the initial point, since the equation leaves the coefficient of power " +
                        power + " free, or has no solution: choose another initial point");
            }
        }
    }
}

}  // namespace

tape tape::about_points(const explicit_system& of, const std::vector<expression>& watched) {
    return tape_builder(of, nullptr).build(watched);
}

tape tape::about_start(const explicit_system& of) {
    if (of.singular()) {
        require_determined(of);
    }
    start_values values(leaves_at_start(of));
    tape result = tape_builder(of, &values).build({});
    tape_symmetry symmetry(result);
    int stride = largest_stride;
    while (stride > 1 && !symmetry.holds(stride)) {
        --stride;
    }
    if (symmetry.holds(stride)) {
        result.stride_ = stride;
        for (std::size_t i = 0; i < result.steps_.size(); ++i) {
            result.steps_[i].residue = symmetry.steps()[i];
        }
        result.residues_ = symmetry.unknowns();
    }
    if (of.singular()) {
        require_consistent_start(result, of);
    }
    return result;
}

}  // namespace libration::ode
