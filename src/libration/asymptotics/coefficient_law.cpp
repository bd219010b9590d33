#include "libration/asymptotics/coefficient_law.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "../plane/place_words.hpp"
#include "closed_equation.hpp"
#include "law_tips.hpp"
#include "libration/asymptotics/circle_mean.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/dependency.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "linear_law.hpp"

namespace libration::ode {

namespace {

constexpr int terms_beyond_last = 24;
constexpr long digits_of_first_constants = 40;
// Their expansions take long, and these digits are enough for usual requests.
constexpr long digits_of_movable_constants = 80;
constexpr int most_law_attempts = 3;
constexpr long bits_of_first_covering = 128;
constexpr double size_of_change = 1.6;
constexpr double least_gap_of_candidates = 1.001;
constexpr long digits_of_law_bounds = 30;

[[noreturn]] void refuse_without_chart(const found_singularity& found) {
    const std::complex<double> place(static_cast<double>(found.offset.re), static_cast<double>(found.offset.im));
    refuse_law(
        "has a singularity near " + words_of_place(place) +
        " that is neither a pole by the form of its equation nor a branch point with a chart; --within RHO below " +
        std::to_string(std::abs(place)) + " proves a bound C RHO^-n of its coefficients");
}

// Whether a place is outside the circle, decided by balls.
bool is_outside(const complex_ball& place, double rho) {
    const ball modulus = modulus_in_balls(place);
    if (certainly_less(exactly(rho), modulus)) {
        return true;
    }
    if (!certainly_less(modulus, exactly(rho))) {
        refuse_law("has a singularity near " + words_of_place(rounded_midpoint(place)) +
                   " that is not decided to be inside |t - t0| = " + std::to_string(rho) +
                   "; take another RHO as --within");
    }
    return false;
}

// Where no RHO is given and the usual one fails: a circle close behind the nearest singularity.
std::optional<law_request> smaller_circle(const explicit_system& system, const law_request& asked,
                                          const error& missing) {
    if (asked.within || missing.kind() != error_kind::undecided || has_entire_solutions(system)) {
        return std::nullopt;
    }
    try {
        const double nearest = circle_for(system, 0, std::nullopt, asked.watch).nearest;
        law_request smaller = asked;
        smaller.within = few_bits_between(1.02 * nearest, 1.1 * nearest);
        return nearest > 0 ? std::optional(std::move(smaller)) : std::nullopt;
    } catch (const error& none) {
        if (none.kind() != error_kind::undecided) {
            throw;
        }
        return std::nullopt;
    }
}

}  // namespace

coefficient_law coefficient_law::of(const explicit_system& system, const law_request& asked) {
    if (system.singular() && !linear_equation::of(system)) {
        refuse_law(
            "has a singular initial point, about which a law is only proved of one linear equation with rational "
            "functions as coefficients");
    }
    closed_equation equation = system.singular() ? closed_equation{system, asked.derivative, 0}
                                                 : closed_equation_of(system, asked.unknown, asked.derivative);
    coefficient_law law(std::move(equation.system));
    law.shift_ = equation.shift;
    law.shown_ = equation.shown;
    const tape start = tape::about_start(system);
    law.stride_ = start.stride();
    law.residue_ = start.residue_of(static_cast<int>(asked.unknown)) - asked.derivative;
    const auto linear = linear_equation::of(law.system_);
    const auto attempt = [&](const law_request& how) {
        with_half_more_bits(bits_of_first_covering, most_law_attempts, [&](long bits) -> std::optional<bool> {
            const precision_scope scope(decimal_digits(bits));
            try {
                linear ? law.cover_linear(*linear, how) : law.cover(how);
                return true;
            } catch (const precision_exhausted&) {
                return std::nullopt;
            }
        });
        if (law.rho_ == 0) {
            refuse_law("has no law that is proved with the precisions that are tried");
        }
    };
    try {
        attempt(asked);
    } catch (const error& missing) {
        const auto smaller = linear ? std::nullopt : smaller_circle(law.system_, asked, missing);
        if (!smaller) {
            throw;
        }
        try {
            attempt(*smaller);
        } catch (const error& again) {
            throw error(again.kind() == error_kind::undecided ? missing : again);
        }
    }
    return law;
}

void coefficient_law::cover_linear(const linear_equation& equation, const law_request& asked) {
    rho_ = 0;
    last_term_ = asked.terms;
    const auto found = std::make_shared<linear_law>(equation, system_, asked.within, asked.watch);
    found->bound_circle();
    linear_ = found;
    mean_ = linear_->mean();
    sharpen();
    discs_ = linear_->discs();
    rho_ = linear_->rho();
}

void coefficient_law::cover(const law_request& asked) {
    rho_ = 0;
    branch_points_.clear();
    const bool entire = has_entire_solutions(system_);
    law_circle circle;
    if (entire && asked.within) {
        circle.rho = *asked.within;
    } else if (entire) {
        refuse_law(
            "has an entire solution, without singularities; --within RHO proves a bound C RHO^-n of its coefficients");
    } else {
        circle = circle_for(system_, 0, asked.within, asked.watch);
    }
    atlas_ = std::make_shared<const chart_atlas>(
        system_, circle.size > 0 ? size_of_change * circle.size : size_of_change, shown_);
    charts_ = atlas_->has_poles() ? 2 : 1;
    uniformizing_.reset();
    std::vector<algebraic_point> tips;
    std::vector<movable_point> movable;
    if (!atlas_->has_poles() && !circle.inside.empty()) {
        uniformizing_ = uniformizing_chart::of(system_);
        last_term_ = asked.terms;
        charts_ = 2;
        if (!uniformizing_) {
            charts_ = 1;
            const precision_scope more(digits_of_movable_constants);
            movable = movable_points_in(system_, *atlas_, shown_, circle, asked.within.has_value(), asked.watch);
        }
        for (const found_singularity& each : uniformizing_ ? circle.inside : std::vector<found_singularity>{}) {
            const std::complex<double> near(static_cast<double>(each.offset.re), static_cast<double>(each.offset.im));
            const precision_scope more(digits_of_first_constants + asked.terms);
            try {
                tips.push_back(algebraic_point_near(system_, *atlas_, *uniformizing_, exact_point(near), asked.terms));
            } catch (const precision_exhausted&) {
                // What the search finds behind others need not be a singularity: RHO before it, which the covering proves.
                const double before = tips.empty() ? std::abs(near) : std::abs(rounded_midpoint(tips.back().place));
                if (asked.within || !(std::abs(near) > before * least_gap_of_candidates)) {
                    refuse_without_chart(each);
                }
                circle.rho = few_bits_between(before, std::abs(near));
                break;
            }
        }
        circle.rho = circle_of_slits(tips, circle.rho, asked.within.has_value());
        std::erase_if(tips, [&](const algebraic_point& each) {
            return certainly_less(exactly(circle.rho), modulus_in_balls(each.place));
        });
    }
    covering_request request{.rho = circle.rho, .bits = static_cast<long>(ball::working_bits())};
    request.watch = asked.watch;
    for (const algebraic_point& each : tips) {
        request.tips.push_back(tip_of(each));
    }
    for (const movable_point& each : movable) {
        request.tips.push_back(tip_of(each));
    }
    const charted_covering covering(system_, *atlas_, request);
    discs_ = covering.pieces().size();
    boxes_ = enclosed_poles(*atlas_, covering, circle.rho);
    std::erase_if(boxes_, [&](const pole_box& each) { return is_outside(each.place, circle.rho); });
    mean_ = circle_mean(covering, circle.rho, tips.empty() ? bounds_of_tips(movable) : bounds_of_tips(tips));
    near_.clear();
    movable_points_.clear();
    for (movable_point& each : movable) {
        movable_points_.emplace_back(std::move(each), circle.rho);
    }
    bits_of_movable_ = movable_points_.empty() ? 0 : bits_of_digits(digits_of_movable_constants);
    for (const algebraic_point& each : tips) {
        near_.push_back(each.place);
    }
    rho_ = circle.rho;
    const precision_scope more(digits_of_first_constants);
    sharpen();
}

// If all powers of f are even or all are odd, f(-conj t) = s conj f(t), s = 1 or -1: with a pole p in a box -conj p is a pole.
// If it is in the box, it is p, whose real part is 0 and for whose c_j conj c_j = s (-1)^j c_j.
void coefficient_law::set_exact_parts(const pole_box& box, pole_terms& of) const {
    if (stride_ % 2 != 0 || !box.contains({-of.place.re, of.place.im})) {
        return;
    }
    of.place.re = ball(0);
    const bool odd = (residue_ + shift_) % 2 != 0;
    for (std::size_t j = 1; j <= of.principal.size(); ++j) {
        complex_ball& c = of.principal[j - 1];
        ((j % 2 != 0) == odd ? c.im : c.re) = ball(0);
    }
}

void coefficient_law::sharpen() {
    if (linear_) {
        fixed_points_ = linear_->terms(last_term_ + terms_beyond_last);
    }
    std::vector<pole_terms> poles;
    for (const pole_box& each : boxes_) {
        poles.push_back(terms_of_pole(system_, *atlas_, each));
        set_exact_parts(each, poles.back());
    }
    std::vector<branch_terms> branch_points;
    for (std::size_t k = 0; k < near_.size(); ++k) {
        algebraic_point found = algebraic_point_near(system_, *atlas_, *uniformizing_, near_[k], last_term_);
        if (!overlaps(near_[k].re, found.place.re) || !overlaps(near_[k].im, found.place.im)) {
            throw precision_exhausted("a branch point");
        }
        branch_points.emplace_back(std::move(found), rho_);
    }
    sharpen_movable();
    poles_ = std::move(poles);
    branch_points_ = std::move(branch_points);
}

void coefficient_law::sharpen_movable() {
    const auto bits = static_cast<long>(ball::working_bits());
    if (bits <= bits_of_movable_) {
        return;
    }
    std::vector<movable_terms> points;
    for (const movable_terms& each : movable_points_) {
        movable_point found = movable_point_near(system_, *atlas_, shown_, each.of().place);
        if (!overlaps(each.of().place.re, found.place.re) || !overlaps(each.of().place.im, found.place.im)) {
            throw precision_exhausted("a singularity");
        }
        points.emplace_back(std::move(found), rho_);
    }
    movable_points_ = std::move(points);
    bits_of_movable_ = bits;
}

namespace {

// The indices J that are tried.
std::vector<int> tried_terms(int last) {
    std::vector<int> all{0, 1, 3, 5, 9, 15, 21, 29, 39, 49, 59, 79, 99};
    std::erase_if(all, [&](int each) { return each >= last; });
    all.push_back(last);
    return all;
}

// m!/n! for m = n + shift.
ball factorial_quotient(long n, int shift) {
    ball result(1);
    for (int k = 1; k <= shift; ++k) {
        result *= n + k;
    }
    for (int k = 0; k > shift; --k) {
        result /= n + k;
    }
    return result;
}

}  // namespace

ball coefficient_law::circle_bound(long n) const {
    const precision_scope few(digits_of_law_bounds);
    return mean_.exact() * pow(exactly(rho_), -n);
}

ball coefficient_law::bound_of_function(long n, int terms) const {
    ball sum = circle_bound(n);
    const precision_scope few(digits_of_law_bounds);
    for (const branch_terms& each : branch_points_) {
        sum += each.bound(n, terms);
    }
    for (const fixed_point_terms& each : fixed_points_) {
        sum += each.bound(n, terms);
    }
    for (const movable_terms& each : movable_points_) {
        sum += each.bound(n, terms);
    }
    return upper_bound(sum);
}

int coefficient_law::best_terms(long n) const {
    if (branch_points_.empty() && fixed_points_.empty() && movable_points_.empty()) {
        return 0;
    }
    std::optional<ball> least;
    int best = 0;
    for (const int each : tried_terms(last_term_)) {
        if (first_of_function(each) > n) {
            continue;
        }
        ball bound = bound_of_function(n, each);
        if (!least || certainly_less(bound, *least)) {
            least = std::move(bound);
            best = each;
        }
    }
    return best;
}

long coefficient_law::first_of_function(int terms) const {
    long least = 0;
    for (const branch_terms& each : branch_points_) {
        least = std::max(least, each.first(terms));
    }
    for (const fixed_point_terms& each : fixed_points_) {
        least = std::max(least, each.first(terms));
    }
    for (const movable_terms& each : movable_points_) {
        least = std::max(least, each.first(terms));
    }
    return least;
}

long coefficient_law::first(int terms) const {
    return std::max(first_of_function(terms) - shift_, shift_ < 0 ? static_cast<long>(-shift_) : 0L);
}

ball coefficient_law::error_bound(long n) const {
    const precision_scope few(digits_of_law_bounds);
    const long m = n + shift_;
    return upper_bound(ball(bound_of_function(m, best_terms(m)) * factorial_quotient(n, shift_)));
}

ball coefficient_law::value(long n) const {
    if (n < first()) {
        throw error(error_kind::argument, "order", std::to_string(n),
                    "is below " + std::to_string(first()) + ", the first of the law");
    }
    if (vanishes(n)) {
        return ball(0);
    }
    const long m = n + shift_;
    const int terms = best_terms(m);
    ball sum(0);
    for (const pole_terms& each : poles_) {
        sum += pole_coefficient(each, m);
    }
    for (const branch_terms& each : branch_points_) {
        sum += each.coefficient(m, terms);
    }
    for (const fixed_point_terms& each : fixed_points_) {
        sum += each.coefficient(m, terms);
    }
    for (const movable_terms& each : movable_points_) {
        sum += each.coefficient(m, terms);
    }
    return widened(sum, magnitude(bound_of_function(m, terms))) * factorial_quotient(n, shift_);
}

}  // namespace libration::ode
