// The law of all Taylor coefficients of a solution as an object: any coefficient and any ratio without the ones before.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "libration/digits/known_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// The request of a law (ode::coefficient_law).
struct law_question {
    /// An unknown or a derivative of it, y or th'; the first unknown if it is empty.
    std::string show = {};
    std::optional<exact> within = {};
    /// The last index of the expansions at branch points.
    int terms = 60;
};

/// The ratios a_n/a_(n-p) of a law, p its stride, and their straight line, as far as they are proved (ode::ratio_line).
struct law_ratio {
    known_value ratio;
    std::string by;  ///< law or recurrence
    /// limit (1 - p (1 + exponent)/n), and a bound of |ratio - line|; empty if no line is proved.
    known_value line;
    std::string deviation;
};

/// The n-th root of the law: |a_n|^(-1/n), and a bound of its distance from the radius of convergence, which is empty
/// if that is not proved.
struct law_root {
    known_value root;
    std::string by;
    std::string deviation;
};

/// The law of the coefficients a_n of (t - t0)^n of one unknown or derivative, proved once for any number of questions.
/// Every digit of a value is proved; a value has fewer digits than requested, or only a bound, where neither the law nor
/// the recurrence, which is used up to the power 20000, gives them. request::stage is called in later questions, too, if
/// they need more bits. Not for several threads at once.
class proved_law {
public:
    /// Throws error of the subject "unknown" for a name that is none, of the kind undecided as coefficient_law::of.
    proved_law(const ode::explicit_system& system, const law_question& asked, const request& how);
    ~proved_law();
    proved_law(proved_law&& other) noexcept;
    proved_law& operator=(proved_law&& other) noexcept;
    proved_law(const proved_law&) = delete;
    proved_law& operator=(const proved_law&) = delete;

    /// The unknown or derivative.
    const std::string& name() const;
    /// RHO, up to which all singularities are known.
    double rho() const;
    /// n0: the law holds for all n >= n0, with fewer terms of the expansions for small n.
    long first() const;
    /// p: all coefficients with indices other than residue + k p are 0, by symmetry.
    int stride() const;
    int residue() const;
    /// law_report::singularities.
    answer singularities(long digits) const;

    /// a_n with up to so many digits; `by`: law, recurrence, or symmetry for an exact 0.
    struct coefficient_value {
        known_value value;
        std::string by;
        bool complete = true;  ///< whether it has all digits of the request
    };
    coefficient_value coefficient(long n, long digits) const;
    /// Whether numbers are read from the law alone, with as many digits as it gives, and not from the recurrence.
    enum class source { any, law };
    /// a_n/a_(n-p). Throws error of the kind argument if a_n is 0 by symmetry, and for n < p, or n < first() + p for
    /// the law alone.
    law_ratio ratio(long n, long digits, source by = source::any) const;
    /// |a_n|^(-1/n). Throws error of the kind argument if a_n is 0 by symmetry, and for n < 1, or n < first() for the
    /// law alone.
    law_root root(long n, long digits, source by = source::any) const;
    /// The limit of the ratios, if one is proved, and the radius of convergence; only a bound or nothing where they are
    /// not.
    known_value limit(long digits) const;
    known_value exponent(long digits) const;
    known_value radius(long digits) const;

private:
    class values;
    std::unique_ptr<values> values_;
};

}  // namespace libration
