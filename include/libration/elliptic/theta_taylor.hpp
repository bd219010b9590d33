// The Taylor coefficients of Jacobi's theta functions about a point of the real or of the imaginary axis.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/error.hpp"

namespace libration::elliptic {

/// One of the four, as Theta(x) = sum of s_m q^((m^2 - odd)/4) e^(mx) over the integers m of one parity, s_m =
/// (-1)^floor(m/2) if it alternates, else 1. At x = iz these are theta_3 and theta_4 of z, theta_2/q^(1/4) and i
/// theta_1/q^(1/4) [DLMF 20.2.1-4].
struct theta_kind {
    bool odd;
    bool alternates;

    bool is_first() const { return odd && alternates; }
    /// s_m.
    int sign(long m) const {
        const long below = m < 0 && odd ? m / 2 - 1 : m / 2;
        return alternates && below % 2 != 0 ? -1 : 1;
    }
};

inline constexpr theta_kind first_theta{true, true};
inline constexpr theta_kind second_theta{true, false};
inline constexpr theta_kind third_theta{false, false};
inline constexpr theta_kind fourth_theta{false, true};

/// The argument as a function of the variable t of the series: x = at + step t, or x = i (at + step t); at and step are
/// nonnegative. The function is Theta(x) e^(-shift x); a shift of 1, for real x, removes the growth of e^x.
template <scalar T>
struct theta_argument {
    T nome;
    T at;
    T step;
    bool real;
    int shift = 0;
};

/// The Taylor coefficients in t; at imaginary x, those of Theta/i for the first. The terms of the frequencies f = m -
/// shift and -f are combined: with u_f = s_m q^((m^2 - odd)/4) e^(f at), or e^(i f at),
///     c_j = (step^j/j!) sum_{f >= 0} f^j (u_f + (-1)^j u_{-f}), or i^j before f^j,
/// which takes one product by the integer +-f^2 per pair from j to j + 2.
///
/// The pairs from f on are omitted if 4 q^P(f) e^(f H) is below 2^-digits, H = at + step, or step alone at imaginary x,
/// and P(f) the smaller power of q in the pair. In every c_j a pair is at most 2 q^P(f) e^(f H), since (f step)^j/j! <=
/// e^(f step); and all of them together are less than twice the first if q^(P(f+2) - P(f)) e^(2 H) < 1/2, because
/// P(f+2) - P(f) grows with f.
///
/// About sqrt(digits log 4/log(1/nome)) pairs, or as few as requested, which makes balls correspondingly wider; never
/// fewer than the last condition requires. Errors of a few epsilon of the largest sum of the |terms| for |t| <= 1. Not
/// for the fixed scalars. Throws error unless the nome is below 1.
template <scalar T>
class theta_taylor {
    static_assert(!fixed_scalar<T>, "powers of the frequencies leave the range of the built-in types");

public:
    theta_taylor(const theta_kind& kind, const theta_argument<T>& argument,
                 long most_pairs = std::numeric_limits<long>::max())
        : kind_(kind), argument_(argument), least_(kind.odd != (argument.shift != 0) ? 1 : 0) {
        const long end = first_left_out(most_pairs);
        const std::vector<T> weights = weights_to(end + 1);
        const auto weight = [&](long m) {
            return T(weights[static_cast<std::size_t>(std::abs(m) / 2)] * kind_.sign(m));
        };
        if (argument.real) {
            add_real(end, weight);
        } else {
            add_imaginary(end, weight);
        }
    }

    /// Those of t^n, n = first, first + stride, ..; first and stride - 1 are 0 or 1. O(pairs) per coefficient.
    std::vector<T> coefficients(int first, int stride, int count) const {
        std::vector<pair> pairs = pairs_;
        std::vector<T> all;
        all.reserve(static_cast<std::size_t>(count));
        T factor = first == 0 ? T(1) : argument_.step;
        for (int n = first; static_cast<int>(all.size()) < count; n += stride) {
            T sum(0);
            for (pair& each : pairs) {
                T& part = n % 2 == 0 ? each.even : each.odd;
                sum += part;
                part *= each.square;
            }
            all.push_back(enclose(T(sum * factor), rest_));
            for (int next = n + 1; next <= n + stride; ++next) {
                factor *= argument_.step;
                factor /= next;
            }
        }
        return all;
    }

private:
    struct pair {
        long square;  // f^2, at imaginary x -f^2
        T even;       // for the even derivatives
        T odd;        // for the odd ones, times f
    };

    static T exponential(const T& x) {
        using std::exp;
        return exp(x);
    }

    // The first f whose pair is omitted together with all that follow, and the bound on those. In few digits, which on
    // balls are equally rigorous.
    long first_left_out(long most_pairs) {
        const long bits = digits<T>();
        const precision_scope rough(20);
        const T nome = narrow<T>(widen(argument_.nome));
        if (binary_exponent(nome) > 0) {
            throw error(error_kind::argument, "nome", "", "of a theta function is not below 1");
        }
        const T reach = exponential(argument_.real ? T(argument_.at + argument_.step) : argument_.step);
        const auto power = [&](long f) {
            const long m = std::abs(f - std::abs(argument_.shift));
            return (m * m - (kind_.odd ? 1 : 0)) / 4;
        };
        for (long f = least_ + 2;; f += 2) {
            rest_ = pow(nome, power(f)) * pow(reach, f) * 4;
            const T ratio = pow(nome, power(f + 2) - power(f)) * reach * reach;
            const bool enough = binary_exponent(rest_) < -bits || (f - least_) / 2 >= most_pairs;
            if (enough && binary_exponent(ratio) < 0) {
                return f;
            }
        }
    }

    // q^((m^2 - odd)/4) for the m from 0 or 1 up to the last.
    std::vector<T> weights_to(long last) const {
        std::vector<T> all{T(1)};
        const T square = argument_.nome * argument_.nome;
        T ratio = kind_.odd ? square : argument_.nome;
        for (long m = kind_.odd ? 1 : 0; m < last; m += 2) {
            all.push_back(all.back() * ratio);
            ratio *= square;
        }
        return all;
    }

    template <class Weight>
    void add_real(long end, const Weight& weight) {
        const T growth = exponential(argument_.at);
        const T square = growth * growth;
        T up = least_ == 0 ? T(1) : growth;
        for (long f = least_; f < end; f += 2) {
            const T rising = weight(f + argument_.shift) * up;
            const T falling = weight(argument_.shift - f) / up;
            pairs_.push_back({f * f, f == 0 ? rising : T(rising + falling), (rising - falling) * f});
            up *= square;
        }
    }

    template <class Weight>
    void add_imaginary(long end, const Weight& weight) {
        using std::cos;
        using std::sin;
        const complex_number<T> turn{cos(argument_.at), sin(argument_.at)};
        const complex_number<T> square = turn * turn;
        complex_number<T> e = least_ == 0 ? complex_number<T>{T(1), T(0)} : turn;
        for (long f = least_; f < end; f += 2) {
            const complex_number<T> term = e * (weight(f) * (f == 0 ? 1 : 2));
            if (kind_.is_first()) {
                pairs_.push_back({-f * f, term.im, term.re * f});
            } else {
                pairs_.push_back({-f * f, term.re, -(term.im * f)});
            }
            e = e * square;
        }
    }

    theta_kind kind_;
    theta_argument<T> argument_;
    long least_;
    std::vector<pair> pairs_;
    T rest_ = T(0);
};

}  // namespace libration::elliptic
