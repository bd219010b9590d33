#include "libration/expansion/tail_bound.hpp"

#include <algorithm>
#include <stdexcept>

#include "set_values.hpp"

namespace libration::ode {

namespace {

constexpr int most_attempts = 40;

// The norms of a step of the tape for the polynomials p: of the degrees below N, and of the others.
struct step_norm {
    std::vector<magnitude> terms;  // |a_j| rho^j, j < N, where a product needs them
    magnitude low;
    magnitude rest;
};

class norms_of_steps {
public:
    // All arguments must outlive it.
    norms_of_steps(const tape& of, const series_sizes& sizes, const magnitude& radius)
        : tape_(of), sizes_(sizes), terms_(static_cast<std::size_t>(sizes.degree)), radius_(radius) {
        magnitude power(1U);
        for (std::size_t j = 0; j <= terms_; ++j) {
            powers_.push_back(power);
            power *= radius;
        }
        all_.reserve(of.steps().size());
        for (std::size_t i = 0; i < of.steps().size(); ++i) {
            all_.push_back(norm_of(of.steps()[i], static_cast<int>(i)));
        }
    }

    // ||step, degrees >= N|| for p itself.
    const magnitude& rest(int step) const { return all_[static_cast<std::size_t>(step)].rest; }

    // ||step(p + e) - step(p)|| where of_state(s) bounds ||e_i^(l)|| of the state s.
    template <class OfState>
    std::vector<magnitude> changes(const OfState& of_state) const {
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
                case operation::state: result.push_back(of_state(s)); break;
                case operation::sum:
                case operation::difference: result.push_back(left() + right()); break;
                case operation::scaled: result.push_back(left() * factor_of(s)); break;
                case operation::raised: result.push_back(magnitude(left())); break;
                case operation::by_variable: result.push_back(left() * (sizes_.point + radius_)); break;
                case operation::delayed: result.push_back(left() * shift_of(s)); break;
                case operation::product:
                    result.push_back(norm(s.left) * right() + left() * norm(s.right) + left() * right());
                    break;
                case operation::square: result.push_back(left() * (norm(s.left) + norm(s.left) + left())); break;
                case operation::constant:
                case operation::variable: result.emplace_back(); break;
                case operation::quotient:
                case operation::slope:
                case operation::square_root:
                case operation::power:
                case operation::function:
                case operation::primitive:
                case operation::companion: refuse(); break;
            }
        }
        return result;
    }

private:
    [[noreturn]] static void refuse() { throw std::logic_error("theorem T takes products and sums alone"); }

    magnitude factor_of(const tape_step& s) const {
        if (s.constant >= 0) {
            return sizes_.constants[static_cast<std::size_t>(s.constant)];
        }
        const auto above = static_cast<unsigned long>(s.numerator < 0 ? -static_cast<long>(s.numerator) : s.numerator);
        return magnitude(above) / static_cast<unsigned long>(s.denominator);
    }

    magnitude shift_of(const tape_step& s) const { return pow(radius_, static_cast<unsigned long>(s.shift)); }

    const step_norm& of(int step) const { return all_[static_cast<std::size_t>(step)]; }

    step_norm norm_of(const tape_step& s, int index) const {
        step_norm result;
        const std::vector<magnitude>& a = sizes_.of_steps[static_cast<std::size_t>(index)];
        result.terms.reserve(terms_);
        for (std::size_t j = 0; j < terms_; ++j) {
            result.terms.push_back(a[j] * powers_[j]);
            result.low += result.terms.back();
        }
        result.rest = rest_of(s, a);
        return result;
    }

    magnitude rest_of(const tape_step& s, const std::vector<magnitude>& a) const {
        switch (s.kind) {
            case operation::state: return a[terms_] * powers_[terms_];
            case operation::constant:
            case operation::variable: return s.kind == operation::variable && terms_ == 1 ? radius_ : magnitude();
            case operation::sum:
            case operation::difference: return of(s.left).rest + of(s.right).rest;
            case operation::scaled: return of(s.left).rest * factor_of(s);
            case operation::raised: return of(s.left).rest;
            case operation::by_variable:
                return of(s.left).rest * (sizes_.point + radius_) + of(s.left).terms.back() * radius_;
            case operation::delayed: return rest_of_delayed(of(s.left), s);
            case operation::product: return rest_of_product(of(s.left), of(s.right));
            case operation::square: return rest_of_product(of(s.left), of(s.left));
            case operation::quotient:
            case operation::slope:
            case operation::square_root:
            case operation::power:
            case operation::function:
            case operation::primitive:
            case operation::companion: break;
        }
        refuse();
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
    const series_sizes& sizes_;
    std::size_t terms_;
    magnitude radius_;
    std::vector<magnitude> powers_;
    std::vector<step_norm> all_;
};

// s with defects_i ||f_i(p), degrees >= N|| + gains_i G_i(s) <= s_i for all i, or its image under the map, which is not
// larger; G by of_state(s, state). The s_i of known unknowns are given.
template <class OfState>
std::optional<std::vector<magnitude>> kept_by_map(const tape& of, const norms_of_steps& norms,
                                                  const magnitude& of_defect, const magnitude& gain,
                                                  const OfState& of_state,
                                                  const std::vector<known_remainder>& known = {}) {
    std::vector<magnitude> defect;
    for (const int output : of.outputs()) {
        defect.push_back(norms.rest(output) * of_defect);
    }
    const auto set_known = [&](std::vector<magnitude>& s) {
        for (const known_remainder& each : known) {
            s[static_cast<std::size_t>(each.unknown)] = each.error;
        }
    };
    set_known(defect);
    const auto image = [&](const std::vector<magnitude>& s) {
        std::vector<magnitude> result = defect;
        const auto changes = norms.changes([&](const tape_step& state) { return of_state(s, state); });
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] += changes[static_cast<std::size_t>(of.outputs()[i])] * gain;
        }
        set_known(result);
        return result;
    };
    const auto nonzero = [](const std::vector<magnitude>& all) {
        return std::ranges::count_if(all, [](const magnitude& each) { return !each.is_zero(); });
    };
    std::vector<magnitude> s = defect;
    const magnitude inflation = magnitude(9U) / 8U;
    // In a chain of unknowns a defect reaches one more of them with each attempt; these attempts are not counted.
    for (int attempt = 0; attempt < most_attempts;) {
        const auto next = image(s);
        attempt += nonzero(next) > nonzero(s) ? 0 : 1;
        if (!std::ranges::all_of(next, [](const magnitude& each) { return each.is_finite(); })) {
            return std::nullopt;
        }
        if (std::ranges::equal(next, s, [](const magnitude& a, const magnitude& b) { return a <= b; })) {
            return image(image(next));
        }
        for (std::size_t i = 0; i < s.size(); ++i) {
            s[i] = next[i] * inflation;
        }
        set_known(s);
    }
    return std::nullopt;
}

}  // namespace

template <field R>
series_sizes sizes_of(const tape& of, const taylor_expansion<R>& expansion, const R& point, int degree) {
    series_sizes result{degree, {}, {}, size_of(point)};
    for (const number& each : of.constants()) {
        result.constants.push_back(size_of(constant_value<R>::of(each)));
    }
    const auto count = static_cast<std::size_t>(degree);
    result.of_steps.reserve(of.steps().size());
    for (std::size_t i = 0; i < of.steps().size(); ++i) {
        const R* const a = expansion.of_step(static_cast<int>(i));
        auto& row = result.of_steps.emplace_back();
        row.reserve(count + 1);
        for (std::size_t j = 0; j < count + (of.steps()[i].kind == operation::state ? 1 : 0); ++j) {
            row.push_back(size_of(a[j]));
        }
    }
    return result;
}

std::optional<tail_bound> bounded_tail(const tape& of, const series_sizes& sizes, const magnitude& radius) {
    const auto order = static_cast<unsigned long>(sizes.degree);
    const norms_of_steps norms(of, sizes, radius);
    auto s = kept_by_map(of, norms, radius / (order + 1), radius / (order + 2),
                         [](const std::vector<magnitude>& errors, const tape_step& state) {
                             return errors[static_cast<std::size_t>(state.left)];
                         });
    return s ? std::optional(tail_bound{radius, sizes.degree, *std::move(s)}) : std::nullopt;
}

std::optional<remainder_bound> bounded_remainder(const tape& of, const taylor_expansion<ball>& expansion,
                                                 const ball& point, const magnitude& length,
                                                 const std::vector<known_remainder>& known) {
    const int degree = expansion.order();
    const series_sizes sizes = sizes_of(of, expansion, point, degree);
    const norms_of_steps norms(of, sizes, length);
    const auto part_of = [](const std::vector<magnitude>& errors, const tape_step& state) {
        return errors[static_cast<std::size_t>(state.left)];
    };
    auto s = kept_by_map(of, norms, length / (static_cast<unsigned long>(degree) + 1), length, part_of, known);
    if (!s) {
        return std::nullopt;
    }
    const auto changes = norms.changes([&](const tape_step& state) { return part_of(*s, state); });
    remainder_bound result;
    for (const int output : of.outputs()) {
        result.slope_error.push_back(norms.rest(output) + changes[static_cast<std::size_t>(output)]);
    }
    result.error = *std::move(s);
    return result;
}

namespace {

// Whether n .. (n-q+1) - sum_l w_l n .. (n-l+1) is positive for all n > degree, by its value with |w| for n = degree +
// 1.
bool determines_coefficients(const std::vector<number>& weights, int degree) {
    ball least = falling(degree + 1, static_cast<int>(weights.size()));
    for (std::size_t l = 0; l < weights.size(); ++l) {
        least -= abs(constant_value<ball>::of(weights[l])) * falling(degree + 1, static_cast<int>(l));
    }
    return arb_is_positive(least.handle()) != 0;
}

}  // namespace

std::optional<tail_bound> bounded_singular_tail(const tape& of, const taylor_expansion<ball>& expansion, int degree,
                                                const magnitude& radius) {
    for (std::size_t i = 0; i < of.outputs().size(); ++i) {
        if (!determines_coefficients(of.weights()[i][i], degree)) {
            return std::nullopt;
        }
    }
    // ||e^(l)|| for ||s^q e^(q)|| = 1.
    const auto part = [&](std::size_t unknown, int l) {
        const ball quotient = falling(degree + 1, l) / falling(degree + 1, of.orders()[unknown]);
        return magnitude(quotient) / pow(radius, static_cast<unsigned long>(l));
    };
    const series_sizes sizes = sizes_of(of, expansion, ball(0), degree);
    const norms_of_steps norms(of, sizes, radius);
    auto s = kept_by_map(of, norms, magnitude(1U), magnitude(1U),
                         [&](const std::vector<magnitude>& highest, const tape_step& state) {
                             const auto unknown = static_cast<std::size_t>(state.left);
                             return highest[unknown] * part(unknown, state.right);
                         });
    if (!s) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < s->size(); ++i) {
        (*s)[i] = (*s)[i] * part(i, 0);
    }
    return tail_bound{radius, degree, *std::move(s)};
}

template series_sizes sizes_of(const tape&, const taylor_expansion<ball>&, const ball&, int);
template series_sizes sizes_of(const tape&, const taylor_expansion<complex_number<ball>>&, const complex_number<ball>&,
                               int);

}  // namespace libration::ode
