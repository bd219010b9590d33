#include "libration/plane/fuchsian_point.hpp"

#include <algorithm>
#include <map>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long longest_class = 2000;

// The sum of c_i e (e - 1) .. (e - i + 1) in powers of e.
std::vector<rational_polynomial> in_powers(const std::vector<rational_polynomial>& c) {
    std::vector<rational_polynomial> result(c.size());
    rational_polynomial falling(rational(1));
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (int k = 0; k <= falling.degree(); ++k) {
            auto& at = result[static_cast<std::size_t>(k)];
            at = at + c[i] * falling[k];
        }
        falling = falling * rational_polynomial({rational(-static_cast<int>(i)), rational(1)});
    }
    return result;
}

integer floor_of(const rational& q) {
    integer below = numerator(q) / denominator(q);
    return below * denominator(q) > numerator(q) ? integer(below - 1) : below;
}

// p(e) = (e - a) quotient(e), the coefficients of p in a field.
std::vector<rational_polynomial> without_root(const std::vector<rational_polynomial>& p, const rational& a) {
    std::vector<rational_polynomial> quotient(p.size() - 1);
    rational_polynomial carried;
    for (std::size_t k = p.size() - 1; k > 0; --k) {
        carried = carried * a + p[k];
        quotient[k - 1] = carried;
    }
    return quotient;
}

bool has_no_value(const std::vector<rational_polynomial>& all) {
    return std::ranges::all_of(all, [](const rational_polynomial& each) { return each.is_zero(); });
}

}  // namespace

fuchsian_point::fuchsian_point(const linear_equation& of, const rational_polynomial& factor) : field_(factor) {
    const std::size_t order = of.order();
    // t - t0 = alpha (1 - x): p_i^(j)(alpha)/j! (-alpha)^(j - i) x^j (d/dx)^i. For x = t - t0 with 1 in the place of -alpha.
    const rational_polynomial minus_alpha = is_start()
                                                ? rational_polynomial(rational(1))
                                                : field_.reduced(rational_polynomial({rational(0), rational(-1)}));
    const rational_polynomial inverse = field_.inverse(minus_alpha);
    std::vector<std::vector<rational_polynomial>> at(order + 1);
    long lowest = 0;
    rational_polynomial scale(rational(1));
    for (std::size_t i = 0; i <= order; ++i) {
        rational_polynomial power = scale;
        for (int j = 0; j <= of.coefficients()[i].degree(); ++j) {
            at[i].push_back(field_.product(of.coefficients()[i].taylor_coefficient(j), power));
            power = field_.product(power, minus_alpha);
        }
        for (std::size_t j = 0; j < at[i].size(); ++j) {
            if (!at[i][j].is_zero()) {
                lowest = std::min(lowest, static_cast<long>(j) - static_cast<long>(i));
                break;
            }
        }
        scale = field_.product(scale, inverse);
    }
    c_.resize(order + 1);
    for (std::size_t i = 0; i <= order; ++i) {
        for (long j = static_cast<long>(i) + lowest; j < static_cast<long>(at[i].size()); ++j) {
            c_[i].push_back(j < 0 ? rational_polynomial() : at[i][static_cast<std::size_t>(j)]);
        }
    }
    std::size_t longest = 1;
    for (const auto& each : c_) {
        longest = std::max(longest, each.size());
    }
    for (auto& each : c_) {
        each.resize(longest);
    }
    regular_ = !c_[order][0].is_zero();
    if (regular_) {
        find_exponents();
        for (exponent_class& each : classes_) {
            solve(each);
        }
    }
}

void fuchsian_point::find_exponents() {
    std::vector<rational_polynomial> leading;
    for (const auto& each : c_) {
        leading.push_back(each[0]);
    }
    std::vector<rational_polynomial> indicial = in_powers(leading);
    // A rational exponent is a common root of the coefficients of the powers of alpha.
    rational_polynomial common;
    for (int m = 0; m < field_.modulus().degree(); ++m) {
        std::vector<rational> part;
        for (const rational_polynomial& each : indicial) {
            part.push_back(each[m]);
        }
        common = common_divisor(common, part);
    }
    std::map<rational, std::map<rational, int>> by_fraction;
    for (const auto& [factor, multiplicity] : irreducible_factors(common)) {
        if (factor.degree() == 1) {
            const rational e = -factor[0];
            by_fraction[e - rational(floor_of(e))].emplace(e, multiplicity);
            for (int k = 0; k < multiplicity; ++k) {
                indicial = without_root(indicial, e);
            }
        }
    }
    others_ = indicial.size() > 1 ? indicial : std::vector<rational_polynomial>{};
    for (const auto& [fraction, exponents] : by_fraction) {
        exponent_class made{exponents.begin()->first, {}, {}};
        const rational length = exponents.rbegin()->first - made.exponent;
        if (length > longest_class) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has exponents at a singular point that differ by " + length.str() + ", more than " +
                            std::to_string(longest_class));
        }
        for (const auto& [e, multiplicity] : exponents) {
            made.offsets.emplace_back(static_cast<long>(numerator(rational(e - made.exponent))), multiplicity);
        }
        classes_.push_back(std::move(made));
    }
}

// Q_l(at + S) up to S^(count-1).
std::vector<rational_polynomial> fuchsian_point::shifted(std::size_t l, const rational& at, std::size_t count) const {
    std::vector<rational_polynomial> sum(count);
    std::vector<rational> product(count);
    product[0] = 1;
    for (std::size_t i = 0; i < c_.size(); ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            sum[k] = sum[k] + c_[i][l] * product[k];
        }
        const rational factor = at - static_cast<int>(i);
        for (std::size_t k = count; k-- > 0;) {
            product[k] = product[k] * factor + (k > 0 ? product[k - 1] : rational(0));
        }
    }
    return sum;
}

void fuchsian_point::solve(exponent_class& of) const {
    for (const auto& [start, multiplicity] : of.offsets) {
        for (int free = 0; free < multiplicity; ++free) {
            exact_local_solution made;
            made.v.resize(static_cast<std::size_t>(of.last() + 1));
            for (long n = start; n <= of.last(); ++n) {
                const auto here = std::ranges::find(of.offsets, n, &std::pair<long, int>::first);
                const std::size_t zeros = here == of.offsets.end() ? 0 : static_cast<std::size_t>(here->second);
                std::vector<rational_polynomial> sum;
                for (long l = 1; l <= n - start && l < static_cast<long>(c_[0].size()); ++l) {
                    const auto& before = made.v[static_cast<std::size_t>(n - l)];
                    if (before.empty()) {
                        continue;
                    }
                    const auto q = shifted(static_cast<std::size_t>(l), of.exponent + (n - l), before.size());
                    sum.resize(std::max(sum.size(), before.size()));
                    for (std::size_t k = 0; k < before.size(); ++k) {
                        for (std::size_t s = 0; k + s < before.size(); ++s) {
                            sum[k] = sum[k] - field_.product(q[s], before[k + s]);
                        }
                    }
                }
                while (!sum.empty() && sum.back().is_zero()) {
                    sum.pop_back();
                }
                const auto q = shifted(0, of.exponent + n, zeros + std::max<std::size_t>(sum.size(), 1));
                const rational_polynomial inverse = field_.inverse(q[zeros]);
                std::vector<rational_polynomial> v(sum.empty() ? 0 : zeros + sum.size());
                for (std::size_t k = sum.size(); k-- > 0;) {
                    rational_polynomial rest = sum[k];
                    for (std::size_t s = 1; k + s < sum.size(); ++s) {
                        rest = rest - field_.product(q[zeros + s], v[zeros + k + s]);
                    }
                    v[zeros + k] = field_.product(rest, inverse);
                }
                if (n == start) {
                    v.assign(static_cast<std::size_t>(free) + 1, {});
                    v.back() = rational_polynomial(rational(1));
                }
                made.v[static_cast<std::size_t>(n)] = std::move(v);
            }
            of.solutions.push_back(std::move(made));
        }
    }
}

bool fuchsian_point::has_single_values() const {
    const auto is_single = [](const exponent_class& each) {
        return denominator(each.exponent) == 1 && std::ranges::all_of(each.solutions, [](const auto& solution) {
                   return std::ranges::all_of(solution.v, [](const auto& v) {
                       return v.size() < 2 || has_no_value({v.begin() + 1, v.end()});
                   });
               });
    };
    return regular_ && others_.empty() && std::ranges::all_of(classes_, is_single);
}

bool fuchsian_point::is_apparent() const {
    return has_single_values() &&
           std::ranges::all_of(classes_, [](const exponent_class& each) { return each.exponent >= 0; });
}

}  // namespace libration::ode
