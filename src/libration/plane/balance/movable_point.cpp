#include "libration/plane/balance/movable_point.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "../ray_state.hpp"
#include "local_solution.hpp"
#include "movable_expansion.hpp"

namespace libration::ode {

namespace {

constexpr int level_of_sample = 28;
constexpr double highest_weight = 48;
constexpr double few_weights = 14;
constexpr std::size_t most_monomials = 2'600;
constexpr std::size_t few_monomials = 300;
constexpr int most_first_corrections = 16;
constexpr int most_last_corrections = 12;
constexpr long bits_of_first_corrections = 200;
constexpr long known_bits_of_place = 40;
constexpr double longest_movable_reach = 0.97;
constexpr double shorter_reach = 0.94;
constexpr int most_reaches = 140;  // exponents 5/2 + 3.4 i leave a hundredth
// Near enough that the pieces before it reach the points that are in no tip.
constexpr double longest_distance_of_base = 0.02;
constexpr double part_of_reach_of_base = 0.2;
constexpr long bits_of_polydisc = 40;
constexpr long bits_of_coefficients = 12;

magnitude above(const complex_ball& z) { return hypotenuse(magnitude(z.re), magnitude(z.im)); }
complex_ball widened_by(const complex_ball& z, const magnitude& by) { return {widened(z.re, by), widened(z.im, by)}; }

// One set of parameters: t* - t0, the finite limits, the free log S, and the coefficients at the growing resonances.
class movable_search {
public:
    movable_search(const explicit_system& system, const chart_atlas& atlas, std::size_t shown, const complex_ball& near)
        : system_(system), atlas_(atlas), shown_(shown), near_(rounded_midpoint(near)), real_(near_.imag() == 0) {
        const polynomial_form& form = atlas.chart(0).form().lifted;
        const auto rows = field_terms_of(form.system, form.leaves);
        if (!rows) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has no polynomial form with constant coefficients, of which a singularity could be analysed");
        }
        origin_ = atlas.time(complex_ball(0));
        balance_sample sample{.place = near_, .origin = rounded_midpoint(origin_).real(), .level = level_of_sample};
        const auto observed = [&](int level) {
            std::vector<std::complex<double>> result;
            const std::complex<double> at = near_ * (1 - std::ldexp(1.0, -level));
            for (const complex_ball& each : full_state(at)) {
                result.push_back(rounded_midpoint(each));
            }
            return result;
        };
        sample.values = observed(level_of_sample);
        sample.before = observed(level_of_sample - 1);
        local_ = std::make_unique<local_solution>(dominant_balance_of(*rows, sample), origin_);
        const bool is_singular = std::ranges::any_of(local_->balance().orders, [](const rational& m) { return m > 0; });
        if (!is_singular) {
            throw error(error_kind::undecided, error_subject::problem, "", "has no singularity where one is expected");
        }
        for (std::size_t k = 0; k < local_->balance().free.size(); ++k) {
            const std::size_t i = local_->balance().free[k];
            free_guess_.push_back(std::log(sample.values[i]) -
                                  static_cast<double>(local_->balance().orders[i]) * level_of_sample * std::log(2.0));
        }
        for (const std::size_t i : local_->balance().finite) {
            finite_guess_.push_back(sample.values[i]);
        }
    }

    // Of the weights and orders.
    double largest_exponent() const {
        double weight = 1;
        double order = 0;
        for (const quadratic_number& each : local_->weights()) {
            weight = std::max(weight, each.real_part());
        }
        for (const rational& each : local_->balance().orders) {
            order = std::max(order, static_cast<double>(each));
        }
        return weight + order;
    }

    movable_point found() {
        const long bits = ball::working_bits();
        const weighted_monomials few(local_->weights(), few_weights, few_monomials);
        const weighted_monomials many(local_->weights(), highest_weight, most_monomials);
        const auto level = static_cast<int>(static_cast<double>(bits) / many.least_beyond()) + 4;
        base_ = near_ * (1 - std::ldexp(1.0, -level));
        const long guard = 2 * bits_of_polydisc + 64 + static_cast<long>(level * largest_exponent());
        const precision_scope more(decimal_digits(bits + guard));
        local_->set_base(base_);
        state_ = full_state(base_);
        complex_row x = corrected(few, many);
        return proved(many, std::move(x));
    }

private:
    std::vector<complex_ball> full_state(std::complex<double> at) const {
        const int order = static_cast<int>(ball::working_bits()) + 20;
        const plane_system& chart = atlas_.chart(0);
        return lifted_values(chart.form().lifted, atlas_.time(exact_point(at)),
                             state_on_ray(system_, atlas_, at, order));
    }

    std::vector<magnitude> radii_of_parameters(const complex_row& x) const {
        std::vector<magnitude> result;
        for (std::size_t l = 0; l < local_->size(); ++l) {
            const magnitude scale = l == 0 ? above(x[0]) : std::max(above(x[l]), magnitude(1U));
            result.push_back(scale.shifted(l < local_->first_growing() ? -bits_of_polydisc : -bits_of_coefficients));
        }
        return result;
    }

    complex_row defect_at(const local_model& model, const complex_row& x, const weighted_monomials& monomials) const {
        complex_row defect = local_->values_at_base(model, x, monomials).unknowns;
        for (std::size_t i = 0; i < local_->size(); ++i) {
            defect[i] = defect[i] - state_[i];
        }
        return defect;
    }

    // Newton's method with few weights from the observed values, then with all and one matrix.
    complex_row corrected(const weighted_monomials& few, const weighted_monomials& many) {
        complex_row x{exact_point(near_)};
        for (const auto& each : finite_guess_) {
            x.push_back(exact_point(each));
        }
        for (const auto& each : free_guess_) {
            x.push_back(exact_point(each));
        }
        x.resize(local_->size(), complex_ball(0));
        const long all_bits = ball::working_bits();
        for (int stage = 0; stage < 2; ++stage) {
            const weighted_monomials& monomials = stage == 0 ? few : many;
            const precision_scope scope(
                decimal_digits(stage == 0 ? std::min(all_bits, bits_of_first_corrections + all_bits / 2) : all_bits));
            complex_matrix inverse;
            double last = 1e300;
            for (int k = 0; k < (stage == 0 ? most_first_corrections : most_last_corrections); ++k) {
                const local_model model = local_->model_at(x, monomials);
                if (stage == 0 || inverse.empty()) {
                    std::vector<magnitude> steps = radii_of_parameters(x);
                    for (magnitude& each : steps) {
                        each = each.shifted(-known_bits_of_place);
                    }
                    inverse = inverse_near(local_->slopes_at(model, x, steps, monomials));
                }
                const complex_row step = product(inverse, defect_at(model, x, monomials));
                double largest = -1e300;
                for (std::size_t l = 0; l < local_->size(); ++l) {
                    x[l] = middle_of(x[l] - step[l]);
                    if (!is_finite(x[l].re) || !is_finite(x[l].im)) {
                        throw precision_exhausted("the coefficients at a singularity");
                    }
                    largest = std::max(
                        largest, log_of(above(middle_of(step[l]))) - log_of(std::max(above(x[l]), magnitude(1U))));
                }
                const double enough = stage == 0 ? -90.0 : -static_cast<double>(all_bits) * 0.9;
                if (largest < enough || (stage == 1 && k > 2 && largest > last - 2)) {
                    break;
                }
                last = largest;
            }
        }
        return x;
    }

    movable_point proved(const weighted_monomials& monomials, complex_row x) {
        const std::vector<magnitude> radii = radii_of_parameters(x);
        complex_row wide = x;
        for (std::size_t l = 0; l < local_->size(); ++l) {
            wide[l] = widened_by(x[l], radii[l]);
        }
        movable_point result;
        series_tail tail;
        std::vector<movable_variable> variables;
        const local_model over = local_->model_at(wide, monomials);
        local_->field().check_shares(over.scales, origin_, wide[0]);
        {
            const precision_scope few(20);
            double reach = longest_movable_reach;
            std::optional<series_tail> bounds;
            for (int k = 0; k < most_reaches && !bounds; ++k, reach *= shorter_reach) {
                variables = polydisc_for(*local_, over, wide, reach, monomials);
                std::vector<magnitude> sizes;
                for (const movable_variable& each : variables) {
                    sizes.emplace_back(each.radius);
                }
                bounds = tail_of(local_->balance(), over.field, monomials, over.series, sizes);
                if (bounds &&
                    !std::ranges::all_of(bounds->beyond, [](const magnitude& s) { return s <= magnitude(1U); })) {
                    bounds.reset();
                }
                result.reach = reach;
            }
            if (!bounds) {
                throw precision_exhausted("the reach of an expansion at a singularity");
            }
            tail = *bounds;
        }
        result.logarithms = degrees_of_logarithms(variables, monomials);
        result.variables = variables;
        result.least_weight = monomials.least_beyond();
        const complex_row box = krawczyk(monomials, x, radii, tail, variables, over, wide, result.reach);
        finish(monomials, box, tail, result);
        return result;
    }

    // Of the bounds over the parameters within radii: derivatives by Cauchy's estimates, those of second order on half of the radii.
    complex_row krawczyk(const weighted_monomials& monomials, const complex_row& x, const std::vector<magnitude>& radii,
                         const series_tail& tail, const std::vector<movable_variable>& variables,
                         const local_model& over, const complex_row& wide, double reach) {
        const local_model model = local_->model_at(x, monomials);
        const local_solution::base_values bounds = local_->values_at_base(over, wide, monomials);
        ball kappa(0);
        std::vector<magnitude> rests, sizes;
        {
            const precision_scope few(30);
            for (std::size_t v = 0; v < variables.size(); ++v) {
                const ball part = above(bounds.theta[v]).exact() / variables[v].radius;
                kappa = contains_zero(part) ? kappa : upper_bound(hull(kappa, pow(part, ball(1 / variables[v].rate))));
            }
            ball end;
            arb_set_d(end.handle(), reach);
            const magnitude from_place = above(complex_ball(1) - exact_point(base_) / wide[0]);
            if (!certainly_less(kappa, ball(1)) || !certainly_less(from_place.exact(), end)) {
                throw precision_exhausted("the base of an expansion at a singularity");
            }
            const ball least = power_of_kappa(kappa, monomials.least_beyond());
            const complex_row limits = local_->field().limits(local_->finite_of(wide));
            for (std::size_t i = 0; i < local_->size(); ++i) {
                const magnitude front = above(bounds.front[i]);
                rests.push_back(front * tail.beyond[i] * magnitude(least));
                const magnitude limit = above(limits[i]) + magnitude(1U);
                sizes.push_back(front * (limit + tail.norms[i] + tail.beyond[i]));
            }
        }
        std::vector<magnitude> steps = radii;
        for (magnitude& each : steps) {
            each = each.shifted(-ball::working_bits() / 2);
        }
        const complex_matrix slopes = local_->slopes_at(model, x, steps, monomials);
        const complex_matrix inverse = inverse_near(slopes);
        complex_row defect = defect_at(model, x, monomials);
        for (std::size_t i = 0; i < local_->size(); ++i) {
            defect[i] = widened_by(defect[i], rests[i]);
        }
        const complex_row step = product(inverse, defect);
        std::vector<magnitude> half;
        for (std::size_t l = 0; l < local_->size(); ++l) {
            half.push_back((above(step[l]) + magnitude::of(1, -ball::working_bits())).shifted(1));
        }
        for (int attempt = 0; attempt < 3; ++attempt) {
            for (std::size_t l = 0; l < local_->size(); ++l) {
                if (!(half[l].shifted(2) < radii[l])) {
                    throw precision_exhausted("the coefficients at a singularity");
                }
            }
            complex_matrix around = slopes;
            for (std::size_t i = 0; i < local_->size(); ++i) {
                for (std::size_t l = 0; l < local_->size(); ++l) {
                    magnitude sum = rests[i].shifted(2) / radii[l];
                    for (std::size_t k = 0; k < local_->size(); ++k) {
                        const magnitude way = half[k] + (k == l ? steps[l] : magnitude());
                        sum += sizes[i].shifted(4) / radii[k] / radii[l] * way;
                    }
                    around[i][l] = widened_by(around[i][l], sum);
                }
            }
            bool inside = true;
            complex_row next;
            for (std::size_t l = 0; l < local_->size(); ++l) {
                magnitude sum = above(step[l]);
                for (std::size_t j = 0; j < local_->size(); ++j) {
                    complex_ball entry(l == j ? -1 : 0);
                    for (std::size_t i = 0; i < local_->size(); ++i) {
                        entry = entry + inverse[l][i] * around[i][j];
                    }
                    sum += above(entry) * half[j].shifted(1);  // |z| <= sqrt 2 max(|Re z|, |Im z|)
                }
                inside = inside && sum < half[l];
                next.push_back(widened_by(x[l], sum));
                half[l] = inside ? half[l] : std::max(half[l], magnitude(sum.shifted(1)));
            }
            if (inside) {
                return next;
            }
        }
        throw precision_exhausted("the coefficients at a singularity");
    }

    static ball power_of_kappa(const ball& kappa, double exponent) {
        ball e;
        arb_set_d(e.handle(), exponent);
        return contains_zero(kappa) ? ball(0) : upper_bound(pow(kappa, e));
    }

    void finish(const weighted_monomials& monomials, const complex_row& box, const series_tail& tail,
                movable_point& result) {
        const local_model model = local_->model_at(box, monomials);
        result.place = box[0];
        // The ray from there to the base of the path is in the disc of the expansion.
        result.base = near_ * (1 - std::min(longest_distance_of_base, part_of_reach_of_base * result.reach));
        result.real = real_;
        result.order = local_->balance().orders[shown_];
        result.rest = above(model.scales[shown_]) * tail.beyond[shown_];
        if (real_) {
            result.place.im = ball(0);
        }
        result.terms = terms_of(*local_, model, box, monomials, shown_);
        result.without_logarithms = model.series.resonant.empty();
        result.single_valued = result.without_logarithms && denominator(result.order) == 1;
        for (std::size_t v = 0; v < monomials.variables(); ++v) {
            result.single_valued = result.single_valued && monomials.weight_of(v).is_integer();
        }
    }

    const explicit_system& system_;
    const chart_atlas& atlas_;
    std::size_t shown_;
    std::complex<double> near_, base_;
    bool real_;
    complex_ball origin_;
    std::unique_ptr<local_solution> local_;
    std::vector<std::complex<double>> free_guess_, finite_guess_;
    std::vector<complex_ball> state_;
};

}  // namespace

movable_point movable_point_near(const explicit_system& system, const chart_atlas& atlas, std::size_t shown,
                                 const complex_ball& near) {
    return movable_search(system, atlas, shown, near).found();
}

}  // namespace libration::ode
