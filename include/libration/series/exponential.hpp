// Exponential, logarithm, sine-cosine and real power of a series, one coefficient at a time: a differential equation is
// solved by feeding each new coefficient of the unknown and using what comes back for the next [paper (eCoeffs)].
//
// Each recurrence is the differential equation of its function: e' = f' e; f l' = f'; s' = c f', c' = -s f';
// f p' = r f' p. Cost O(n) for coefficient n, O(N^2) for a whole series of order N.
#pragma once

#include <utility>

#include "libration/series/arithmetic.hpp"

namespace libration {

/// e = exp f: e_0 = exp f_0, n e_n = sum_{k=1}^{n} k f_k e_{n-k}.
template <scalar T>
class exponential_recurrence {
public:
    /// Takes f_n and returns e_n, n = 0, 1, 2, ...
    const T& next(const T& f_n) {
        using std::exp;
        if (n_ == 0) {
            e_[0] = exp(f_n);
        } else {
            slope_[n_ - 1] = f_n * n_;
            e_.push_back(product_coefficient(slope_, e_, n_ - 1) / n_);
            slope_.push_back(T(0));
        }
        return e_[n_++];
    }
    const power_series<T>& value() const { return e_; }

private:
    int n_ = 0;
    power_series<T> slope_;  // f', one degree ahead
    power_series<T> e_;
};

/// s = sin f and c = cos f together: n s_n = sum_{k=1}^{n} k f_k c_{n-k}, n c_n = -sum_{k=1}^{n} k f_k s_{n-k}
/// [paper (cosseriesrec), (sinseriesrec), whose labels are exchanged there].
template <scalar T>
class sine_cosine_recurrence {
public:
    sine_cosine_recurrence() = default;
    /// With s_0 and c_0 given, for a start whose sine or cosine is known better than its angle; the parity of f is that
    /// of f - f_0 and saves half of the products.
    sine_cosine_recurrence(T sine_0, T cosine_0, parity of_f = parity::any)
        : started_(true), slope_parity_(of_f == parity::any ? parity::any : opposite(of_f)) {
        s_[0] = std::move(sine_0);
        c_[0] = std::move(cosine_0);
    }

    /// Takes f_n and computes s_n and c_n, n = 0, 1, 2, ...
    void next(const T& f_n) {
        using std::cos;
        using std::sin;
        if (n_ == 0 && !started_) {
            s_[0] = sin(f_n);
            c_[0] = cos(f_n);
        } else if (n_ > 0) {
            slope_[n_ - 1] = f_n * n_;
            T sine = product_coefficient(slope_, c_, n_ - 1, slope_parity_) / n_;
            T cosine = -product_coefficient(slope_, s_, n_ - 1, slope_parity_) / n_;
            s_.push_back(std::move(sine));
            c_.push_back(std::move(cosine));
            slope_.push_back(T(0));
        }
        ++n_;
    }
    const power_series<T>& sine() const { return s_; }
    const power_series<T>& cosine() const { return c_; }

private:
    static parity opposite(parity p) { return p == parity::even ? parity::odd : parity::even; }

    int n_ = 0;
    bool started_ = false;
    parity slope_parity_ = parity::any;
    power_series<T> slope_;  // f', one degree ahead
    power_series<T> s_;
    power_series<T> c_;
};

/// l = log f, f_0 > 0: l_0 = log f_0, n f_0 l_n = n f_n - sum_{k=1}^{n-1} k l_k f_{n-k}.
template <scalar T>
class logarithm_recurrence {
public:
    const T& next(const T& f_n) {
        using std::log;
        if (n_ == 0) {
            f_[0] = f_n;
            l_[0] = log(f_n);
        } else {
            f_.push_back(f_n);
            slope_[n_ - 1] = (f_n * n_ - convolution(slope_, f_, n_ - 1, 0, n_ - 2)) / f_[0];
            l_.push_back(slope_[n_ - 1] / n_);
            slope_.push_back(T(0));
        }
        return l_[n_++];
    }
    const power_series<T>& value() const { return l_; }

private:
    int n_ = 0;
    power_series<T> slope_;  // l', one degree ahead
    power_series<T> f_;
    power_series<T> l_;
};

/// p = f^r for a real r, f_0 > 0: p_0 = f_0^r, n f_0 p_n = sum_{k=1}^{n} (r k - (n - k)) f_k p_{n-k}.
template <scalar T>
class power_recurrence {
public:
    explicit power_recurrence(T exponent) : r_(std::move(exponent)) {}

    const T& next(const T& f_n) {
        using std::pow;
        if (n_ == 0) {
            f_[0] = f_n;
            slope_f_[0] = T(0);
            p_[0] = pow(f_n, r_);
        } else {
            f_.push_back(f_n);
            slope_f_.push_back(f_n * n_);
            slope_p_.push_back(T(0));
            const T rising = convolution(slope_f_, p_, n_, 1, n_) * r_;
            const T falling = convolution(f_, slope_p_, n_, 1, n_ - 1);
            p_.push_back((rising - falling) / (f_[0] * n_));
            slope_p_[n_] = p_[n_] * n_;
        }
        return p_[n_++];
    }
    const power_series<T>& value() const { return p_; }

private:
    int n_ = 0;
    T r_;
    power_series<T> f_;
    power_series<T> slope_f_;  // n f_n
    power_series<T> p_;
    power_series<T> slope_p_;  // n p_n
};

/// The whole series that a recurrence makes of f.
template <scalar T, class Recurrence>
power_series<T> run_recurrence(const power_series<T>& f, Recurrence recurrence) {
    for (int n = 0; n <= f.order(); ++n) {
        recurrence.next(f[n]);
    }
    return recurrence.value();
}

/// exp f.
template <scalar T>
power_series<T> exponential(const power_series<T>& f) {
    return run_recurrence(f, exponential_recurrence<T>());
}

/// log f, f_0 > 0.
template <scalar T>
power_series<T> logarithm(const power_series<T>& f) {
    return run_recurrence(f, logarithm_recurrence<T>());
}

/// f^r, f_0 > 0.
template <scalar T>
power_series<T> power(const power_series<T>& f, const T& r) {
    return run_recurrence(f, power_recurrence<T>(r));
}

/// (sin f, cos f).
template <scalar T>
std::pair<power_series<T>, power_series<T>> sine_cosine(const power_series<T>& f) {
    sine_cosine_recurrence<T> recurrence;
    for (int n = 0; n <= f.order(); ++n) {
        recurrence.next(f[n]);
    }
    return {recurrence.sine(), recurrence.cosine()};
}

}  // namespace libration
