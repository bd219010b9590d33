#include "manifold_end.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int degree_of_plan = 10;
constexpr int degree_of_test = 20;
constexpr int most_scales = 24;
constexpr long largest_log2_scale = 3;
constexpr long least_log2_scale = -40;
constexpr long bits_of_plan = 128;

std::vector<complex_ball> complex_of(const std::vector<ball>& numbers) {
    std::vector<complex_ball> result;
    result.reserve(numbers.size());
    for (const ball& each : numbers) {
        result.emplace_back(each, ball(0));
    }
    return result;
}

std::vector<ball> exact_balls(const std::vector<double>& numbers) {
    std::vector<ball> result;
    result.reserve(numbers.size());
    for (const double each : numbers) {
        result.push_back(exactly(each));
    }
    return result;
}

}  // namespace

manifold_end::manifold_end(const first_order_form& form, const polynomial_form& lifted, far_state rest,
                           std::vector<expression> numbers, int direction)
    : rest_(std::move(rest)),
      numbers_(std::move(numbers)),
      direction_(direction),
      tape_(tape::about_points(lifted.system)) {
    numbers_.insert(numbers_.end(), rest_.coordinates.begin(), rest_.coordinates.end());
    centres_ = rest_.values;
    const auto at_rest = [&](const expression& leaf) -> std::optional<expression> {
        const auto place = std::ranges::find_if(lifted.leaves, [&](const expression& l) { return same_form(l, leaf); });
        return place == lifted.leaves.end()
                   ? std::nullopt
                   : std::optional(centres_[static_cast<std::size_t>(place - lifted.leaves.begin())]);
    };
    for (const expression& each : lifted.added) {
        try {
            centres_.push_back(replaced(each, at_rest));
        } catch (const error&) {  // a division by an exact 0, a function outside its domain
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a polynomial form without a value at these limits, where theorem W does not apply");
        }
    }
    for (std::size_t k = 0; k < centres_.size(); ++k) {
        const bool constant =
            k < form.slopes.size() && form.slopes[k].is(0) &&
            std::ranges::any_of(numbers_, [&](const expression& leaf) { return same_form(leaf, centres_[k]); }) &&
            std::ranges::none_of(rest_.coordinates,
                                 [&](const expression& leaf) { return same_form(leaf, centres_[k]); });
        const bool is_ignored = k < form.slopes.size() && rest_.ignored[k];
        if (!constant && !is_ignored) {
            moving_.push_back(k);
            if (k < form.slopes.size()) {
                given_moving_.push_back(k);
            }
        }
        auto& row = by_number_.emplace_back();
        for (const expression& leaf : numbers_) {
            row.push_back(partial(centres_[k], leaf));
            depends_ = depends_ || !row.back().is(0);
        }
    }
}

std::vector<complex_jet> manifold_end::centre(const std::vector<complex_ball>& numbers, bool slopes) const {
    expression_values<complex_ball> values(numbers_, complex_ball(ball(0), ball(0)));
    for (const complex_ball& each : numbers) {
        values.push_back(each);
    }
    std::vector<complex_jet> result;
    for (std::size_t k = 0; k < centres_.size(); ++k) {
        result.emplace_back(values.of(centres_[k]));
        if (slopes && std::ranges::any_of(by_number_[k], [](const expression& each) { return !each.is(0); })) {
            for (const expression& each : by_number_[k]) {
                result.back().slopes.push_back(values.of(each));
            }
        }
    }
    return result;
}

field_at_rest manifold_end::field(const std::vector<complex_ball>& numbers, bool slopes) const {
    return {&tape_, centre(numbers, slopes), moving_, direction_};
}

std::vector<double> manifold_end::rest_values(const std::vector<double>& numbers) const {
    std::vector<double> result;
    const auto values = centre(complex_of(exact_balls(numbers)), false);
    for (const std::size_t k : given_moving_) {
        result.push_back(as_double(values[k].value.re));
    }
    return result;
}

std::vector<double> manifold_end::theta_near(const std::vector<double>& numbers,
                                             const std::vector<double>& given) const {
    const precision_scope scope(decimal_digits(bits_of_plan));
    const auto here = field(complex_of(exact_balls(numbers)), false);
    const auto frame = enclosed_frame(linear_part(here), plan_);
    std::vector<double> result(plan_.size());
    // The other unknowns follow from the given ones: least squares by the rows of these alone.
    const auto rest = rest_values(numbers);
    const std::size_t n = given_moving_.size();
    const std::size_t k = plan_.size();
    if (!frame) {
        return result;
    }
    jet_matrix normal(k, std::vector<complex_jet>(k));
    std::vector<complex_jet> right(k);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t a = 0; a < k; ++a) {
            const complex_jet left = conjugate(frame->columns[i][a]);
            for (std::size_t b = 0; b < k; ++b) {
                normal[a][b].add_product(left, frame->columns[i][b]);
            }
            right[a].add_product(left, complex_jet(complex_ball(exactly(given[i] - rest[i]), ball(0))));
        }
    }
    const auto by = inverse(normal);
    if (by) {
        const auto theta = product(*by, right);
        for (std::size_t j = 0; j < k; ++j) {
            result[j] = as_double(plan_.ends_pair(j) ? theta[j - 1].value.im : theta[j].value.re);
        }
    }
    return result;
}

// By Gershgorin's theorem for the block in B_ss.
std::optional<manifold_end::decay> manifold_end::decay_at(const std::vector<ball>& numbers) const {
    const auto frame = enclosed_frame(linear_part(field(complex_of(numbers), false)), plan_);
    if (!frame) {
        return std::nullopt;
    }
    decay result{std::vector<complex_ball>(plan_.size()), {}, std::vector<bool>(plan_.size())};
    for (const frame_block& block : plan_.blocks) {
        std::optional<complex_ball> all;
        for (const std::size_t j : block.columns) {
            magnitude beside;
            for (const std::size_t l : block.columns) {
                if (l != j) {
                    beside += size_of_complex(frame->inner[j][l].value);
                }
            }
            const complex_ball& at = frame->inner[j][j].value;
            const complex_ball disc(widened(at.re, beside), widened(at.im, beside));
            all = all ? complex_ball(hull(all->re, disc.re), hull(all->im, disc.im)) : disc;
        }
        for (const std::size_t j : block.columns) {
            result.rates[j] = *all;
            result.alone[j] = block.columns.size() == 1 && !plan_.begins_pair(j);
            if (plan_.begins_pair(j)) {
                result.rates[j + 1] = conjugate(*all);
            }
        }
    }
    for (std::size_t i = 0; i < given_moving_.size(); ++i) {
        auto& row = result.columns.emplace_back();
        for (std::size_t j = 0; j < plan_.size(); ++j) {
            row.push_back(frame->columns[i][j].value);
        }
    }
    return result;
}

std::optional<invariant_manifold> manifold_end::series(const std::vector<complex_ball>& numbers, bool slopes,
                                                       int degree) const {
    const field_at_rest here = field(numbers, slopes);
    const auto frame = enclosed_frame(linear_part(here), plan_);
    if (!frame) {
        return std::nullopt;
    }
    return invariant_manifold(here, *frame, plan_, degree);
}

bool manifold_end::choose(const std::vector<double>& numbers, std::size_t most, bool proved) {
    const precision_scope scope(decimal_digits(bits_of_plan));
    const auto at = complex_of(exact_balls(numbers));
    plan_ = stable_plan(linear_part(field(at, false)), most);
    if (plan_.size() == 0) {
        return true;
    }
    const auto first = series(at, false, degree_of_plan);
    if (!first) {
        return false;
    }
    // The largest l for which sum_(m > 1) l^(m-1) size_m <= 1.
    const auto sizes = first->sizes();
    const auto sum_at = [&](long scale) {
        double sum = 0;
        for (std::size_t m = 2; m < sizes.size(); ++m) {
            sum += std::ldexp(sizes[m], static_cast<int>(scale * static_cast<long>(m - 1)));
        }
        return sum;
    };
    double size = 1;
    for (const std::size_t k : given_moving_) {
        size = std::max(size, std::fabs(as_double(centre(at, false)[k].value.re)));
    }
    plan_.log2_scale = std::lround(std::log2(size)) + largest_log2_scale;
    while (plan_.log2_scale > least_log2_scale && !(sum_at(plan_.log2_scale) <= 1)) {
        --plan_.log2_scale;
    }
    if (!proved) {
        return true;
    }
    for (int k = 0; k < most_scales; ++k, --plan_.log2_scale) {
        const auto tested = series(at, false, degree_of_test);
        if (tested && tested->tails()) {
            return true;
        }
    }
    return false;
}

// Beyond it no term is resonant, so that the normal form does not depend on the degree.
int manifold_end::least_degree() const {
    double slowest = INFINITY;
    double fastest = 0;
    for (const auto& each : plan_.rates) {
        slowest = std::min(slowest, -each.real());
        fastest = std::max(fastest, -each.real());
    }
    return static_cast<int>(std::ceil(fastest / slowest)) + 2;
}

double manifold_end::good_radius() const {
    switch (plan_.size()) {
        case 0:
        case 1: return 0.25;
        case 2: return 1. / 16;
        default: return 1. / 64;
    }
}

std::vector<ball> manifold_end::rest_at(const std::vector<ball>& numbers) const {
    const auto values = centre(complex_of(numbers), false);
    std::vector<ball> result;
    for (const std::size_t k : given_moving_) {
        result.push_back(values[k].value.re);
    }
    return result;
}

std::optional<manifold_end::enclosed> manifold_end::at(const std::vector<ball>& numbers, const std::vector<ball>& theta,
                                                       int degree, bool proved) const {
    const std::size_t k = plan_.size();
    degree = proved ? std::max(degree, least_degree()) : degree;
    const auto box = complex_of(numbers);
    const auto complex_theta = coordinates(theta);
    magnitude radius;
    for (const complex_ball& each : complex_theta) {
        radius = std::max(radius, size_of_complex(each));
    }
    const auto points = series(box, depends_, degree);
    if (!points) {
        return std::nullopt;
    }
    std::optional<std::vector<magnitude>> tails = std::vector<magnitude>(moving_.size());
    magnitude per_number;
    if (proved) {
        // Analytic in the polydisc of radius q about the box of numbers: the tails are bounded there, and their derivatives by Cauchy.
        const magnitude q = magnitude::of(1, -ball::working_bits() / 2);
        auto around = box;
        for (complex_ball& each : around) {
            each = {widened(each.re, q), widened(each.im, q)};
        }
        const auto whole = depends_ ? series(around, false, degree) : points;
        tails = whole ? whole->tails() : std::nullopt;
        const magnitude steps = magnitude(static_cast<unsigned>(degree) + 2) * radius;
        if (!tails || !(radius < magnitude(1U)) || !(steps <= magnitude(static_cast<unsigned>(degree) + 1))) {
            return std::nullopt;
        }
        const magnitude power = pow(radius, static_cast<unsigned long>(degree));
        for (magnitude& each : *tails) {
            each *= power;
        }
        per_number = magnitude(1U) / q;
    }
    const auto p = points->at(complex_theta);
    enclosed result;
    for (std::size_t i = 0; i < given_moving_.size(); ++i) {
        // given unknowns are the first of the moving ones
        const complex_jet& value = p.value[i];
        const magnitude tail = (*tails)[i] * radius;
        result.value.push_back(widened(value.value.re, tail));
        auto& by_numbers = result.by_numbers.emplace_back(numbers.size());
        for (std::size_t j = 0; j < numbers.size(); ++j) {
            by_numbers[j] = j < value.slopes.size() ? value.slopes[j].re : ball(0);
            if (depends_) {
                by_numbers[j] = widened(by_numbers[j], tail * per_number);
            }
        }
        auto& by_theta = result.by_theta.emplace_back();
        const magnitude slope_tail = (*tails)[i] * magnitude(static_cast<unsigned>(degree) + 1);
        for (std::size_t j = 0; j < k; ++j) {
            const auto& row = p.by_theta[i];
            const bool ends = plan_.ends_pair(j);
            const bool paired = ends || plan_.begins_pair(j);
            // d/d(re) = D + conj D, d/d(im) = i (D - conj D).
            const ball slope = !paired ? row[j].value.re : ends ? row[j - 1].value.im * -2 : row[j].value.re * 2;
            by_theta.push_back(widened(slope, paired ? slope_tail.shifted(1) : slope_tail));
        }
    }
    return result;
}

}  // namespace libration::ode
