#include "refined_place.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "libration/plane/resonances.hpp"
#include "place_words.hpp"

namespace libration::ode {

namespace {

using wide_complex = complex_number<mpfr>;

constexpr long place_guard_digits = 25;
constexpr long most_walk_steps = 5'000;
// The length of a step towards a singularity relative to the distance, and the terms per bit of its series there.
constexpr double approach_part = 0.6;
constexpr double approach_terms_for_a_bit = 1.36;
// The same on the path, which only has to be followed.
constexpr double part_of_radius = 0.3;
constexpr double way_terms_for_a_bit = 0.58;
constexpr int least_walk_order = 40;
constexpr double spare_bits = 40;
// The distance, relative to the modulus, at which exponents and leading coefficients are determined.
constexpr double near_part = 1e-9;
// Tolerance for rounding an exponent to an integer, where slowly decaying powers follow,
constexpr double whole_exponent_slack = 1e-3;
// and for rounding it to a fraction p/q with a small q.
constexpr double exponent_slack = 1e-5;
constexpr int largest_denominator = 12;
// Tolerance for the agreement of two estimates of an exponent from one series,
constexpr double settled_exponent_slack = 0.05;
// and from a series about a point at a distance of earlier_part times the modulus: next to a power with exponent p
// there may be one with p + 1/3, which changes the estimate by less.
constexpr double earlier_part = 1e-6;
constexpr double kept_exponent_slack = 3e-3;
// The fraction of a value by which it may differ from its leading term.
constexpr double leading_part = 0.01;

wide_complex wide_number(const plane_point& z) { return {mpfr(z.real()), mpfr(z.imag())}; }

std::complex<double> tidied_exponent(const std::complex<double>& exponent) {
    for (int q = 1; q <= largest_denominator; ++q) {
        const double p = std::round(exponent.real() * q);
        if (std::abs(exponent - std::complex<double>(p / q, 0)) < (q == 1 ? whole_exponent_slack : exponent_slack)) {
            return {p == 0 ? 0 : p / q, 0};
        }
    }
    return exponent;
}

// The path to one singularity, in high precision.
class place_walk {
public:
    place_walk(const path_system& of, const candidate& from, const leaf_group& group, long digits)
        : of_(of),
          from_(from),
          group_(group),
          digits_(digits),
          bits_(static_cast<double>(digits + place_guard_digits) * 3.33) {}

    found_singularity result() {
        const precision_scope scope(static_cast<int>(digits_ + place_guard_digits));
        walk();
        approach();
        found_singularity found;
        found.path = from_.path;
        found.single_valued = from_.group_single_valued;
        found.offset = at_;
        found.uncertainty = uncertainty_;
        read_exponents(found);
        return found;
    }

private:
    static int order_for(double bits, double terms) {
        return std::max(least_walk_order, static_cast<int>(bits * terms));
    }

    static void move(local_series<mpfr>& series, const wide_complex& to) {
        const auto values = series.values_at(to);
        series.about(to, values);
    }

    // Along the corners of the path found by the search.
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
                arrived = length <= part_of_radius * radius;
                require_step(++steps, radius);
                move(series, arrived ? target : series.offset() + way * mpfr(part_of_radius * radius / length));
            }
        }
        now_ = series.offset();
        values_ = series.values_at(now_);
    }

    static void require_step(long steps, double radius) {
        if (steps > most_walk_steps || !(radius > 0)) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "cannot be followed to a singularity: the steps become too small");
        }
    }

    // In repeated steps of 0.6 of the distance; the error of the location is the distance times the disagreement of the
    // ratios.
    void approach() {
        at_ = wide_number(from_.at);
        const double modulus = std::abs(from_.at);
        double bits = bits_;  // the bits needed for the rest of the approach
        mpfr tolerance = pow(mpfr(10), -static_cast<int>(digits_)) * modulus / 4;
        const auto sought = static_cast<double>(tolerance);
        bool exact_enough = false;
        for (long steps = 0;; ++steps) {
            local_series<mpfr> series(of_, order_for(bits, approach_terms_for_a_bit));
            series.about(now_, values_);
            const auto estimate = series.nearest(group_);
            if (!estimate || steps > most_walk_steps) {
                throw error(error_kind::undecided, error_subject::problem, "",
                            "has a singularity near " + words_of_place(from_.at) +
                                " by the search, which the series about nearby points do not show");
            }
            const double away = rounded_size(estimate->distance);
            const mpfr uncertainty = mpfr(away) * mpfr(estimate->agreement);
            if (!exact_enough) {
                at_ = now_ + estimate->distance;
                uncertainty_ = uncertainty;
                exact_enough = uncertainty_ < tolerance;
            }
            distance_ = estimate->distance;
            if (earlier_.empty() && away < earlier_part * modulus) {
                note_earlier_exponents(series);
            }
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

    // The exponents from a series that is farther away by a factor of 1000: those of powers agree, those of logarithms
    // do not.
    void note_earlier_exponents(const local_series<mpfr>& series) {
        earlier_.assign(series.given(), 0);
        for (const std::size_t i : group_) {
            earlier_[i] = rounded_point(series.exponent(i, distance_, series.order()));
        }
    }

    void read_exponents(found_singularity& found) {
        found.exponents.assign(last_->given(), 0);
        std::vector<bool> settled(last_->given(), false);
        for (const std::size_t i : group_) {
            const auto exponent = settled_exponent(i);
            settled[i] = exponent.has_value();
            found.exponents[i] = exponent.value_or(0);
        }
        find_most_singular(found, settled);
        if (!is_power_) {  // the ratios agree on a power that does not exist: the last distance bounds the error
            found.kind = singularity_kind::unclear;
            found.offset = now_ + distance_;
            found.uncertainty = modulus_of(distance_);
            return;
        }
        found.kind = kind_of(found);
        found.coefficient = leading_coefficient(found, found.unknown);
        std::vector<wide_complex> values;
        for (std::size_t i = 0; i < last_->carried(); ++i) {
            values.push_back(last_->coefficients(i)[0]);
        }
        std::vector<std::complex<double>> balance;
        for (std::size_t i = 0; i < last_->given(); ++i) {
            balance.push_back(settled[i] ? balance_exponent(found, i) : std::complex<double>(0));
        }
        found.resonances =
            resonances_at(of_, wide_complex(constant_value<mpfr>::of(of_.origin)) + now_, values, -distance_, balance);
    }

    // From the last coefficients and from those up to three quarters of them; std::nullopt if they differ: then the
    // unknown is regular here, or its coefficients are rounding errors. 0 for a polynomial.
    std::optional<std::complex<double>> settled_exponent(std::size_t unknown) const {
        const wide_complex* const a = last_->coefficients(unknown);
        const int n = last_->order();
        if ((a[n].re == 0 && a[n].im == 0) || (a[n / 2].re == 0 && a[n / 2].im == 0)) {
            return std::complex<double>(0);
        }
        const std::complex<double> exponent = rounded_point(last_->exponent(unknown, distance_, n));
        const std::complex<double> before = rounded_point(last_->exponent(unknown, distance_, 3 * n / 4));
        if (!(std::abs(exponent - before) < settled_exponent_slack * std::max(1.0, std::abs(exponent)))) {
            return std::nullopt;
        }
        return tidied_exponent(exponent);
    }

    void find_most_singular(found_singularity& found, const std::vector<bool>& settled) {
        std::optional<std::size_t> most;
        for (const std::size_t i : of_.functions) {
            if (settled[i] && std::ranges::find(group_, i) != group_.end() &&
                (!most || found.exponents[i].real() < found.exponents[*most].real() - exponent_slack)) {
                most = i;
            }
        }
        if (!most) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a singularity whose exponents do not settle");
        }
        found.unknown = *most;
        found.exponent = found.exponents[*most];
        const double size = std::max(1.0, std::abs(found.exponent));
        is_power_ = std::abs(found.exponent - tidied_exponent(earlier_[*most])) < kept_exponent_slack * size;
    }

    // From a_n of (s - d)^p = (-d)^p (1 - s/d)^p, d the distance; (1 - (t - t0)/(t* - t0))^p = (d/d0)^p (1 - s/d)^p.
    // For a logarithm y ~ c log, a_n ~ -c/(n d^n).
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

    // The exponent of the leading term: 0 if a constant dominates the singular power.
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
    const leaf_group& group_;
    long digits_;
    double bits_;
    wide_complex now_, at_, distance_;
    std::vector<wide_complex> values_;
    mpfr uncertainty_;
    std::vector<std::complex<double>> earlier_;
    bool is_power_ = true;
    std::optional<local_series<mpfr>> last_;
};

}  // namespace

found_singularity refined_place(const path_system& of, const candidate& from, const leaf_group& group, long digits) {
    return place_walk(of, from, group, digits).result();
}

}  // namespace libration::ode
