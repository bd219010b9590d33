#include "linear_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "../plane/place_words.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"
#include "local_matching.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_places = 40;
// Of the distance to the next singular point: the reach of a series, the longest step, the longest slit by default and at all.
constexpr double part_of_distance = 0.85;
constexpr double part_of_step = 0.42;
constexpr double usual_slit = 0.6;
constexpr double longest_slit = 0.8;
constexpr double farthest_usual_circle = 3;
constexpr double least_gap_of_moduli = 1.02;
constexpr double least_angle_between = 1e-6;
constexpr int most_steps_of_walk = 2'000;
constexpr long guard_bits_of_walk = 16;

[[noreturn]] void refuse_linear(const std::string& why) {
    throw error(error_kind::undecided, error_subject::problem, "", why);
}

std::string words_of(const complex_ball& z) {
    const std::complex<double> at = rounded_midpoint(z);
    return at.imag() == 0 ? std::to_string(at.real()) : words_of_place(at);
}

double below_in_double(const ball& x) { return arf_get_d(arb_midref(lower_bound(x).handle()), ARF_RND_DOWN); }

// A number of few bits between.
double few_bits_below(double x, double least) {
    for (int bits = 4; bits < 50; ++bits) {
        const double unit = std::exp2(std::floor(std::log2(x)) - bits);
        const double rounded = std::floor(x / unit) * unit;
        if (rounded > least + (x - least) / 2) {
            return rounded;
        }
    }
    return x;
}

}  // namespace

linear_law::linear_law(linear_equation of, explicit_system system, const std::optional<double>& within,
                       plane_watch watch)
    : equation_(std::move(of)), system_(std::move(system)), watch_(std::move(watch)) {
    const precision_scope scope(digits_of_places);
    find_places();
    choose_circle(within);
    check_inside();
}

void linear_law::find_places() {
    for (const auto& [factor, multiplicity] : irreducible_factors(equation_.leading())) {
        if (factor[0] == 0) {
            origin_.emplace(equation_, factor);
            multiplicity_of_origin_ = multiplicity;
            continue;
        }
        structures_.emplace_back(equation_, factor);
        multiplicities_.push_back(multiplicity);
        for (const complex_ball& root : enclosed_roots(factor)) {
            const std::complex<double> z = rounded_midpoint(root);
            places_.push_back({structures_.size() - 1, root, std::abs(z), std::arg(z)});
        }
    }
    std::ranges::stable_sort(places_, {}, &place::modulus);
    if (origin_ && !origin_->is_regular()) {
        refuse_linear("has an irregular singular initial point, about which no law is proved");
    }
}

// The least end of a slit of usual length, of the places up to an index.
double linear_law::farthest_circle(std::size_t inside) const {
    double end = std::numeric_limits<double>::infinity();
    const std::vector<complex_ball> all = roots();
    for (std::size_t k = 0; k < inside; ++k) {
        if (!structures_[places_[k].factor].has_single_values()) {
            end = std::min(end, places_[k].modulus + usual_slit * distance_from(all[k], others_than(k, all)));
        }
    }
    return end;
}

void linear_law::choose_circle(const std::optional<double>& within) {
    if (within) {
        rho_ = *within;
        return;
    }
    if (places_.empty()) {
        refuse_linear(
            "has an entire solution, without singularities; --within RHO proves a bound C RHO^-n of its coefficients");
    }
    const double farthest = farthest_usual_circle * places_.front().modulus;
    for (std::size_t inside = 1; inside <= places_.size(); ++inside) {
        const place& last = places_[inside - 1];
        if (last.modulus * least_gap_of_moduli > farthest || !structures_[last.factor].is_regular()) {
            break;
        }
        const double next = inside < places_.size() ? places_[inside].modulus : farthest * farthest / last.modulus;
        const double between = std::sqrt(last.modulus * next);
        const double end = std::min({between, farthest_circle(inside), farthest});
        if (next > last.modulus * least_gap_of_moduli && end > last.modulus * std::sqrt(least_gap_of_moduli)) {
            rho_ = few_bits_below(end, last.modulus);
        }
    }
    if (rho_ == 0 && structures_[places_.front().factor].is_regular()) {
        refuse_linear("has singular points near t - t0 = " + words_of(places_.front().near) +
                      " that are too close together for a circle between; write RHO as --within");
    }
    if (rho_ == 0) {
        rho_ = places_.front().modulus * 2;  // check_inside() throws
    }
}

void linear_law::check_inside() {
    const ball rho = exactly(rho_);
    const std::vector<complex_ball> all = roots();
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const ball modulus = modulus_in_balls(all[k]);
        if (certainly_less(rho, modulus)) {
            continue;
        }
        if (!certainly_less(modulus, rho)) {
            refuse_linear("has a singular point at t - t0 = " + words_of(all[k]) +
                          " that is not decided to be inside |t - t0| = " + std::to_string(rho_) +
                          "; take another RHO as --within");
        }
        const fuchsian_point& structure = structures_[places_[k].factor];
        if (!structure.is_regular()) {
            refuse_linear("has an irregular singular point at t - t0 = " + words_of(all[k]) +
                          ", about which no law is proved; --within RHO below " + std::to_string(places_[k].modulus) +
                          " proves a bound C RHO^-n of its coefficients");
        }
        const double distance = distance_from(all[k], others_than(k, all));
        if (!structure.has_single_values() && rho_ - places_[k].modulus > longest_slit * distance) {
            refuse_linear("has a singular point at t - t0 = " + words_of(all[k]) +
                          " whose expansion reaches to another one at a distance of " + std::to_string(distance) +
                          "; take a RHO below " + std::to_string(places_[k].modulus + longest_slit * distance) +
                          " as --within");
        }
        if (places_[k].angle >= 0 && !structure.is_apparent()) {
            inside_.push_back(k);
        }
    }
}

std::vector<complex_ball> linear_law::roots() const {
    std::vector<std::vector<complex_ball>> by_factor;
    for (const fuchsian_point& each : structures_) {
        by_factor.push_back(enclosed_roots(each.field().modulus()));
    }
    std::vector<complex_ball> result;
    for (const place& each : places_) {
        const auto found = std::ranges::find_if(by_factor[each.factor], [&](const complex_ball& root) {
            return overlaps(root.re, each.near.re) && overlaps(root.im, each.near.im);
        });
        if (found == by_factor[each.factor].end()) {
            throw precision_exhausted("a singular point");
        }
        result.push_back(*found);
    }
    return result;
}

// With their multiplicities, and t0.
std::vector<complex_ball> linear_law::others_than(std::size_t k, const std::vector<complex_ball>& all) const {
    std::vector<complex_ball> result;
    for (std::size_t j = 0; j < all.size(); ++j) {
        for (int m = 0; j != k && m < multiplicities_[places_[j].factor]; ++m) {
            result.push_back(all[j]);
        }
    }
    result.resize(result.size() + static_cast<std::size_t>(multiplicity_of_origin_), complex_ball(0));
    return result;
}

double linear_law::distance_from(const complex_ball& z, const std::vector<complex_ball>& all) {
    double least = std::numeric_limits<double>::infinity();
    for (const complex_ball& each : all) {
        least = std::min(least, below_in_double(modulus_in_balls(each - z)));
    }
    return least;
}

frobenius_series linear_law::series_about_start(series_demand demand, const std::vector<complex_ball>& zeros) const {
    if (watch_) {
        watch_(plane_step::disc);
    }
    ++discs_;
    if (!origin_) {
        const std::vector<ball> known = equation_.start();
        return series_about(equation_, complex_ball(0), {known.begin(), known.end()}, zeros, demand);
    }
    std::vector<complex_ball> others = zeros;
    others.resize(zeros.size() - static_cast<std::size_t>(multiplicity_of_origin_));
    local_operator about = operator_at(*origin_, complex_ball(0), others);
    // Beyond the last exponent that is a whole number the coefficients follow from those before.
    long last = static_cast<long>(equation_.order());
    for (const exponent_class& each : origin_->classes()) {
        last = std::max(last, static_cast<long>(std::ceil(static_cast<double>(each.exponent))) + each.last());
    }
    const auto more = scope_for_series(about, demand);
    about = operator_at(*origin_, complex_ball(0), others);
    const tape made = tape::about_start(system_);
    taylor_expansion<ball> expansion(made, static_cast<int>(last));
    expansion.about_start();
    std::vector<std::vector<complex_ball>> first;
    for (long n = 0; n <= last; ++n) {
        first.push_back({complex_ball(expansion.coefficients(0)[n])});
    }
    return {about, complex_ball(0), std::move(first), demand};
}

// Straight from t0 to b.
linear_law::state linear_law::walked_from_start(const complex_ball& b, const std::vector<complex_ball>& zeros) const {
    const std::complex<double> end = rounded_midpoint(b);
    const double distance =
        places_.empty() ? std::numeric_limits<double>::infinity() : distance_from(complex_ball(0), roots());
    const bool arrives = std::abs(end) <= part_of_step * distance;
    const complex_ball next = arrives ? b : exact_point(end * (part_of_step * distance / std::abs(end)));
    const double length = std::abs(rounded_midpoint(next));
    const double reach = places_.empty() ? 2 * length : part_of_distance * distance;
    const frobenius_series series =
        series_about_start({reach, length, static_cast<long>(ball::working_bits()) + guard_bits_of_walk, 0}, zeros);
    const state at = series.derivatives(next, equation_.order());
    return arrives ? at : walked(at, next, b, zeros);
}

// By the series about a, which is exact; b is inside its reach.
linear_law::state linear_law::moved(const state& from, const complex_ball& a, const complex_ball& b,
                                    const std::vector<complex_ball>& all) const {
    if (watch_) {
        watch_(plane_step::disc);
    }
    ++discs_;
    const double length = std::abs(rounded_midpoint(b - a));
    const double reach = all.empty() ? 2 * length : part_of_distance * distance_from(a, all);
    const frobenius_series series = series_about(
        equation_, a, from, all, {reach, length, static_cast<long>(ball::working_bits()) + guard_bits_of_walk, 0});
    return series.derivatives(b - a, from.size());
}

// Straight from a to b.
linear_law::state linear_law::walked(const state& from, const complex_ball& a, const complex_ball& b,
                                     const std::vector<complex_ball>& all) const {
    state now = from;
    complex_ball at = a;
    for (int k = 0; k < most_steps_of_walk; ++k) {
        const std::complex<double> rest = rounded_midpoint(b - at);
        const double longest = part_of_step * distance_from(at, all);
        if (rest == 0.0) {
            return now;
        }
        if (std::abs(rest) <= longest) {
            return moved(now, at, b, all);
        }
        const complex_ball next = exact_point(rounded_midpoint(at) + rest * (longest / std::abs(rest)));
        now = moved(now, at, next, all);
        at = next;
    }
    throw precision_exhausted("a path between singular points");
}

std::vector<fixed_point_terms> linear_law::terms(int least) const {
    std::vector<fixed_point_terms> result;
    for (const std::size_t k : inside_) {
        result.push_back(terms_at(k, least));
    }
    return result;
}

fixed_point_terms linear_law::terms_at(std::size_t k, int least) const {
    const fuchsian_point& structure = structures_[places_[k].factor];
    std::vector<complex_ball> all = roots();
    local_operator about = operator_at(structure, all[k], others_than(k, all));
    const double distance = about.nearest();
    const double length = rho_ / places_[k].modulus - 1;
    const double base = std::min(1.0, few_bits_below(distance / 2, 0));
    const double reach = std::isfinite(distance) ? part_of_distance * distance : 1.5 * std::max(1.0, length);
    // At least up to non-negative powers.
    double lowest = 0;
    for (const complex_ball& each : about.exponents) {
        lowest = std::min(lowest, rounded_midpoint(each).real());
    }
    const series_demand demand{reach, base, static_cast<long>(ball::working_bits()) + guard_bits_of_walk,
                               static_cast<long>(least - lowest) + static_cast<long>(about.exponents.size()) + 4};
    const auto more = scope_for_series(about, demand);
    all = roots();
    about = operator_at(structure, all[k], others_than(k, all));
    state at_base;
    if (base == 1) {
        for (const ball& each : equation_.start()) {
            at_base.emplace_back(each);
        }
    } else {
        // Around a pole before it on the ray.
        const complex_ball end = all[k] * exactly(1 - base);
        double aside = 1;
        bool meets = false;
        for (std::size_t j = 0; j < places_.size(); ++j) {
            const double apart = std::abs(std::remainder(places_[j].angle - places_[k].angle, 2 * std::numbers::pi));
            if (j != k && apart < least_angle_between) {
                meets = meets || places_[j].modulus < places_[k].modulus;
            } else if (j != k) {
                aside = std::min(aside, apart / 2);
            }
        }
        if (meets) {
            const complex_ball from =
                exact_point(std::polar(places_[k].modulus * (1 - base), places_[k].angle + aside));
            at_base = walked(walked_from_start(from, zeros()), from, end, zeros());
        } else {
            at_base = walked_from_start(end, zeros());
        }
    }
    const complex_ball scale{-all[k].re, -all[k].im};
    complex_ball power(1);
    for (complex_ball& each : at_base) {  // derivatives by x
        each = each * power;
        power = power * scale;
    }
    const bool real = is_exact(all[k].im) && contains_zero(all[k].im);
    return {all[k], real, matched_parts(structure, about, at_base, demand, real), rho_};
}

}  // namespace libration::ode
