// Nonzero coefficients by a symmetry of the initial values: y_n = 0 except for n = r modulo p.

#include <algorithm>

#include "tape_builder.hpp"

namespace libration::ode {

namespace {

constexpr int identically_zero = -1;
constexpr int contradiction = -2;

int modulo(int n, int stride) { return (n % stride + stride) % stride; }

bool is_exact_zero(const number& x) {
    const auto plain = x.plain();
    return plain && plain->coefficient == 0;
}

}  // namespace

int tape_symmetry::residue_of(const tape_step& step, int stride) const {
    const auto of = [&](int operand) { return operand < 0 ? 0 : steps_[static_cast<std::size_t>(operand)]; };
    const int a = step.kind == operation::state ? unknowns_[static_cast<std::size_t>(step.left)] : of(step.left);
    const int root = tape_.is_singular() ? tape_.root() : 1;
    const bool about_zero = tape_.is_singular() || is_exact_zero(tape_.point());
    const auto moved = [&](int from, int by) { return from < 0 ? from : modulo(from + by, stride); };
    const bool odd = a > 0 && 2 * a % stride == 0;
    switch (step.kind) {
        case operation::constant:
            return is_exact_zero(tape_.constants()[static_cast<std::size_t>(step.constant)]) ? identically_zero : 0;
        case operation::variable: return about_zero ? modulo(root, stride) : stride == 1 ? 0 : contradiction;
        case operation::state: return moved(a, -step.right * root);
        case operation::sum:
        case operation::difference: {
            const int b = of(step.right);
            return a < 0 ? b : b < 0 || a == b ? a : contradiction;
        }
        case operation::scaled: return a;
        case operation::raised: return a <= 0 ? 0 : contradiction;
        case operation::by_variable: return about_zero ? moved(a, 1) : stride == 1 ? a : contradiction;
        case operation::delayed: return moved(a, step.shift);
        case operation::product: return of(step.right) < 0 ? identically_zero : moved(a, of(step.right));
        case operation::square: return moved(a, a);
        case operation::quotient: return of(step.right) == 0 ? a : contradiction;
        case operation::slope: return moved(a, -1);
        case operation::square_root:
        case operation::power:
        case operation::primitive: return a <= 0 ? 0 : contradiction;
        case operation::function: return a <= 0 ? (step.odd ? a : 0) : step.odd && odd ? a : contradiction;
        case operation::companion: break;
    }
    return 0;
}

bool tape_symmetry::holds(int stride) {
    const auto& starts = tape_.starts();
    unknowns_.assign(starts.size(), identically_zero);
    const int root = tape_.is_singular() ? tape_.root() : 1;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        for (std::size_t j = 0; j < starts[i].size(); ++j) {
            const int residue = modulo(root * static_cast<int>(j), stride);
            if (is_exact_zero(starts[i][j])) {
                continue;
            }
            if (unknowns_[i] >= 0 && unknowns_[i] != residue) {
                return false;
            }
            unknowns_[i] = residue;
        }
    }
    for (bool changes = true; changes;) {
        changes = false;
        steps_.assign(tape_.steps().size(), identically_zero);
        for (std::size_t s = 0; s < steps_.size(); ++s) {
            steps_[s] = residue_of(tape_.steps()[s], stride);
            if (steps_[s] == contradiction) {
                return false;
            }
        }
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const int right = steps_[static_cast<std::size_t>(tape_.outputs()[i])];
            const int from_right =
                right < 0 ? right : modulo(right + (tape_.is_singular() ? 0 : tape_.orders()[i]), stride);
            if (from_right >= 0 && unknowns_[i] >= 0 && from_right != unknowns_[i]) {
                return false;
            }
            if (from_right >= 0 && unknowns_[i] < 0) {
                unknowns_[i] = from_right;
                changes = true;
            }
        }
    }
    return true;
}

}  // namespace libration::ode
