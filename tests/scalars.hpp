// The one list of scalars that typed tests run over, and the matcher that judges their values.
#pragma once

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "libration/number/exact.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::tests {

/// A scalar under test: the type, and its working precision.
template <class T>
struct scalar_tag {
    using type = T;
    /// `const typename TestType::precision precision;` at the top of a test sets the working precision.
    struct precision {
        precision() {}  // NOLINT(modernize-use-equals-default): not trivial, so that no variable is reported as unused
    };
};

/// Catch runs the test at 40 digits and again at 100, so that its body is compiled only once. Another object in the scope
/// of the first sets the same precision.
template <>
struct scalar_tag<mpfr> {
    using type = mpfr;
    class precision {
    public:
        precision() : first_(digits_ == 0), scope_(first_ ? digits_ = GENERATE(40L, 100L) : digits_) {}
        precision(const precision&) = delete;
        precision& operator=(const precision&) = delete;
        ~precision() {
            if (first_) {
                digits_ = 0;
            }
        }

    private:
        static inline long digits_ = 0;  // of the test that runs
        bool first_;
        precision_scope scope_;
    };
};

using all_scalars = std::tuple<scalar_tag<double>, scalar_tag<long double>, scalar_tag<quad>, scalar_tag<mpfr>>;

/// The fraction that an mpfr is.
inline rational fraction_of(const mpfr& x) {
    rational value;
    mpfr_get_q(value.backend().data(), handle(x));
    return value;
}

/// A number that a value is compared with, and how far it may itself be from the truth.
struct expected_value {
    mpfr value;
    mpfr uncertainty;
};

/// A decimal text correct to one unit in its last digit, at 200 digits.
inline expected_value decimal(const std::string& text) {
    const precision_scope scope(200);
    expected_value result;
    mpfr_set_str(handle(result.value), text.c_str(), 10, MPFR_RNDN);
    std::size_t digits = 0;
    for (const char c : text.substr(0, text.find('e'))) {
        digits += (c >= '1' && c <= '9') || (c == '0' && digits > 0) ? 1 : 0;
    }
    result.uncertainty = abs(result.value) * pow(mpfr(10), 1 - static_cast<int>(digits));
    return result;
}

/// A value computed in T, taken as exact.
template <class T>
expected_value exactly(const T& value) {
    return {widen(value), mpfr(0)};
}

/// |actual - expected| <= ulps * epsilon<T> * scale + uncertainty of expected; scale is |expected| unless given.
template <class T>
class near_matcher : public Catch::MatcherBase<T> {
public:
    near_matcher(expected_value expected, long ulps, std::optional<mpfr> scale)
        : expected_(std::move(expected)), ulps_(ulps), epsilon_(widen(epsilon<T>())) {
        const precision_scope scope(220);
        allowed_ = epsilon_ * ulps_ * (scale ? abs(*scale) : abs(expected_.value)) + expected_.uncertainty;
    }
    bool match(const T& actual) const override {
        const precision_scope scope(220);
        return abs(widen(actual) - expected_.value) <= allowed_;
    }
    std::string describe() const override {
        return "is within " + std::to_string(ulps_) + " eps of " + to_decimal(expected_.value, 60) + " (allowed " +
               to_decimal(allowed_, 3) + ")";
    }

private:
    expected_value expected_;
    long ulps_;
    mpfr epsilon_;
    mpfr allowed_;
};

template <class T>
near_matcher<T> near(const expected_value& expected, long ulps) {
    return {expected, ulps, std::nullopt};
}
template <class T>
near_matcher<T> near(const T& expected, long ulps) {
    return {exactly(expected), ulps, std::nullopt};
}
/// With the error measured against a scale of the problem instead of the expected value itself.
template <class T, class S>
near_matcher<T> near(const expected_value& expected, long ulps, const S& scale) {
    return {expected, ulps, widen(scale)};
}
template <class T, class S>
near_matcher<T> near(const T& expected, long ulps, const S& scale) {
    return {exactly(expected), ulps, widen(scale)};
}

}  // namespace libration::tests

namespace Catch {
/// Failures print values in full, whatever the scalar.
template <>
struct StringMaker<libration::mpfr> {
    static std::string convert(const libration::mpfr& x) { return libration::to_round_trip(x); }
};
template <>
struct StringMaker<libration::quad> {
    static std::string convert(const libration::quad& x) { return libration::to_round_trip(x); }
};
}  // namespace Catch
