// Coefficients of consecutive steps of a tape with the addresses of their arrays, for hardware scalars.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace libration::ode {

/// How coefficient n of a step follows from lower ones and from those of its operands a and b.
enum class coefficient_rule : std::uint8_t {
    linear,       ///< a_n factor + b_n other
    product,      ///< sum_{k=0}^{n} a_k b_{n-k}
    square,       ///< the same with b = a, each product once
    quotient,     ///< (a_n - sum_{k=1}^{n} b_k r_{n-k})/b_0 for the result r
    square_root,  ///< (a_n - sum_{k=1}^{n-1} r_k r_{n-k})/(2 r_0), where 2 r_0 is behind the result
    fraction,     ///< a_n factor/other
    constant,     ///< the factor, then 0
    raised,       ///< a_n, plus the factor for n = 0
    slope,        ///< r_{n-1} = n a_n
    primitive,    ///< sum_{k=0}^{n-1} b_k d_{n-1-k}/n for the derivative d
    power,        ///< of a, whose slope is b, with the factor as the exponent; its own slope is behind the result
    sine_cosine,  ///< of a, whose slope is b; the cosine is behind the sine
    otherwise     ///< by a call with the index of the step and n
};

/// Which operand of a step is the result of the one before. Its coefficient n is still in a register, while a processor
/// takes longer to load what it has just stored than to add or multiply.
enum class newest_operand : std::uint8_t { none, a, b };

/// A step; unused members are null or 0.
template <class R>
struct placed_step {
    coefficient_rule rule;
    newest_operand newest;
    int index;  ///< on the tape
    R* result;
    const R* a;
    const R* b;
    R factor;
    R other;
    R* integral;          ///< whose coefficient n + 1 is coefficient n of the result, divided by n + 1; or null
    R* behind;            ///< array of the next step
    const R* derivative;  ///< for a primitive
};

/// An integral that is not one of those of steps.
template <class R>
struct placed_integral {
    R* result;
    const R* a;
};

/// Coefficients n = first .. last of all steps, those of one n in the order of the steps, then n + 1 of the integrals.
/// Rules with the value of a function are for n > 0. The inner terms of a sum are in four independent partial sums; its
/// first and last term, which may contain the newest coefficients, are added at the end, so that these need not wait for
/// the others. In single numbers, because a vector of coefficients would have to wait until the newest of them are in
/// the cache.
template <std::floating_point R>
void run_steps(std::span<const placed_step<R>> steps, std::span<const placed_integral<R>> integrals, int first,
               int last, const std::function<void(int, int)>& otherwise);

/// The values of polynomials of the same degree at t by Horner's rule, four at once because each waits for itself.
template <std::floating_point R>
class polynomial_values {
public:
    polynomial_values(int degree, R t) : degree_(degree), t_(t) {}
    /// Sets the value at the latest at the end.
    void add(const R* polynomial, R& value) {
        polynomials_[count_] = polynomial;
        values_[count_] = &value;
        if (++count_ == polynomials_.size()) {
            end();
        }
    }
    void end();

private:
    int degree_;
    R t_;
    std::size_t count_ = 0;
    std::array<const R*, 4> polynomials_{};
    std::array<R*, 4> values_{};
};

extern template void run_steps<double>(std::span<const placed_step<double>>, std::span<const placed_integral<double>>,
                                       int, int, const std::function<void(int, int)>&);
extern template void run_steps<long double>(std::span<const placed_step<long double>>,
                                            std::span<const placed_integral<long double>>, int, int,
                                            const std::function<void(int, int)>&);
extern template class polynomial_values<double>;
extern template class polynomial_values<long double>;

}  // namespace libration::ode
