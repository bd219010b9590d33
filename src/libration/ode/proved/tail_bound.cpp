#include "libration/ode/proved/tail_bound.hpp"

#include <algorithm>
#include <stdexcept>

namespace libration::ode {

namespace {

constexpr int most_attempts = 40;

// The norms of what a step of the tape is for the polynomials p: of the degrees below N, and of the others.
struct step_norm {
    std::vector<magnitude> terms;  // |a_j| rho^j, j < N, where a product needs them
    magnitude low;
    magnitude rest;
};

template <field R>
class norms_of_steps {
public:
    // With N = degree; the expansion has as many more terms as steps of the tape lag behind.
    norms_of_steps(const tape& of, const taylor_expansion<R>& expansion, int degree, const R& point,
                   const magnitude& radius)
        : tape_(of), expansion_(expansion), terms_(static_cast<std::size_t>(degree)), radius_(radius) {
        point_ = size_of(point);
        magnitude power(1U);
        for (std::size_t j = 0; j <= terms_; ++j) {
            powers_.push_back(power);
            power *= radius;
        }
        for (const number& each : of.constants()) {
            constants_.push_back(size_of(constant_value<R>::of(each)));
        }
        all_.reserve(of.steps().size());
        for (std::size_t i = 0; i < of.steps().size(); ++i) {
            all_.push_back(norm_of(of.steps()[i], static_cast<int>(i)));
        }
    }

    // ||step, degrees >= N|| for p itself.
    const magnitude& rest(int step) const { return all_[static_cast<std::size_t>(step)].rest; }

    // ||step(p + e) - step(p)|| for ||e_i|| <= errors[i].
    std::vector<magnitude> changes(const std::vector<magnitude>& errors) const {
        std::vector<magnitude> result;
        result.reserve(all_.size());
        const auto norm = [&](int step) {
            const step_norm& of = all_[static_cast<std::size_t>(step)];
            return of.low + of.rest;
        };
        for (const tape_step& s : tape_.steps()) {
            const auto left = [&]() -> const magnitude& { return result[static_cast<std::size_t>(s.left)]; };
            const auto right = [&]() -> const magnitude& { return result[static_cast<std::size_t>(s.right)]; };
            switch (s.kind) {
                case operation::state: result.push_back(errors[static_cast<std::size_t>(s.left)]); break;
                case operation::sum:
                case operation::difference: result.push_back(left() + right()); break;
                case operation::scaled: result.push_back(left() * factor_of(s)); break;
                case operation::raised: result.push_back(magnitude(left())); break;
                case operation::by_variable: result.push_back(left() * (point_ + radius_)); break;
                case operation::delayed: result.push_back(left() * shift_of(s)); break;
                case operation::product:
                    result.push_back(norm(s.left) * right() + left() * norm(s.right) + left() * right());
                    break;
                case operation::square: result.push_back(left() * (norm(s.left) + norm(s.left) + left())); break;
                default: result.emplace_back(); break;  // a constant, the variable
            }
        }
        return result;
    }

private:
    magnitude factor_of(const tape_step& s) const {
        if (s.constant >= 0) {
            return constants_[static_cast<std::size_t>(s.constant)];
        }
        const auto above = static_cast<unsigned long>(s.numerator < 0 ? -static_cast<long>(s.numerator) : s.numerator);
        return magnitude(above) / static_cast<unsigned long>(s.denominator);
    }

    magnitude shift_of(const tape_step& s) const { return pow(radius_, static_cast<unsigned long>(s.shift)); }

    const step_norm& of(int step) const { return all_[static_cast<std::size_t>(step)]; }

    step_norm norm_of(const tape_step& s, int index) const {
        step_norm result;
        const R* const a = expansion_.of_step(index);
        result.terms.reserve(terms_);
        for (std::size_t j = 0; j < terms_; ++j) {
            result.terms.push_back(size_of(a[j]) * powers_[j]);
            result.low += result.terms.back();
        }
        result.rest = rest_of(s, a);
        return result;
    }

    magnitude rest_of(const tape_step& s, const R* a) const {
        switch (s.kind) {
            case operation::state: return size_of(a[terms_]) * powers_[terms_];
            case operation::constant:
            case operation::variable: return s.kind == operation::variable && terms_ == 1 ? radius_ : magnitude();
            case operation::sum:
            case operation::difference: return of(s.left).rest + of(s.right).rest;
            case operation::scaled: return of(s.left).rest * factor_of(s);
            case operation::raised: return of(s.left).rest;
            case operation::by_variable:
                return of(s.left).rest * (point_ + radius_) + of(s.left).terms.back() * radius_;
            case operation::delayed: return rest_of_delayed(of(s.left), s);
            case operation::product: return rest_of_product(of(s.left), of(s.right));
            case operation::square: return rest_of_product(of(s.left), of(s.left));
            default: throw std::logic_error("theorem T takes products and sums alone");
        }
    }

    // The degrees from N - shift on, moved up.
    magnitude rest_of_delayed(const step_norm& a, const tape_step& s) const {
        magnitude sum = a.rest;
        const auto shift = static_cast<std::size_t>(s.shift);
        for (std::size_t j = terms_ - std::min(shift, terms_); j < terms_; ++j) {
            sum += a.terms[j];
        }
        return sum * shift_of(s);
    }

    // sum_j |a_j| rho^j (tail of b from N - j) + ||a|| r_b + r_a ||b|| + r_a r_b.
    static magnitude rest_of_product(const step_norm& a, const step_norm& b) {
        magnitude tail;
        magnitude sum;
        const std::size_t count = a.terms.size();
        for (std::size_t j = 1; j < count; ++j) {
            tail += b.terms[count - j];
            sum.add_product(a.terms[j], tail);
        }
        sum.add_product(a.low, b.rest);
        sum.add_product(a.rest, b.low);
        sum.add_product(a.rest, b.rest);
        return sum;
    }

    const tape& tape_;
    const taylor_expansion<R>& expansion_;
    std::size_t terms_;
    magnitude radius_;
    magnitude point_;
    std::vector<magnitude> powers_, constants_;
    std::vector<step_norm> all_;
};

// s with defect_i ||f_i(p), degrees >= N|| + gain_i G_i(s) <= s_i for all i, and what the map makes of it.
template <field R>
std::optional<tail_bound> tail_by_norms(const tape& of, const norms_of_steps<R>& norms, int last,
                                        const magnitude& radius, const std::vector<magnitude>& defects,
                                        const std::vector<magnitude>& gains) {
    std::vector<magnitude> defect;
    for (std::size_t i = 0; i < of.outputs().size(); ++i) {
        defect.push_back(norms.rest(of.outputs()[i]) * defects[i]);
    }
    const auto image = [&](const std::vector<magnitude>& s) {
        std::vector<magnitude> result = defect;
        const auto changes = norms.changes(s);
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] += changes[static_cast<std::size_t>(of.outputs()[i])] * gains[i];
        }
        return result;
    };
    std::vector<magnitude> s = defect;
    const magnitude inflation = magnitude(9U) / 8U;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        const auto next = image(s);
        if (!std::ranges::all_of(next, [](const magnitude& each) { return each.is_finite(); })) {
            return std::nullopt;
        }
        if (std::ranges::equal(next, s, [](const magnitude& a, const magnitude& b) { return a <= b; })) {
            return tail_bound{radius, last, image(image(next))};
        }
        for (std::size_t i = 0; i < s.size(); ++i) {
            s[i] = next[i] * inflation;
        }
    }
    return std::nullopt;
}

}  // namespace

template <field R>
std::optional<tail_bound> bounded_tail(const tape& of, const taylor_expansion<R>& expansion, const R& point,
                                       const magnitude& radius) {
    const auto order = static_cast<unsigned long>(expansion.order());
    const std::size_t count = of.outputs().size();
    return tail_by_norms(of, norms_of_steps<R>(of, expansion, expansion.order(), point, radius), expansion.order(),
                         radius, std::vector<magnitude>(count, radius / (order + 1)),
                         std::vector<magnitude>(count, radius / (order + 2)));
}

std::optional<tail_bound> bounded_singular_tail(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                                const magnitude& radius) {
    std::vector<magnitude> factors;
    for (std::size_t i = 0; i < of.outputs().size(); ++i) {
        const auto& weights = of.weights()[i][i];
        ball falling(1);
        ball least(0);
        for (std::size_t l = 0; l < weights.size(); ++l) {
            least -= abs(constant_value<ball>::of(weights[l])) * falling;
            falling *= degree + 1 - static_cast<int>(l);
        }
        least += falling;
        if (arb_is_positive(least.handle()) == 0) {
            return std::nullopt;
        }
        factors.emplace_back(ball(1) / least);
    }
    return tail_by_norms(of, norms_of_steps<ball>(of, expansion, degree, ball(0), radius), degree, radius, factors,
                         factors);
}

template std::optional<tail_bound> bounded_tail(const tape&, const taylor_expansion<ball>&, const ball&,
                                                const magnitude&);
template std::optional<tail_bound> bounded_tail(const tape&, const taylor_expansion<complex_number<ball>>&,
                                                const complex_number<ball>&, const magnitude&);

}  // namespace libration::ode
