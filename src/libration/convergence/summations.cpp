#include "summations.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "libration/approximant/conformal_map.hpp"
#include "libration/approximant/differential_solution.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/convergence/list.hpp"

namespace libration::convergence {

namespace {

constexpr int most_denominator = 80;
constexpr int most_unknowns = 110;

mpfr polynomial_value(std::span<const mpfr> c, const mpfr& x) {
    mpfr sum(0);
    for (std::size_t k = c.size(); k-- > 0;) {
        horner_step(sum, x, c[k]);
    }
    return sum;
}

series::power_series<mpfr> series_of(std::span<const mpfr> a) {
    return series::power_series<mpfr>(std::vector<mpfr>(a.begin(), a.end()));
}

// [L/M] with L + M = N, or the next smaller M whose equations are regular.
std::optional<pade_approximant<mpfr>> regular_pade(const series::power_series<mpfr>& a, int denominator_degree) {
    for (int m = std::min(denominator_degree, most_denominator); m > 0; --m) {
        if (auto found = pade(a, a.order() - m, m)) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<mpfr> quotient(const pade_approximant<mpfr>& of, const mpfr& x) {
    const mpfr below = polynomial_value(of.denominator.coefficients(), x);
    return below == 0 ? std::nullopt : std::optional<mpfr>(polynomial_value(of.numerator.coefficients(), x) / below);
}

// The values at points of any sign and order.
std::vector<std::optional<mpfr>> values_along_axis(const differential_relation& relation, std::span<const mpfr> a,
                                                   int length, const std::vector<mpfr>& points) {
    std::vector<std::optional<mpfr>> values(points.size());
    for (const bool negative : {true, false}) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if ((points[i] < 0) == negative) {
                order.push_back(i);
            }
        }
        std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return abs(points[i]) < abs(points[j]); });
        std::vector<mpfr> targets;
        for (const std::size_t i : order) {
            targets.push_back(points[i]);
        }
        auto found = solution_along_axis(relation, a, length, targets);
        for (std::size_t k = 0; k < order.size(); ++k) {
            values[order[k]] = std::move(found[k]);
        }
    }
    return values;
}

constexpr std::array<differential_track, 8> summed_tracks{
    {{1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {1, 4, 0}, {2, 0, 0}, {2, 1, 0}, {2, 3, 0}, {2, 5, 0}}};

}  // namespace

std::string name_of(sum_kind kind) {
    switch (kind) {
        case sum_kind::partial_sum: return "sum";
        case sum_kind::pade: return "pade";
        case sum_kind::differential: return "differential";
        case sum_kind::equation: return "equation";
        case sum_kind::euler: return "euler";
        case sum_kind::cut: return "cut";
        case sum_kind::borel_pade: return "borel-pade";
        case sum_kind::borel_differential: return "borel-differential";
        case sum_kind::borel_equation: return "borel-equation";
        case sum_kind::borel_cut: break;
    }
    return "borel-cut";
}

summations::summations(std::vector<mpfr> a, sum_shape shape, std::vector<mpfr> points, const task_runner& run)
    : a_(std::move(a)), shape_(std::move(shape)), points_(std::move(points)), run_(run) {
    if (shape_.gevrey) {
        for (const rational& b : {rational(1), rational(3, 2), rational(2), rational(3)}) {
            const auto transform = borel_transform(a_, *shape_.gevrey, b);
            const mpfr unit = level_unit(transform);
            borel_list list{laplace_rule(*shape_.gevrey, b), unit, in_unit(transform, unit, digits<mpfr>()), {}};
            if (shape_.real_action) {
                list.in_cut = in_cut_variable(list.transform, mpfr(-*shape_.real_action / unit));
            }
            borel_.push_back(std::move(list));
        }
    } else if (shape_.real) {
        in_euler_ = in_euler_variable(series::power_series<mpfr>(a_), mpfr(-*shape_.real)).coefficients();
        in_cut_ = in_cut_variable(a_, mpfr(-*shape_.real));
    }
}

std::vector<summation> summations::of_length(int last) const {
    std::vector<summation> all;
    add_pade(last, all);
    if (shape_.gevrey) {
        add_borel(last, all);
        return all;
    }
    add_partial_sums(last, all);
    add_maps(last, all);
    add_differential(last, all);
    return all;
}

void summations::add_partial_sums(int last, std::vector<summation>& all) const {
    summation& sum = all.emplace_back(summation{sum_kind::partial_sum, 0});
    for (const mpfr& x : points_) {
        const bool inside = shape_.inside && abs(x) < *shape_.inside;
        sum.add(inside ? std::optional(polynomial_value(first(a_, last), x)) : std::nullopt);
    }
}

// [N-M/M] with M = N/2, N/2 + 1 and N/2 - 1.
void summations::add_pade(int last, std::vector<summation>& all) const {
    const auto list = series_of(first(a_, last));
    for (const int more : {0, 1, -1}) {
        if (const auto found = regular_pade(list, last / 2 + more)) {
            summation& sum = all.emplace_back(summation{sum_kind::pade, more});
            for (const mpfr& x : points_) {
                sum.add(quotient(*found, x));
            }
        }
    }
}

void summations::add_maps(int last, std::vector<summation>& all) const {
    if (!shape_.real) {
        return;
    }
    const mpfr R = -*shape_.real;
    summation euler{sum_kind::euler, 0};
    summation cut{sum_kind::cut, 0};
    for (const mpfr& x : points_) {
        const bool opposite = x / R > 0;
        euler.add(opposite ? std::optional(polynomial_value(first(in_euler_, last), euler_variable(x, R)))
                           : std::nullopt);
        cut.add(opposite ? std::optional(polynomial_value(first(in_cut_, last), cut_variable(x, R))) : std::nullopt);
    }
    all.push_back(std::move(euler));
    all.push_back(std::move(cut));
}

void summations::add_differential(int last, std::vector<summation>& all) const {
    add_equations(a_, last, 0, all, [&](const differential_relation& relation, int length, summation& sum) {
        sum.kind = relation.exact ? sum_kind::equation : sum_kind::differential;
        for (const auto& value : values_along_axis(relation, a_, length, points_)) {
            sum.add(value);
        }
    });
}

// sum_by(relation, its length, the summation to complete) for the equations of a_0 .. a_last. A list that is longer than
// a track loses as many coefficients at its end as `last` leaves out.
template <class SumBy>
void summations::add_equations(const std::vector<mpfr>& a, int last, int variant, std::vector<summation>& all,
                               const SumBy& sum_by) const {
    const int left_out = static_cast<int>(a.size()) - 1 - last;
    const auto list = first(a, last);
    std::vector<std::optional<summation>> found(summed_tracks.size());
    const long digits = working_digits();
    run_(summed_tracks.size(), [&](std::size_t i) {
        const precision_scope scope(digits);
        const differential_track& track = summed_tracks[i];
        const int length = std::min(last, track.degree + most_unknowns - left_out);
        if (const auto relation = relation_of(list, track, length, bits_for(last))) {
            found[i] = summation{sum_kind::differential, variant + static_cast<int>(i)};
            sum_by(*relation, length, *found[i]);
        }
    });
    for (auto& each : found) {
        if (each) {
            all.push_back(*std::move(each));
        }
    }
}

void summations::add_borel(int last, std::vector<summation>& all) const {
    for (std::size_t i = 0; i < borel_.size(); ++i) {
        const int variant = static_cast<int>(i);
        for (const int order : {last, last - 1}) {
            add_borel_pade(borel_[i], 2 * variant + last - order, order, all);
        }
        add_borel_cut(borel_[i], variant, last, all);
        if (i % 2 == 0) {
            add_borel_differential(borel_[i], 100 * variant, last, all);
        }
    }
}

// The transform at the nodes of all points by one integration of each equation.
void summations::add_borel_differential(const borel_list& list, int variant, int last,
                                        std::vector<summation>& all) const {
    const auto nodes = list.rule.points();
    std::vector<mpfr> targets;
    for (const mpfr& x : points_) {
        for (const mpfr& at : nodes) {
            targets.push_back(x / list.unit * at);
        }
    }
    const auto sum_by = [&](const differential_relation& relation, int length, summation& sum) {
        sum.kind = relation.exact ? sum_kind::borel_equation : sum_kind::borel_differential;
        const auto values = values_along_axis(relation, list.transform, length, targets);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const auto here = std::span(values).subspan(i * nodes.size(), nodes.size());
            sum.values.emplace_back();
            if (std::ranges::all_of(here, [](const auto& each) { return each.has_value(); })) {
                auto next = here.begin();
                const auto integral = list.rule.integral([&](const mpfr&) { return **next++; });
                sum.values.back() = computed_sum{integral.value, integral.error};
            }
        }
    };
    add_equations(list.transform, last, variant, all, sum_by);
}

void summations::add_borel_pade(const borel_list& list, int variant, int last, std::vector<summation>& all) const {
    const auto found = regular_pade(series_of(first(list.transform, last)), last / 2);
    if (!found) {
        return;
    }
    summation& sum = all.emplace_back(summation{sum_kind::borel_pade, variant});
    for (const mpfr& x : points_) {
        const auto integral = list.rule.integral(*found, mpfr(x / list.unit));
        sum.values.push_back(integral ? std::optional(computed_sum{integral->value, integral->error}) : std::nullopt);
    }
}

void summations::add_borel_cut(const borel_list& list, int variant, int last, std::vector<summation>& all) const {
    if (list.in_cut.empty()) {
        return;
    }
    const mpfr R = -*shape_.real_action / list.unit;
    summation& sum = all.emplace_back(summation{sum_kind::borel_cut, variant});
    for (const mpfr& x : points_) {
        if (x / R <= 0) {
            sum.values.emplace_back();
            continue;
        }
        const auto integral = list.rule.integral([&](const mpfr& u) {
            return polynomial_value(first(list.in_cut, last), cut_variable(mpfr(x / list.unit * u), R));
        });
        sum.values.push_back(computed_sum{integral.value, integral.error});
    }
}

}  // namespace libration::convergence
