#include "libration/ode/singularity/singularity_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "libration/ode/singularity/resonances.hpp"
#include "singularity_search.hpp"

namespace libration::ode {

namespace {

using wide_complex = complex_number<mpfr>;

constexpr long place_guard_digits = 25;
constexpr long most_walk_steps = 5'000;
// Towards a singularity a step goes so far, and its series has the terms that a bit takes there.
constexpr double approach_part = 0.6;
constexpr double approach_terms_for_a_bit = 1.36;
// On the way, which only has to be followed.
constexpr double way_part = 0.3;
constexpr double way_terms_for_a_bit = 0.58;
constexpr int least_walk_order = 40;
constexpr double spare_bits = 40;
// So near, relative to the modulus, exponents and leading coefficients are read.
constexpr double near_part = 1e-9;
// A whole number within so much is taken for the exponent, where slow powers follow,
constexpr double whole_exponent_slack = 1e-3;
// and a fraction p/q with a small q is taken for the exponent within so much.
constexpr double exponent_slack = 1e-5;
constexpr int largest_denominator = 12;
// Of a value, what its leading term may leave.
constexpr double leading_part = 0.01;

// Searches without a bound look so much further out, step by step.
constexpr double search_growth = 1.4;
constexpr double farthest_search = 64;

wide_complex wide_number(const plane_point& z) { return {mpfr(z.real()), mpfr(z.imag())}; }

plane_point rounded_point(const wide_complex& z) { return {static_cast<double>(z.re), static_cast<double>(z.im)}; }

double rounded_size(const wide_complex& z) { return static_cast<double>(mpfr(modulus_of(z))); }

std::complex<double> tidied_exponent(const std::complex<double>& exponent) {
    for (int q = 1; q <= largest_denominator; ++q) {
        const double p = std::round(exponent.real() * q);
        if (std::abs(exponent - std::complex<double>(p / q, 0)) < (q == 1 ? whole_exponent_slack : exponent_slack)) {
            return {p == 0 ? 0 : p / q, 0};
        }
    }
    return exponent;
}

// The walk to one singularity in many digits.
class refined_place {
public:
    refined_place(const path_system& of, const candidate& from, long digits)
        : of_(of), from_(from), digits_(digits), bits_(static_cast<double>(digits + place_guard_digits) * 3.33) {}

    found_singularity result() {
        const precision_scope scope(static_cast<int>(digits_ + place_guard_digits));
        walk();
        approach();
        found_singularity found;
        found.path = from_.path;
        found.single_valued = from_.single_valued;
        found.offset = at_;
        found.uncertainty = uncertainty_;
        read_exponents(found);
        return found;
    }

private:
    int order_for(double bits, double terms) const {
        return std::max(least_walk_order, static_cast<int>(bits * terms));
    }

    void move(local_series<mpfr>& series, const wide_complex& to) {
        const auto values = series.values_at(to);
        series.about(to, values);
    }

    // Along the corners that the search took.
    void walk() {
        local_series<mpfr> series(of_, order_for(bits_, way_terms_for_a_bit));
        series.about_start();
        long steps = 0;
        for (const plane_point& each : from_.path) {
            const wide_complex target = wide_number(each);
            for (bool arrived = false; !arrived;) {
                const wide_complex way = target - series.offset();
                const double length = rounded_size(way);
                const double radius = std::exp2(series.log_of_radius(steps == 0 ? 6 : 1));
                arrived = length <= way_part * radius;
                require_step(++steps, radius);
                move(series, arrived ? target : series.offset() + way * mpfr(way_part * radius / length));
            }
        }
        now_ = series.offset();
        values_ = series.values_at(now_);
    }

    static void require_step(long steps, double radius) {
        if (steps > most_walk_steps || !(radius > 0)) {
            throw error(error_kind::undecided, "problem", "",
                        "is not followed to a singularity: the steps become too small");
        }
    }

    // By 0.6 of the way again and again; the place is right to the distance times what the ratios disagree.
    void approach() {
        at_ = wide_number(from_.at);
        const double modulus = std::abs(from_.at);
        double bits = bits_;  // those that what is left of the approach needs
        mpfr tolerance = pow(mpfr(10), -static_cast<int>(digits_)) * modulus / 4;
        const double sought = static_cast<double>(tolerance);
        bool exact_enough = false;
        for (long steps = 0;; ++steps) {
            local_series<mpfr> series(of_, order_for(bits, approach_terms_for_a_bit));
            series.about(now_, values_);
            const auto estimate = series.nearest();
            if (!estimate || steps > most_walk_steps) {
                throw error(error_kind::undecided, "problem", "", "shows no singularity where one was seen");
            }
            const double away = rounded_size(estimate->distance);
            const mpfr uncertainty = mpfr(away) * mpfr(estimate->agreement);
            if (!exact_enough) {
                at_ = now_ + estimate->distance;
                uncertainty_ = uncertainty;
                exact_enough = uncertainty_ < tolerance;
            }
            distance_ = estimate->distance;
            if (exact_enough && away < near_part * modulus) {
                last_.emplace(std::move(series));
                return;
            }
            now_ = now_ + distance_ * mpfr(approach_part);
            values_ = series.values_at(now_);
            const double least = exact_enough ? near_part * modulus : std::min(near_part * modulus, sought);
            bits = std::min(bits_, std::log2(away / least) + spare_bits);
        }
    }

    void read_exponents(found_singularity& found) const {
        const std::size_t given = last_->given();
        const wide_complex tau = -distance_;
        for (std::size_t i = 0; i < given; ++i) {
            const wide_complex* const a = last_->coefficients(i);
            const int n = last_->order();
            const bool ends = (a[n].re == 0 && a[n].im == 0) || (a[n / 2].re == 0 && a[n / 2].im == 0);
            found.exponents.push_back(ends ? std::complex<double>(0)
                                           : tidied_exponent(rounded_point(last_->exponent(i, distance_))));
        }
        find_most_singular(found);
        found.kind = kind_of(found);
        found.coefficient = leading_coefficient(found, found.unknown);
        std::vector<wide_complex> values;
        for (std::size_t i = 0; i < last_->carried(); ++i) {
            values.push_back(last_->coefficients(i)[0]);
        }
        std::vector<std::complex<double>> balance;
        for (std::size_t i = 0; i < given; ++i) {
            balance.push_back(balance_exponent(found, i));
        }
        found.resonances =
            resonances_at(of_, wide_complex(constant_value<mpfr>::of(of_.origin)) + now_, values, tau, balance);
    }

    void find_most_singular(found_singularity& found) const {
        std::size_t most = of_.functions.front();
        for (const std::size_t i : of_.functions) {
            if (found.exponents[i].real() < found.exponents[most].real() - exponent_slack) {
                most = i;
            }
        }
        found.unknown = most;
        found.exponent = found.exponents[most];
    }

    // From a_n of (s - d)^p = (-d)^p (1 - s/d)^p, d the distance; (1 - (t - t0)/(t* - t0))^p = (d/d0)^p (1 - s/d)^p. Of
    // a logarithm y ~ c log, a_n ~ -c/(n d^n).
    std::complex<double> leading_coefficient(const found_singularity& found, std::size_t unknown) const {
        const std::complex<double>& p = found.exponents[unknown];
        const int n = last_->order();
        wide_complex term = last_->coefficients(unknown)[n];
        const bool whole = p.imag() == 0 && std::abs(p.real() - std::round(p.real())) < exponent_slack;
        for (int k = 0; k < n; ++k) {
            term = term * distance_;
        }
        if (whole && p.real() >= 0) {
            return rounded_point(term * mpfr(-n));
        }
        // binomial(p, n) (-1)^n
        const wide_complex exponent{mpfr(p.real()), mpfr(p.imag())};
        for (int k = 0; k < n; ++k) {
            term = term * mpfr(k + 1) / (wide_complex(mpfr(k)) - exponent);
        }
        const wide_complex base = whole ? -distance_ : distance_ / at_;
        return rounded_point(term / exp(log(base) * exponent));
    }

    // The exponent of the leading term: 0 where a constant stands before a power that is singular.
    std::complex<double> balance_exponent(const found_singularity& found, std::size_t unknown) const {
        const std::complex<double>& p = found.exponents[unknown];
        if (!(p.real() > 0)) {
            return p;
        }
        const std::complex<double> c = leading_coefficient(found, unknown);
        const std::complex<double> power = std::pow(rounded_point(distance_ / at_), p);
        const std::complex<double> value = rounded_point(last_->coefficients(unknown)[0]);
        return std::abs(value - c * power) < leading_part * std::abs(value) ? p : std::complex<double>(0);
    }

    static singularity_kind kind_of(const found_singularity& found) {
        if (found.exponent.imag() != 0) {
            return singularity_kind::complex_power;
        }
        const double p = found.exponent.real();
        if (std::abs(p - std::round(p)) > exponent_slack) {
            return singularity_kind::algebraic;
        }
        if (p >= 0) {
            return singularity_kind::logarithm;
        }
        return found.single_valued ? singularity_kind::pole : singularity_kind::branch_pole;
    }

    const path_system& of_;
    const candidate& from_;
    long digits_;
    double bits_;
    wide_complex now_, at_, distance_;
    std::vector<wide_complex> values_;
    mpfr uncertainty_;
    std::optional<local_series<mpfr>> last_;
};

// The mirror images of a singularity under the symmetry, itself first.
std::vector<found_singularity> images_of(const found_singularity& one, int rotation) {
    std::vector<found_singularity> all;
    const precision_scope scope(static_cast<int>(mpfr_get_prec(handle(one.offset.re)) * 30103L / 100'000L) + 2);
    const mpfr size = modulus_of(one.offset);
    const auto known = [&](const wide_complex& z) {
        return std::ranges::any_of(
            all, [&](const found_singularity& each) { return mpfr(modulus_of(each.offset - z)) < size / 1'000'000; });
    };
    for (int turn = 0; turn < rotation; ++turn) {
        for (const bool mirrored : {false, true}) {
            found_singularity image = one;
            const mpfr angle = pi<mpfr>() * (2 * turn) / rotation;
            wide_complex z = mirrored ? wide_complex{one.offset.re, mpfr(-one.offset.im)} : one.offset;
            if (turn != 0) {
                z = z * wide_complex{mpfr(cos(angle)), mpfr(sin(angle))};
            }
            if (abs(z.im) < one.uncertainty) {
                z.im = mpfr(0);
            }
            if (abs(z.re) < one.uncertainty) {
                z.re = mpfr(0);
            }
            if (known(z)) {
                continue;
            }
            image.offset = z;
            const plane_point way = std::polar(1.0, 2 * std::numbers::pi * turn / rotation);
            for (plane_point& each : image.path) {
                each = (mirrored ? std::conj(each) : each) * way;
            }
            all.push_back(std::move(image));
        }
    }
    return all;
}

// Every point of the square, from a search that takes no symmetry but the reflection.
void draw_portrait(singularity_map& map, const path_system& paths, const singularity_request& request, double within) {
    if (request.portrait < 2) {
        return;
    }
    singularity_search search(paths, 1, request.most_points);
    search.search(std::numbers::sqrt2 * within);
    const int across = request.portrait;
    for (int row = 0; row < across; ++row) {
        for (int i = 0; i < across; ++i) {
            const plane_point z{within * (2.0 * i / (across - 1) - 1), within * (2.0 * row / (across - 1) - 1)};
            const auto value = search.value_at(z);
            map.portrait.push_back({z, value.value_or(0), value.has_value()});
        }
    }
}

double nearest_modulus(const std::vector<candidate>& found) {
    double least = std::numeric_limits<double>::infinity();
    for (const candidate& each : found) {
        least = std::min(least, std::abs(each.at));
    }
    return least;
}

}  // namespace

std::string words_of(singularity_kind kind, double exponent) {
    switch (kind) {
        case singularity_kind::pole: return "pole of order " + std::to_string(std::lround(-exponent));
        case singularity_kind::branch_pole:
            return "pole of order " + std::to_string(std::lround(-exponent)) + " with branches";
        case singularity_kind::algebraic: return "algebraic";
        case singularity_kind::logarithm: return "logarithm";
        default: return "complex power";
    }
}

singularity_map singularities_of(const explicit_system& system, const singularity_request& request) {
    singularity_map map;
    if (has_entire_solutions(system)) {
        map.entire = true;
        return map;
    }
    const path_system paths(system);
    const int rotation = std::max(1, tape::about_start(system).stride());
    singularity_search search(paths, rotation, request.most_points);
    if (request.within) {
        map.within = *request.within;
        search.search(map.within);
    } else {
        const double first = search.first_radius();
        const double bound = std::isfinite(first) && first > 0 ? first : 1;
        for (double within = bound; within < farthest_search * bound && search.points() < request.most_points;
             within *= search_growth) {
            map.within = within;
            search.search(within);
            if (nearest_modulus(search.found()) <= within) {
                map.within = (request.nearest_alone ? 1.001 : 2) * nearest_modulus(search.found());
                search.search(map.within);
                break;
            }
        }
    }
    draw_portrait(map, paths, request, map.within);
    map.points = search.points();
    map.unexplained = search.unexplained();
    map.complete = map.unexplained == 0;
    for (const candidate& each : search.found()) {
        if (std::abs(each.at) > map.within) {
            continue;
        }
        const auto one = refined_place(paths, each, request.digits).result();
        for (found_singularity& image : images_of(one, rotation)) {
            map.all.push_back(std::move(image));
        }
    }
    std::ranges::stable_sort(map.all, [](const found_singularity& a, const found_singularity& b) {
        const double of_a = rounded_size(a.offset);
        const double of_b = rounded_size(b.offset);
        return std::abs(of_a - of_b) > 1e-9 * of_a
                   ? of_a < of_b
                   : std::arg(rounded_point(a.offset)) < std::arg(rounded_point(b.offset));
    });
    return map;
}

}  // namespace libration::ode
