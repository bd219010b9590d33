// The approximants computed from the series of an unknown about the initial point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/approximant/conformal_map.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/exponential_approximant.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/scalar/integer_power.hpp"
#include "solution_on_interval.hpp"

namespace libration {

/// The approximation computed from a list of coefficients.
enum class list_approximation {
    series,
    pade,
    endpoint,
    euler,  ///< partial sum in y/(y + S), y = x^stride, S = scale^stride
    gauge   ///< partial sum in 1 - e^(-x/scale)
};

inline std::string name_of(list_approximation method) {
    switch (method) {
        case list_approximation::series: return "series";
        case list_approximation::pade: return "pade";
        case list_approximation::endpoint: return "endpoint";
        case list_approximation::euler: return "euler";
        case list_approximation::gauge: break;
    }
    return "gauge";
}

/// Whether a method needs a length of x, for which the distance of the nearest singularity is a good one.
inline bool has_scale(list_approximation method) {
    return method == list_approximation::euler || method == list_approximation::gauge;
}

/// Those of a list of coefficients in powers of x, starting at `first`, of which only every `stride`-th is nonzero.
template <scalar T>
class approximants_of_list {
public:
    using function = std::function<T(const T&)>;

    /// `end` contains the value and the slope at x = 1; empty if they are not known.
    approximants_of_list(series::power_series<T> list, int first, int stride, std::vector<T> end)
        : list_(std::move(list)), first_(first), stride_(stride), end_(std::move(end)) {}

    /// std::nullopt if there is no such approximant of this order: no endpoint approximant without an end; no Pade
    /// approximant if, in arithmetic that rounds, none of smaller degrees exists either. In balls a returned
    /// approximant exists, but std::nullopt does not imply that there is none. `scale` > 0 for a method that has one, of
    /// functions of x >= 0.
    std::optional<function> of(list_approximation method, int order,
                               const std::optional<T>& scale = std::nullopt) const {
        switch (method) {
            case list_approximation::series:
                return [sum = list_.truncated(order)](const T& x) { return evaluate_value(sum, x); };
            case list_approximation::pade: return pade_of(order);
            case list_approximation::endpoint: break;
            case list_approximation::euler: return euler_of(order, scale.value());
            case list_approximation::gauge: return gauge_of(order, scale.value());
        }
        if (end_.empty()) {
            return std::nullopt;
        }
        return [approximant = endpoint_approximant<T>(list_.truncated(order), end_)](const T& x) {
            return approximant.value(x);
        };
    }

    const series::power_series<T>& list() const { return list_; }

private:
    // b_k = a_(first + stride k), up to the power `order` of x; empty if there is none.
    std::vector<T> nonzero_part(int order) const {
        std::vector<T> part;
        for (int n = first_; n <= order; n += stride_) {
            part.push_back(list_[n]);
        }
        return part;
    }

    std::optional<function> euler_of(int order, const T& scale) const {
        std::vector<T> part = nonzero_part(order);
        if (part.empty()) {
            return std::nullopt;
        }
        const T S = integer_power(scale, stride_);
        return [sum = in_euler_variable(series::power_series<T>(std::move(part)), S), S, stride = stride_,
                first = first_](const T& x) {
            return T(integer_power(x, first) * evaluate_value(sum, euler_variable(integer_power(x, stride), S)));
        };
    }

    std::optional<function> gauge_of(int order, const T& scale) const {
        const T rate = T(T(1) / scale);
        return [sum = series_in_decay(list_.truncated(order), rate), rate](const T& x) {
            using std::exp;
            return evaluate_value(sum, T(1 - exp(T(-rate * x))));
        };
    }

    // [m/m] of the list without the terms that vanish by symmetry, in powers of x^stride, m half of its last power; of
    // smaller degrees if that does not exist.
    std::optional<function> pade_of(int order) const {
        std::vector<T> part = nonzero_part(order);
        if (part.empty()) {
            return std::nullopt;
        }
        const series::power_series<T> list(std::move(part));
        const int full = list.order() / 2;
        for (int m = full; m >= (proved_scalar<T> ? full : 0); --m) {
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

    series::power_series<T> list_;
    int first_;
    int stride_;
    std::vector<T> end_;
};

/// The first coefficient of an unknown that may be nonzero.
inline int first_of_unknown(const ode::tape& of, int unknown) { return std::max(0, of.residue_of(unknown)); }

/// Those of one unknown, as functions of x = ((t - t0)/reach)^(1/root), reach the distance of the farthest time. No
/// endpoint approximant if times are on both sides of the initial point.
template <rounding_scalar T>
class approximants_of_unknown {
public:
    using function = typename approximants_of_list<T>::function;

    approximants_of_unknown(const series_about_start<T>& of, const solution_on_interval& truth, int unknown)
        : start_(truth.start),
          one_sided_(truth.one_sided),
          root_(of.tape.root()),
          unit_(root_of(truth.one_sided || root_ == 1 ? truth.reach() : mpfr(abs(truth.reach())), root_)),
          all_(rescale(of.expansion.series_of(unknown), unit_), first_of_unknown(of.tape, unknown), of.tape.stride(),
               end_of(truth, unknown, root_)) {}

    /// x of a time. Throws error for one before the initial point of a series in powers of a root.
    T coordinate(const mpfr& t) const { return T(root_of(mpfr(t - start_), root_) / unit_); }

    /// `scale`: of the variable of the problem, for a method that has one; the radius of convergence by the verdict on
    /// the coefficients up to `order` unless given. std::nullopt also where that finds none, or with times on both sides.
    std::optional<function> of(list_approximation method, int order,
                               const std::optional<mpfr>& scale = std::nullopt) const {
        using std::abs;
        if (!has_scale(method)) {
            return all_.of(method, order);
        }
        if (!one_sided_) {
            return std::nullopt;
        }
        std::optional<T> in_x;
        if (scale) {
            in_x = T(root_of(*scale, root_) / abs(unit_));
        } else if (const auto verdict = convergence::verdict_in(all_.list().truncated(order)); verdict.radius) {
            in_x = narrow<T>(*verdict.radius);
        }
        return in_x ? all_.of(method, order, in_x) : std::nullopt;
    }

private:
    // The real root; for a negative number only odd roots exist.
    static T root_of(const mpfr& x, int root) {
        if (root > 1 && x < 0) {
            throw error(error_kind::argument, error_subject::time, "",
                        "is before the initial point, where the solution is not real");
        }
        return narrow<T>(root == 1 ? x : mpfr(pow(x, mpfr(mpfr(1) / root))));
    }

    static std::vector<T> end_of(const solution_on_interval& truth, int unknown, int root) {
        const auto i = static_cast<std::size_t>(unknown);
        return truth.one_sided ? std::vector<T>{narrow<T>(truth.values[i][truth.far]),
                                                narrow<T>(mpfr(truth.slopes[i] * truth.reach() * root))}
                               : std::vector<T>{};
    }

    mpfr start_;
    bool one_sided_;
    int root_;
    T unit_;
    approximants_of_list<T> all_;
};

}  // namespace libration
