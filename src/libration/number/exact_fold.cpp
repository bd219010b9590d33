#include "exact_fold.hpp"

#include <cstdlib>

#include "exact_real_atom.hpp"
#include "libration/function/list.hpp"

namespace libration {

namespace {

constexpr long most_bits = 1'000'000;
constexpr long largest_root = 64;

long bits_of(const rational& q) {
    const auto size = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
    return std::max(size(mpq_numref(q.backend().data())), size(mpq_denref(q.backend().data())));
}

[[noreturn]] void refuse_range() { refuse_number("is beyond the range 1e-100000 .. 1e100000"); }

}  // namespace

rational within_limits(rational q) {
    if (bits_of(q) > most_bits) {
        refuse_range();
    }
    return q;
}

std::optional<rational> folded_power(const rational& base, const rational& exponent) {
    const integer order = denominator(exponent);
    rational root = base;
    if (order != 1) {
        if (base < 0) {
            refuse_number("raises a negative number to a non-integer power");
        }
        const auto found =
            order > largest_root ? std::nullopt : function::exact_root(base, order.convert_to<unsigned long>());
        if (!found) {
            return std::nullopt;
        }
        root = *found;
    }
    if (root == 0 || root == 1) {
        return root;
    }
    const integer times = abs(numerator(exponent));
    if (times > most_bits || times * bits_of(root) > 2 * most_bits) {
        if (root == -1) {
            return rational(times % 2 == 0 ? 1 : -1);
        }
        refuse_range();
    }
    const auto n = times.convert_to<unsigned>();
    const integer above = boost::multiprecision::pow(numerator(root), n);
    const integer below = boost::multiprecision::pow(denominator(root), n);
    return within_limits(exponent < 0 ? rational(rational(below) / rational(above)) : rational(above, below));
}

std::optional<plain_number> folded_function(function_kind f, const rational& order, const plain_number& x) {
    return function::with_function(f, [&](auto of) {
        using each = decltype(of);
        if constexpr (function::ordered<each>) {
            return each::exact(order, x);
        } else {
            return each::exact(x);
        }
    });
}

}  // namespace libration
