// Stores that become empty, also where their outflow is not differentiable, and oscillations at their zeros and next to
// them.
#include <fmt/core.h>

#include <array>

#include "attack/printed_values.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// h' = -k h^a from h(0) = start, until h is 0.
struct emptying_store {
    rational start, rate, exponent;

    // h^(1 - a), or log h for a = 1, falls by k (1 - a), or k, in a unit of time.
    mpfr level(const mpfr& time) const {
        if (exponent == 1) {
            return real(start) * exp(mpfr(-real(rate) * time));
        }
        const mpfr rest = real(1 - exponent);
        const mpfr left = pow(real(start), rest) - real(rate) * rest * time;
        return left > 0 ? pow(left, mpfr(1 / rest)) : mpfr(0);
    }
};

rational fourth_power(const rational& root) { return root * root * root * root; }

std::string outflow_of(const emptying_store& store, choices& next) {
    const std::string power =
        store.exponent == rational(1, 2) && next.one_in(2) ? "sqrt(h)" : fmt::format("h^({})", store.exponent.str());
    const std::string rate = as_typed(store.rate);
    switch (next.below(4)) {
        case 0: return fmt::format("if(h > 0, ({})*{}, 0)", rate, power);
        case 1: return fmt::format("({})*if(h > 0, {}, 0)", rate, power);
        case 2: return fmt::format("if(h <= 0, 0, ({})*{})", rate, power);
        default: return fmt::format("if(not (h <= 0), {}*({}), 0)", power, rate);
    }
}

// A time up to twice that at which the store is empty, often this one or next to it.
rational time_of_question(const emptying_store& store, choices& next) {
    const rational size(next.between(1, 40), 20);
    if (store.exponent >= 1) {
        return size;
    }
    // Exact where the fourth root of the start is a fraction and 4 (1 - a) is an integer.
    const precision_scope scope(80);
    const mpfr rest = real(1 - store.exponent);
    rational empty;
    mpfr_get_q(empty.backend().data(), handle(mpfr(pow(real(store.start), rest) / (real(store.rate) * rest))));
    switch (next.below(4)) {
        case 0: return size * rational(empty * 1000).convert_to<long>() / 1000;
        case 1: return rational(empty * 1000).convert_to<long>() / rational(1000);
        default: {
            const rational apart = typed_fraction(fmt::format("1e-{}", next.between(3, 30)));
            const rational near = typed_fraction(fmt::format("{:.6f}", empty.convert_to<double>()));
            return next.one_in(2) ? near + apart : near - apart;
        }
    }
}

}  // namespace

outcome ask_emptied_store(choices& next) {
    static const std::array<rational, 8> exponents{rational(1, 4), rational(1, 3),  rational(1, 2), rational(2, 3),
                                                   rational(3, 4), rational(9, 10), rational(1),    rational(3, 2)};
    emptying_store store{fourth_power(rational(next.between(1, 3), next.between(1, 2))),
                         rational(next.between(1, 6), next.between(1, 3)), exponents[next.below(exponents.size())]};
    const std::string flow = outflow_of(store, next);
    const long collected = next.between(-2, 2);  // of what flows out
    const rational time = time_of_question(store, next);
    if (time <= 0) {
        return ask_emptied_store(next);
    }
    printed_question question;
    question.digits = next.between(2, 25);
    const std::string filled = next.one_in(4) ? "; when t = 1/2: h = 1/16" : "";
    question.problem = fmt::format("{0}; h(0) = {1}; Q(0) = 0{2}",
                                   next.one_in(2) ? fmt::format("h' = -{0}; Q' = {1}*{0}", flow, collected)
                                                  : fmt::format("Q' = {1}*{0}; h' = -{0}", flow, collected),
                                   as_typed(store.start), filled);
    // A second store beside it, with a factor exp(-c t).
    const emptying_store beside{fourth_power(rational(next.between(1, 3), 2)), rational(next.between(1, 4), 2),
                                exponents[next.below(6)]};
    const rational decay(next.between(0, 2), 4);
    if (next.one_in(2)) {
        question.problem +=
            fmt::format("; g' = -if(g > 0, g^({}), 0)*({})*exp(-({})*t); g(0) = {}", beside.exponent.str(),
                        as_typed(beside.rate), as_typed(decay), as_typed(beside.start));
        question.unknowns.push_back({"g", {[=] {
                                         const mpfr c = real(decay);
                                         return beside.level(decay == 0 ? real(time)
                                                                        : mpfr((1 - exp(mpfr(-c * real(time)))) / c));
                                     }}});
    }
    question.times = {time.str()};
    // A reset at the time of the question counts as before or after it: it is not asked.
    const bool is_filled = !filled.empty() && time > rational(1, 2);
    if (!filled.empty() && time == rational(1, 2)) {
        return ask_emptied_store(next);
    }
    const emptying_store second{rational(1, 16), store.rate, store.exponent};
    const auto level = [=] {
        return is_filled ? second.level(mpfr(real(time) - mpfr(1) / 2)) : store.level(real(time));
    };
    question.unknowns.push_back({"h", {level}});
    question.unknowns.push_back({"Q", {[=] {
                                     const mpfr out = real(store.start) -
                                                      (is_filled ? store.level(mpfr(mpfr(1) / 2)) : mpfr(0)) +
                                                      (is_filled ? mpfr(1) / 16 : mpfr(0)) - level();
                                     return mpfr(collected * out);
                                 }}});
    return asked_program(question);
}

// x = p cos(w s) + q sin(w s), often with p = 0, q = 0 or p = q, at fractions of pi/w and next to them.
outcome ask_oscillation_zero(choices& next) {
    const rational w(next.between(1, 6), next.between(1, 4));
    const rational size(next.between(1, 5), next.between(1, 3));
    const std::uint64_t phase = next.below(4);
    const rational p = phase == 0 ? rational(0) : size;
    const rational q = phase == 1 ? rational(0) : phase == 2 ? size : rational(next.between(1, 4));
    const rational turns(next.between(1, 12), next.one_in(3) ? 3 : 4);
    const rational apart =
        next.one_in(2) ? rational(0)
                       : typed_fraction(fmt::format("{}1e-{}", next.one_in(2) ? "-" : "", next.between(15, 60)));
    // A frequency that differs from that of the times by as little.
    const rational other = next.one_in(4) ? w * (1 + typed_fraction(fmt::format("1e-{}", next.between(15, 60)))) : w;
    printed_question question;
    question.digits = next.between(2, 30);
    question.slides = false;
    const std::string start = fmt::format("x(0) = {}; ", as_typed(p));
    switch (next.below(3)) {
        case 0:
            question.problem =
                fmt::format("x'' = -({})*x; {}x'(0) = {}", as_typed(other * other), start, as_typed(q * other));
            break;
        case 1:  // x' = a x + b y, y' = c x - a y
            question.problem = fmt::format("y' = ({2})*x - 2*y; x' = 2*x + 3*y; {0}y(0) = {1}", start,
                                           as_typed((q * other - 2 * p) / 3), as_typed(-(other * other + 4) / 3));
            break;
        default:  // next to an unknown that it drives
            question.problem = fmt::format("z' = x - z^3; x' = ({})*y; y' = -({})*x; z(0) = 1; {}y(0) = {}",
                                           as_typed(other), as_typed(other), start, as_typed(q));
            break;
    }
    question.times = {fmt::format("({})*pi{}{}", rational(turns / w).str(), apart < 0 ? "-" : "+",
                                  as_typed(apart < 0 ? rational(-apart) : apart))};
    const rational parts = turns * 4;  // of an eighth of a turn
    const bool sine_is_0 = denominator(turns) == 1;
    const bool cosine_is_0 = denominator(rational(turns - rational(1, 2))) == 1;
    const bool exact = apart == 0 && other == w &&
                       ((p == 0 && sine_is_0) || (q == 0 && cosine_is_0) ||
                        (p == q && denominator(parts) == 1 && numerator(parts) % 4 == 3));
    question.unknowns = {{"x", {[=] {
                              if (exact) {
                                  return mpfr(0);
                              }
                              const precision_scope wider(working_digits() + 100);
                              const mpfr angle = real(other) * (real(turns / w) * pi_value() + real(apart));
                              return mpfr(real(p) * cos(angle) + real(q) * sin(angle));
                          }}}};
    return asked_program(question);
}

}  // namespace libration::attack
