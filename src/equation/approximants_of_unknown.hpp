// The approximants that the series of an unknown about the start makes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "equation/solution_on_interval.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/scalar/integer_power.hpp"

namespace libration {

/// What a list of coefficients is made into.
enum class list_approximation { series, pade, endpoint };

inline std::string name_of(list_approximation method) {
    return method == list_approximation::series ? "series" : method == list_approximation::pade ? "pade" : "endpoint";
}

/// Those of one unknown, as functions of x = ((t - t0)/reach)^(1/root), reach the distance of the farthest time.
template <rounding_scalar T>
class approximants_of_unknown {
public:
    using function = std::function<T(const T&)>;

    approximants_of_unknown(const series_about_start<T>& of, const solution_on_interval& truth, int unknown)
        : start_(truth.start),
          root_(of.tape.root()),
          stride_(of.tape.stride()),
          first_(std::max(0, of.tape.residue_of(unknown))),
          scaled_(of.expansion.series_of(unknown)) {
        unit_ = root_of(truth.one_sided || root_ == 1 ? truth.reach() : mpfr(abs(truth.reach())), root_);
        T power(1);
        for (int n = 0; n <= scaled_.order(); ++n, power *= unit_) {
            scaled_[n] *= power;
        }
        if (truth.one_sided) {
            const auto i = static_cast<std::size_t>(unknown);
            end_ = {narrow<T>(truth.values[i][truth.far]), narrow<T>(mpfr(truth.slopes[i] * truth.reach() * root_))};
        }
    }

    /// x of a time. Throws error for one before the start of a series in powers of a root.
    T coordinate(const mpfr& t) const { return T(root_of(mpfr(t - start_), root_) / unit_); }

    /// Nothing where there is no such approximant of this order: a Pade approximant of no smaller degrees either, an
    /// endpoint approximant where times lie on both sides of the start.
    std::optional<function> of(list_approximation method, int order) const {
        if (method == list_approximation::series) {
            return [sum = cut(order)](const T& x) { return evaluate_value(sum, x); };
        }
        if (method == list_approximation::pade) {
            return pade_of(order);
        }
        if (end_.empty()) {
            return std::nullopt;
        }
        return [approximant = endpoint_approximant<T>(cut(order), end_)](const T& x) { return approximant.value(x); };
    }

private:
    // The real root; of a negative number there is an odd one alone.
    static T root_of(const mpfr& x, int root) {
        if (root > 1 && x < 0) {
            throw error(error_kind::argument, "time", "", "is before the start, where the solution is not real");
        }
        return narrow<T>(root == 1 ? x : mpfr(pow(x, mpfr(mpfr(1) / root))));
    }

    series::power_series<T> cut(int order) const {
        const auto& all = scaled_.coefficients();
        return series::power_series<T>({all.begin(), all.begin() + std::ptrdiff_t{order} + 1});
    }

    // [m/m] of the list without what symmetry leaves out, in powers of x^stride, m the half of its last power; of
    // smaller degrees where that does not exist.
    std::optional<function> pade_of(int order) const {
        std::vector<T> part;
        for (int n = first_; n <= order; n += stride_) {
            part.push_back(scaled_[n]);
        }
        if (part.empty()) {
            return std::nullopt;
        }
        const series::power_series<T> list(std::move(part));
        for (int m = list.order() / 2; m >= 0; --m) {
            if (auto found = pade(list, m, m)) {
                return [of = *std::move(found), stride = stride_, first = first_](const T& x) {
                    const T z = integer_power(x, stride);
                    const T quotient = evaluate_value(of.numerator, z) / evaluate_value(of.denominator, z);
                    return T(integer_power(x, first) * quotient);
                };
            }
        }
        return std::nullopt;
    }

    mpfr start_;
    int root_;
    int stride_;
    int first_;
    series::power_series<T> scaled_;
    T unit_ = T(1);
    std::vector<T> end_;
};

}  // namespace libration
