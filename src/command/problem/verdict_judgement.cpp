#include "problem/verdict_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration {

namespace {

constexpr long judged_digits = 30;
constexpr long guard_digits = 20;

mpfr number_of(const std::string& text) {
    return text == "inf" ? std::numeric_limits<mpfr>::infinity() : from_exact<mpfr>(read_exact(text));
}

std::string judgement_of(const judged_verdict& verdict, const std::string& bound, const mpfr& lower,
                         const std::optional<mpfr>& upper) {
    if (verdict.radius.empty()) {
        return "none";
    }
    const mpfr radius = number_of(verdict.radius);
    const mpfr error = verdict.uncertainty.empty() ? mpfr(0) : number_of(verdict.uncertainty);
    const mpfr least = bound == "at most" ? mpfr(0) : mpfr(radius - error);
    const mpfr most = bound == "at least" ? std::numeric_limits<mpfr>::infinity() : mpfr(radius + error);
    if (most < lower || (upper && least > *upper)) {
        return "contradicted";
    }
    return upper && least <= lower && most >= *upper ? "holds" : "consistent";
}

}  // namespace

std::string judged_verdict::text() const {
    const std::string stated = radius.empty()        ? "no radius"
                               : uncertainty.empty() ? radius
                                                     : radius + " +- " + uncertainty;
    const std::string from =
        fmt::format("heuristic  {} from the coefficients up to t^{}", stated, usual_order_of_radius);
    return judgement == "none" ? from : from + ": " + judgement;
}

judged_verdict judge_verdict(const solution& of, long digits, const std::string& lower,
                             const std::optional<std::string>& upper, const task_runner& run) {
    request how{.scalar = {scalar_kind::arbitrary, judged_digits}, .digits = std::min(digits, judged_digits)};
    how.run = run;
    const answer found = of.radius({.order = usual_order_of_radius}, how);
    const precision_scope scope(std::max(digits, judged_digits) + guard_digits);
    judged_verdict verdict{found.at(0, "radius"), found.at(0, "uncertainty"), ""};
    verdict.judgement = judgement_of(verdict, found.at(0, "bound"), number_of(lower),
                                     upper ? std::optional(number_of(*upper)) : std::nullopt);
    return verdict;
}

}  // namespace libration
