#include "libration/convergence/sum.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/integer_power.hpp"
#include "reduced_list.hpp"
#include "sum_candidates.hpp"

namespace libration::convergence {

namespace {

constexpr int fewest_summed = 5;
constexpr int few_summed = 12;
constexpr int factor_of_step = 10;  // calibrated
constexpr int contradiction = 12;   // steps of the blunter kind
constexpr int much_blunter = 100;
constexpr int one_digit = 10;

long bits_of_sums(int order) { return 320 + 6L * std::min(order, 160) + order; }

series_value no_value(std::string note) {
    series_value none;
    none.note = std::move(note);
    return none;
}

// A real singularity of a verdict.
struct real_point {
    mpfr position, uncertainty;
};

std::vector<real_point> real_points_of(const list_verdict& verdict) {
    std::vector<real_point> found;
    const auto add = [&](const complex_number<mpfr>& z, const mpfr& uncertainty) {
        if (abs(z.im) <= uncertainty) {
            found.push_back({z.re, uncertainty});
        }
    };
    if (verdict.position) {
        add(*verdict.position, verdict.uncertainty);
    }
    for (const ring_member& each : verdict.ring) {
        add(each.position, each.uncertainty);
    }
    return found;
}

sum_shape shape_of(const list_verdict& verdict) {
    sum_shape shape;
    if (verdict.growth == growth_class::zero) {
        shape.gevrey = verdict.gevrey;
        if (verdict.action && abs(verdict.action->im) <= verdict.action_uncertainty) {
            shape.real_action = verdict.action->re;
        }
        return shape;
    }
    if (verdict.growth == growth_class::infinite) {
        shape.inside = mpfr(1) / 0;
    } else if (verdict.radius && verdict.bound != radius_bound::at_most) {
        shape.inside = mpfr(*verdict.radius - verdict.uncertainty) * 9 / 10;
    }
    const auto real = real_points_of(verdict);
    if (verdict.position && !real.empty()) {
        shape.real = real.front().position;
    }
    return shape;
}

std::string described(const candidate& each) {
    return name_of(each.kind) + " " + to_decimal(each.sum.value, 4) + " +- " + to_decimal(each.sum.step, 2);
}

// The sharpest candidate of each kind, in the order of their steps, of those with a certain digit.
std::vector<candidate> convergent_kinds(const std::vector<candidate>& all) {
    std::vector<candidate> kinds;
    for (const candidate& each : all) {
        const bool converges = each.sum.step * one_digit <= abs(each.sum.value);
        if (converges && std::ranges::none_of(kinds, [&](const candidate& other) { return other.kind == each.kind; })) {
            kinds.push_back(each);
        }
    }
    return kinds;
}

// Whether at least two equations that the whole list satisfies are among the members.
bool by_equations(const std::vector<candidate>& all, const vote_result& vote) {
    return std::ranges::count_if(vote.members, [&](std::size_t i) { return all[i].kind == sum_kind::equation; }) >= 2;
}

// The uncertainty of a vote by its spread and by the distance of the two sharpest kinds; std::nullopt if these
// contradict each other.
std::optional<mpfr> uncertainty_of(const vote_result& vote, const std::vector<candidate>& kinds, bool exact,
                                   int order) {
    mpfr uncertainty = std::max(vote.spread, vote.step) * factor_of_step;
    if (order < few_summed) {
        uncertainty *= factor_of_step;
    }
    if (exact) {
        return uncertainty;
    }
    if (kinds.size() == 1) {
        return uncertainty * factor_of_step;
    }
    const stepped_value& first = kinds[0].sum;
    const stepped_value& second = kinds[1].sum;
    const mpfr apart = abs(mpfr(first.value - second.value));
    if (apart > second.step * contradiction + uncertainty) {
        return std::nullopt;
    }
    const bool blunt = second.step > first.step * much_blunter;
    return std::max(uncertainty, blunt ? std::min(apart, mpfr(second.step * 3)) : apart);
}

// g(z) by the vote of the candidates, which are sorted by their steps, if enough kinds of them agree.
series_value elected(const std::vector<candidate>& all, bool inside, int order) {
    std::vector<stepped_value> values;
    for (const candidate& each : all) {
        values.push_back(each.sum);
    }
    if (values.empty()) {
        return no_value("no method applies");
    }
    const vote_result vote = *vote_on(values, std::max(mpfr(abs(values.front().value)), values.front().step));
    const auto kinds = convergent_kinds(all);
    if (kinds.empty()) {
        return no_value("no method converges");
    }
    const bool exact = by_equations(all, vote);
    const auto uncertainty = uncertainty_of(vote, kinds, exact, order);
    if (!uncertainty) {
        return no_value("the methods contradict each other: " + described(kinds[0]) + ", " + described(kinds[1]));
    }
    if (!inside && !exact && kinds.size() < 2) {
        return no_value("only one kind of method converges: " + described(kinds[0]));
    }
    series_value found{vote.value, *uncertainty, {}, ""};
    for (const std::size_t i : vote.members) {
        if (std::string name = name_of(all[i].kind); std::ranges::find(found.methods, name) == found.methods.end()) {
            found.methods.push_back(std::move(name));
        }
    }
    return found;
}

// The values of one list at several points.
class list_summation {
public:
    list_summation(const series_list& list, std::span<const mpfr> noise, std::span<const mpfr> points,
                   const task_runner& run)
        : list_(list),
          reduced_(list, noise, bits_of_sums(list.order())),
          points_(points),
          values_(points.size()),
          run_(run) {
        noise_of_first_ = noise.empty() ? mpfr(0) : noise.front();
        if (reduced_.pattern().last >= 0 && !reduced_.pattern().polynomial) {
            verdict_ = verdict_on({reduced_.values(), list.noise}, run);
        }
    }

    std::vector<series_value> all() {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (auto known = without_methods(points_[i])) {
                values_[i] = *std::move(known);
            } else {
                open.push_back(i);
            }
        }
        std::ranges::stable_sort(open, [&](std::size_t i, std::size_t j) { return abs(points_[i]) < abs(points_[j]); });
        if (!open.empty()) {
            add_values(open);
        }
        return std::move(values_);
    }

private:
    // The value that needs no summation, or the reason why there is none.
    std::optional<series_value> without_methods(const mpfr& x) const {
        const coefficient_pattern& pattern = reduced_.pattern();
        if (x == 0) {
            return certain({list_.values.front(), noise_of_first_}, "sum", "the first coefficient");
        }
        if (pattern.last < 0) {
            return no_value("all coefficients are 0");
        }
        if (pattern.polynomial) {
            if (!is_certain_polynomial()) {
                return no_value("too many coefficients are 0");
            }
            const auto f = reduced_.complete({mpfr(0), mpfr(0)}, x);
            return certain(f, "sum", "the polynomial of degree " + std::to_string(pattern.last));
        }
        if (pattern.lacunary) {
            return no_value("its gaps grow: a natural boundary is likely");
        }
        if (reduced_.values().size() < fewest_summed) {
            return no_value("there are too few coefficients");
        }
        if (verdict_.suspect && verdict_.suspect->confirmed) {
            const int index = pattern.first + pattern.stride * verdict_.suspect->index;
            return no_value("coefficient " + std::to_string(index) + " contradicts the others");
        }
        return singular_before(x);
    }

    // Three quarters of the coefficients up to the last nonzero one are nonzero, and twice as many zeros follow.
    bool is_certain_polynomial() const {
        const coefficient_pattern& pattern = reduced_.pattern();
        int nonzero = 0;
        for (int n = 0; n <= pattern.last; ++n) {
            nonzero += list_.values[static_cast<std::size_t>(n)] != 0 ? 1 : 0;
        }
        return pattern.order >= 3 * pattern.last + 3 && 4 * nonzero >= 3 * (pattern.last + 1);
    }

    std::optional<series_value> singular_before(const mpfr& x) const {
        const mpfr z = reduced_.point(x);
        if (verdict_.growth == growth_class::zero) {
            if (!verdict_.gevrey || *verdict_.gevrey <= 0) {
                return no_value(
                    "the radius of convergence is 0, and the growth of the coefficients is of no known order");
            }
            const bool on_ray = verdict_.action && abs(verdict_.action->im) <= verdict_.action_uncertainty &&
                                verdict_.action->re / z > 0;
            return on_ray ? std::optional(no_value("on a Stokes line: the Borel transform is singular on this ray"))
                          : std::nullopt;
        }
        for (const real_point& each : real_points_of(verdict_)) {
            if (each.position / z > 0 && abs(each.position) - each.uncertainty <= abs(z)) {
                return no_value("the singularity at " + to_decimal(reduced_.place_of(each.position, x), 4) +
                                " is between 0 and this point");
            }
        }
        return std::nullopt;
    }

    void add_values(const std::vector<std::size_t>& open) {
        std::vector<mpfr> points;
        for (const std::size_t i : open) {
            points.push_back(reduced_.point(points_[i]));
        }
        const sum_shape shape = shape_of(verdict_);
        const sum_candidates candidates(reduced_, shape, points, run_);
        const int order = static_cast<int>(reduced_.values().size()) - 1;
        for (std::size_t k = 0; k < open.size(); ++k) {
            const bool inside = shape.inside && abs(points[k]) < *shape.inside;
            const series_value g = elected(candidates.at(k), inside, order);
            series_value& f = values_[open[k]];
            if (!g.value) {
                f = g;
                continue;
            }
            const auto complete = reduced_.complete({*g.value, g.uncertainty}, points_[open[k]]);
            f = with_certain_digit(complete, g.methods);
            if (f.value && shape.gevrey) {
                f.note = "the Borel sum";
            } else if (f.value && verdict_.radius && abs(points[k]) > *verdict_.radius) {
                f.note = "beyond the radius: on the branch reached along the real axis";
            }
        }
    }

    static series_value with_certain_digit(const reduced_list::value_with_error& f, std::vector<std::string> methods) {
        if (f.error * one_digit > abs(f.value)) {
            return no_value("no digit is certain: " + to_decimal(f.value, 2) + " +- " + to_decimal(f.error, 2));
        }
        return {f.value, f.error, std::move(methods), ""};
    }

    static series_value certain(const reduced_list::value_with_error& f, std::string method, std::string note) {
        return {f.value, f.error, {std::move(method)}, std::move(note)};
    }

    const series_list& list_;
    reduced_list reduced_;
    std::span<const mpfr> points_;
    std::vector<series_value> values_;
    mpfr noise_of_first_;
    list_verdict verdict_;
    const task_runner& run_;
};

}  // namespace

long digits_of_list(int order) { return decimal_digits(std::max(bits_of_sums(order), bits_for(order))); }

std::vector<series_value> sums_of_list(const series_list& list, std::span<const mpfr> noise,
                                       std::span<const mpfr> points, const task_runner& run) {
    const precision_scope scope(decimal_digits(bits_of_sums(list.order())));
    return list_summation(list, noise, points, run).all();
}

}  // namespace libration::convergence
