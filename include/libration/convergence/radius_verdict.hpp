// The verdict drawn from all radius tests, with its reasons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::convergence {

/// Whether an estimate is certain to N^-p of the radius. For coefficients of the form that its test assumes this holds
/// for any p as N grows; with corrections by logarithms or by other powers it does not.
template <rounding_scalar T>
bool is_certain_to_power(const radius_estimate<T>& estimate, const list_quality<T>& list, int p) {
    if (!estimate.radius || list.order < 1) {
        return false;
    }
    T scaled = estimate.uncertainty / *estimate.radius;
    for (int i = 0; i < p; ++i) {
        scaled *= list.order;
    }
    return scaled <= 1;
}

/// More certain than slow corrections allow.
template <rounding_scalar T>
bool is_sharp(const radius_estimate<T>& estimate, const list_quality<T>& list) {
    return is_certain_to_power(estimate, list, 4);
}

/// So certain that a pole or a logarithm is a pure one: to N^-6, or, if the noise of the coefficients does not allow
/// that, to 256 N^2 times the noise, calibrated. Psi series reach N^-5, in double N^-3.
template <rounding_scalar T>
bool is_pure(const radius_estimate<T>& estimate, const list_quality<T>& list) {
    constexpr int noise_factor = 256;
    const T least = list.noise * list.order * list.order * noise_factor;
    return is_sharp(estimate, list) &&
           (is_certain_to_power(estimate, list, 6) || estimate.uncertainty <= *estimate.radius * least);
}

/// The fraction p/q, q <= most, with the smallest q that is within the uncertainty of the exponent, if there is one.
template <rounding_scalar T>
std::optional<rational> fraction_within(const radius_estimate<T>& estimate, int most) {
    using std::abs;
    for (int q = 1; q <= most; ++q) {
        const rational nearest(nearest_integer(widen(T(*estimate.exponent * q))), q);
        if (abs(T(*estimate.exponent - from_rational<T>(nearest))) <= estimate.exponent_uncertainty) {
            return nearest;
        }
    }
    return std::nullopt;
}

/// Adds to the uncertainty of the exponent that due to the radius. Coefficients near n do not distinguish a relative
/// change delta of the radius from a change n delta of the exponent. Logarithms and other slow corrections hide more:
/// of k/log n in the exponent, k/(n log^2 n) appears in the radius from a straight line through the ratios, and less in
/// that from a curve through them; if the radius is not sharp, n log^2(n) delta is added, calibrated, and 2 n log^3(n)
/// delta if no fraction with a denominator of at most 3 is within that: the exponents of most equations are such
/// fractions, and a local exponent shifted by a logarithm is near one only by chance.
template <rounding_scalar T>
void add_position_to_exponent(radius_estimate<T>& estimate, const list_quality<T>& list) {
    using std::log;
    if (!estimate.radius || !estimate.exponent || list.order < 2) {
        return;
    }
    constexpr int simple_denominator = 3;
    T allowed = estimate.uncertainty / *estimate.radius * list.order;
    const auto allow = [&] { estimate.exponent_uncertainty = std::max(estimate.exponent_uncertainty, allowed); };
    if (is_sharp(estimate, list)) {
        return allow();
    }
    const T logarithm = log(T(list.order));
    allowed *= logarithm * logarithm;
    allow();
    if (!fraction_within(estimate, simple_denominator)) {
        allowed *= logarithm * 2;
        allow();
    }
}

/// The exponent nu as a hypothesis: the fraction p/q, q <= 6, within the uncertainty of the estimate, with the smallest
/// q. Returns std::nullopt if there is none, or if the uncertainty is too large to distinguish such fractions.
template <rounding_scalar T>
std::optional<rational> simple_exponent(const radius_estimate<T>& estimate) {
    constexpr int largest_denominator = 6;
    if (!estimate.exponent || estimate.exponent_uncertainty * (4 * largest_denominator * largest_denominator) > 1) {
        return std::nullopt;
    }
    return fraction_within(estimate, largest_denominator);
}

/// The kind that follows from the interval of the exponent. For a pure verdict: pole for a negative integer, logarithm
/// for 0 and other integers, algebraic otherwise; for others, whose coefficients may contain logarithms or powers in
/// addition to the leading one: branch if the interval contains no integer. Otherwise unknown.
template <rounding_scalar T>
singularity_kind kind_of(const radius_estimate<T>& estimate, bool pure) {
    using std::abs;
    if (!estimate.exponent) {
        return singularity_kind::unknown;
    }
    const rational nearest(nearest_integer(widen(*estimate.exponent)));
    const T away = abs(T(*estimate.exponent - from_rational<T>(nearest)));
    if (away > estimate.exponent_uncertainty) {
        return pure ? singularity_kind::algebraic : singularity_kind::branch;
    }
    const auto simple = simple_exponent(estimate);
    if (!pure || !simple) {
        return singularity_kind::unknown;
    }
    return *simple < 0 ? singularity_kind::pole : singularity_kind::logarithm;
}

/// The root test's estimate for a lacunary series, which has its whole circle of convergence as a boundary if its gaps
/// keep growing [Hadamard1892].
template <rounding_scalar T>
radius_estimate<T> lacunary_verdict(const std::vector<radius_estimate<T>>& tests) {
    for (const auto& each : tests) {
        if (each.method == "root" && each.radius) {
            radius_estimate<T> verdict = each;
            verdict.method = "verdict";
            verdict.kind = singularity_kind::boundary;
            verdict.note = "by root: no other test applies to growing gaps";
            return verdict;
        }
    }
    return no_estimate<T>("verdict", "a lacunary series, of which the root test gives no radius");
}

/// An estimate as weighted in the verdict: its uncertainty, and the probability that it refers to the nearest
/// singularity at all, both calibrated on the population of tests/convergence/radius_families.hpp.
template <rounding_scalar T>
struct weighed_answer {
    const radius_estimate<T>* of;
    T uncertainty;
    T trust;
    const T& radius() const { return *of->radius; }
};

/// All estimates whose uncertainty, multiplied by the test's caution factor, is below the radius; by increasing
/// relative uncertainty.
template <rounding_scalar T>
std::vector<weighed_answer<T>> weighed_answers(const std::vector<radius_estimate<T>>& tests) {
    std::vector<weighed_answer<T>> answers;
    for (const auto& each : tests) {
        if (each.radius) {
            const T uncertainty = each.uncertainty * each.caution;
            if (uncertainty < *each.radius) {
                answers.push_back({&each, uncertainty, each.may_decide ? T(T(19) / 20) : T(T(4) / 5)});
            }
        }
    }
    std::stable_sort(answers.begin(), answers.end(), [](const auto& a, const auto& b) {
        return a.uncertainty * b.radius() < b.uncertainty * a.radius();
    });
    return answers;
}

/// log of the probability, up to a common factor, of all estimates if estimate i is correct to its uncertainty: each
/// other one is either correct too, and then as near as both uncertainties allow, beyond which its density falls like
/// the fourth power; or it may be anywhere between 0 and two radii.
template <rounding_scalar T>
T log_evidence(const std::vector<weighed_answer<T>>& answers, std::size_t i) {
    using std::abs;
    using std::log;
    const weighed_answer<T>& lead = answers[i];
    T sum = log(lead.trust);
    for (std::size_t j = 0; j < answers.size(); ++j) {
        if (j != i) {
            const T allowed = lead.uncertainty + answers[j].uncertainty + lead.radius() * epsilon<T>();
            const T apart = abs(lead.radius() - answers[j].radius()) / allowed;
            const T size = lead.radius() < answers[j].radius() ? lead.radius() : answers[j].radius();
            const T density = size / allowed / (apart > 1 ? T(apart * apart * apart * apart) : T(1));
            sum += log(T(answers[j].trust * density + 1 - answers[j].trust));
        }
    }
    return sum;
}

/// The estimate best supported by the others, among the tests that may decide and are certain to a sixteenth, or among
/// all to a factor of 3/2 if there is none; std::nullopt if there is no such estimate either.
template <rounding_scalar T>
std::optional<std::size_t> leading_answer(const std::vector<weighed_answer<T>>& answers) {
    const auto most_believed = [&](auto may_lead) {
        std::optional<std::size_t> best;
        T most(0);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (may_lead(answers[i])) {
                const T evidence = log_evidence(answers, i);
                if (!best || evidence > most) {
                    best = i;
                    most = evidence;
                }
            }
        }
        return best;
    };
    const auto decided =
        most_believed([](const auto& a) { return a.of->may_decide && a.uncertainty * 16 < a.radius(); });
    return decided
               ? decided
               : most_believed([](const auto& a) { return a.of->may_decide || a.of->uncertainty * 2 < a.radius(); });
}

/// How another estimate supports or contradicts the leading one.
template <rounding_scalar T>
struct witness {
    std::string what;  ///< "confirmed by domb-sykes"
    T uncertainty;     ///< the remaining uncertainty
};

/// The most certain estimate that agrees; if none does, the one that contradicts least, by its distance and its own
/// uncertainty; if no other is certain to a quarter of the radius, four times the estimate's own uncertainty, or twice
/// if that is already more than its test states.
template <rounding_scalar T>
witness<T> witness_of(const std::vector<weighed_answer<T>>& answers, std::size_t lead) {
    using std::abs;
    const T own = answers[lead].uncertainty;
    const weighed_answer<T>* confirms = nullptr;
    const weighed_answer<T>* contradicts = nullptr;
    T doubt(0);
    for (std::size_t j = 0; j < answers.size(); ++j) {
        const auto& other = answers[j];
        if (j == lead || other.uncertainty * 4 > other.radius()) {
            continue;
        }
        const T apart = abs(answers[lead].radius() - other.radius());
        if (apart <= own + other.uncertainty) {
            confirms = confirms == nullptr || other.uncertainty < confirms->uncertainty ? &other : confirms;
        } else if (contradicts == nullptr || apart + other.uncertainty < doubt) {
            contradicts = &other;
            doubt = apart + other.uncertainty;
        }
    }
    if (confirms != nullptr) {
        return {", confirmed by " + confirms->of->method, own};
    }
    if (contradicts != nullptr) {
        return {", contradicted by " + contradicts->of->method, doubt};
    }
    return {", not confirmed by another test", T(own * (answers[lead].of->may_decide ? 4 : 2))};
}

/// If an agreeing test that may decide has detected a nearer, weaker singularity, the uncertainty is twice its
/// distance, unless the estimate is certain to three quarters of the digits: then no weaker contribution is left in
/// them.
template <rounding_scalar T>
void add_nearer(witness<T>& said, const std::vector<weighed_answer<T>>& answers, std::size_t lead) {
    using std::abs;
    using std::sqrt;
    const T root = sqrt(epsilon<T>());
    if (said.uncertainty < answers[lead].radius() * root * T(sqrt(root))) {
        return;
    }
    for (const auto& other : answers) {
        const T apart = abs(answers[lead].radius() - other.radius());
        const bool agrees = apart <= answers[lead].uncertainty + other.uncertainty;
        if (agrees && other.of->may_decide && other.of->nearer * 2 > said.uncertainty) {
            said = {", contradicted by a nearer root of " + other.of->method, T(other.of->nearer * 2)};
        }
    }
}

/// Drops an exponent whose uncertainty is more than a half.
template <rounding_scalar T>
void drop_uncertain_exponent(radius_estimate<T>& verdict) {
    if (verdict.exponent && verdict.exponent_uncertainty * 2 > 1) {
        verdict.exponent.reset();
        verdict.exponent_uncertainty = T(0);
    }
}

/// The exponent of an estimate, or, if that is an assumption of its test, the more certain one measured by an agreeing
/// test; none whose uncertainty is more than a half.
template <rounding_scalar T>
void choose_exponent(radius_estimate<T>& verdict, const std::vector<weighed_answer<T>>& answers, const T& own) {
    using std::abs;
    if (verdict.exponent_assumed) {
        for (const auto& other : answers) {
            const bool agrees = abs(*verdict.radius - other.radius()) <= own + other.uncertainty;
            if (agrees && other.of->may_decide && other.of->exponent && !other.of->exponent_assumed &&
                (other.of->exponent_uncertainty < verdict.exponent_uncertainty)) {
                verdict.exponent = other.of->exponent;
                verdict.exponent_uncertainty = other.of->exponent_uncertainty;
            }
        }
    }
    if (verdict.exponent && own < verdict.uncertainty) {
        verdict.exponent_uncertainty *= verdict.uncertainty / own;
    }
    drop_uncertain_exponent(verdict);
}

/// The estimate best supported by the others, with its certainty reduced if they do not confirm it.
template <rounding_scalar T>
radius_estimate<T> verdict_of(const std::vector<radius_estimate<T>>& tests, const coefficient_pattern& pattern) {
    if (pattern.lacunary) {
        return lacunary_verdict(tests);
    }
    const auto answers = weighed_answers(tests);
    const auto lead = leading_answer(answers);
    if (!lead) {
        return no_estimate<T>("verdict", "no test gives a radius to a factor of 3/2: " + pattern.text());
    }
    const T own = answers[*lead].uncertainty;
    auto said = witness_of(answers, *lead);
    add_nearer(said, answers, *lead);
    radius_estimate<T> verdict = *answers[*lead].of;
    if (!(said.uncertainty < *verdict.radius)) {
        return no_estimate<T>("verdict", "no test is certain to the size of the radius: " + verdict.method + said.what);
    }
    verdict.note = "by " + verdict.method + said.what;
    verdict.method = "verdict";
    verdict.uncertainty = said.uncertainty;
    choose_exponent(verdict, answers, own);
    return verdict;
}

}  // namespace libration::convergence
