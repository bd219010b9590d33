#include "libration/approximant/differential.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "differential_roots.hpp"
#include "differential_system.hpp"

namespace libration {

namespace {

constexpr int fewest_unknowns = 5;
constexpr int most_unknowns = 110;
constexpr int confirming = 3;  // coefficients that an exact equation was not fitted to

// log10 |p/a_m - 1|, at least that of the precision; if a_m = 0, log10 |p/a_k| for the larger one of the two before.
std::optional<double> log_error(const mpfr& predicted, std::span<const mpfr> a, int m, long bits) {
    const auto size = [&](int n) { return n < 0 ? mpfr(0) : mpfr(abs(a[static_cast<std::size_t>(n)])); };
    const mpfr scale = size(m) != 0 ? size(m) : std::max(size(m - 1), size(m - 2));
    if (scale == 0) {
        return std::nullopt;
    }
    const mpfr error = abs(mpfr(predicted - a[static_cast<std::size_t>(m)])) / scale;
    const double least = -0.28 * static_cast<double>(bits);
    return error == 0 ? least : std::max(least, mpfr(log10(error)).convert_to<double>());
}

// Whether the coefficients after `length` satisfy the equation too, to four fifths of the precision.
bool satisfied_by_rest(const differential_relation& relation, std::span<const mpfr> a, int length, long bits) {
    for (int m = length + 1; m < static_cast<int>(a.size()); ++m) {
        const coefficient_of_equation at = coefficient_of(relation, a, m);
        if (at.value != 0 && binary_exponent(at.value) > binary_exponent(at.largest) - bits * 4 / 5) {
            return false;
        }
    }
    return true;
}

class fits_of_track {
public:
    fits_of_track(std::span<const mpfr> a, std::size_t index, const differential_track& track,
                  std::span<const int> lengths, root_annulus within, long bits)
        : a_(a),
          index_(index),
          lengths_(lengths),
          within_(within),
          bits_(bits),
          last_(static_cast<int>(a.size()) - 1),
          system_(a, track, std::min(last_, track.degree + most_unknowns)) {}

    std::vector<differential_fit> all() {
        while (system_.length() < system_.last()) {
            const bool regular = system_.add();
            const bool asked = std::ranges::binary_search(lengths_, system_.length());
            if (system_.length() == last_of_exact() && add_exact()) {
                break;
            }
            if (asked && system_.unknowns() >= fewest_unknowns && (regular || (without_roots() && predicts()))) {
                add_fit();
            }
        }
        return std::move(fits_);
    }

private:
    bool without_roots() const { return within_.inner >= within_.outer; }

    // A list that satisfies an equation so far makes its systems singular; any solution predicts the next coefficient.
    bool predicts() const { return system_.length() < last_ && system_.is_consistent(); }

    void add_fit() {
        const differential_relation relation = system_.relation();
        differential_fit fit{
            .track = index_, .length = system_.length(), .roots = roots_of_equation(relation, within_)};
        if (fit.length < last_) {
            fit.next_error = log_error(next_by(relation, a_, fit.length + 1), a_, fit.length + 1, bits_);
        }
        fits_.push_back(std::move(fit));
    }

    int last_of_exact() const { return std::min(last_ - confirming, system_.last()); }

    bool add_exact() {
        differential_relation relation = system_.relation();
        relation.exact = satisfied_by_rest(relation, a_, system_.length(), bits_);
        if (relation.exact) {
            const root_annulus wider{0.3 * within_.inner, 3 * within_.outer};
            fits_.push_back(
                {.track = index_, .length = last_, .exact = true, .roots = roots_of_equation(relation, wider)});
        }
        return relation.exact;
    }

    std::span<const mpfr> a_;
    std::size_t index_;
    std::span<const int> lengths_;
    root_annulus within_;
    long bits_;
    int last_;
    differential_system system_;
    std::vector<differential_fit> fits_;
};

}  // namespace

std::vector<differential_fit> differential_fits(std::span<const mpfr> a, std::span<const differential_track> tracks,
                                                std::span<const int> lengths, root_annulus within, long bits,
                                                const task_runner& run) {
    std::vector<std::vector<differential_fit>> by_track(tracks.size());
    run(tracks.size(), [&](std::size_t i) {
        if (static_cast<int>(a.size()) - 1 - tracks[i].degree >= fewest_unknowns) {
            const precision_scope scope(decimal_digits(bits));
            by_track[i] = fits_of_track(a, i, tracks[i], lengths, within, bits).all();
        }
    });
    std::vector<differential_fit> all;
    for (auto& fits : by_track) {
        std::ranges::move(fits, std::back_inserter(all));
    }
    return all;
}

std::optional<differential_relation> relation_of(std::span<const mpfr> a, const differential_track& track, int length,
                                                 long bits) {
    const int unknowns = length - track.degree;
    if (unknowns < fewest_unknowns || unknowns > most_unknowns) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(bits));
    differential_system system(a, track, length);
    while (system.length() < length) {
        system.add();
        if (system.length() == length - confirming) {
            differential_relation relation = system.relation();
            relation.exact =
                satisfied_by_rest(relation, a.first(static_cast<std::size_t>(length) + 1), system.length(), bits);
            if (relation.exact) {
                return relation;
            }
        }
    }
    return system.is_consistent() ? std::optional(system.relation()) : std::nullopt;
}

std::vector<mpfr> continued_by(const differential_relation& relation, std::span<const mpfr> a, int length, int count) {
    std::vector<mpfr> all(a.begin(), a.begin() + length + 1);
    all.reserve(all.size() + static_cast<std::size_t>(count));
    for (int i = 1; i <= count; ++i) {
        all.push_back(next_by(relation, all, length + i));
    }
    return all;
}

}  // namespace libration
