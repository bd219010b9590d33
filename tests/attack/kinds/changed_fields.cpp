// Events that change the field of the surface on which they leave the solution, and bounces under forces with steps.
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "attack/plane_field.hpp"
#include "attack/printed_values.hpp"
#include "attack/sign_terms.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

constexpr const char* always_one = "1";  // as the second argument of terms of one unknown

std::string when(const rational& time, choices& next) {
    switch (next.below(4)) {
        case 0: return fmt::format("when t = {}:", as_typed(time));
        case 1: return "when x = 0 down:";
        default: return "when x = 0:";
    }
}

// Adds x at a time after the event that leaves it at 0, from where its velocity depends on its sign.
outcome asked_from_surface(printed_question question, const sign_term& velocity, const rational& since) {
    const known_end end = end_of(
        [&](int u, int) {
            return plane_vector{velocity.value(u, 1), 0};
        },
        {.u = 0, .v = 1}, since);
    question.slides = end.on_a_surface;
    std::optional<truth> x;
    if (end.end) {
        x = [=] { return real(end.end->u); };
    }
    question.unknowns = {{"x", {x}}};
    return asked_program(question);
}

// x does not fall, until a reset sets it to 0.
outcome ask_reset_to_surface(const sign_term& velocity, choices& next) {
    const rational event(next.between(1, 4), 2);
    const rational since(next.between(1, 6), 4);
    const rational start(next.between(1, 4), 2);
    printed_question question;
    question.problem =
        fmt::format("x' = {}; x(0) = {}; when t = {}: x = 0", velocity.text, as_typed(start), as_typed(event));
    question.times = {rational(event + since).str()};
    return asked_from_surface(question, velocity, since);
}

// x falls to 0, where p changes and with it the equation of x, which depends on the sign of x from then on.
outcome ask_reset_of_field(const sign_term& after, choices& next) {
    static constexpr std::array<const char*, 3> choices_of_field{"if(p > 0, {0}, {1})", "if(p < 0, {1}, {0})",
                                                                 "if(p >= 1, {0}, {1})"};
    const rational start(next.between(1, 4), 2);
    const rational speed(next.between(1, 4), 2);
    const rational event = start / speed;
    const rational later(next.between(-1, 6), 4);
    const rational time = later > -event ? rational(event + later) : event / 2;
    const std::string fall = as_typed(-speed);
    printed_question question;
    question.problem = fmt::format("x' = {}; p' = 0; x(0) = {}; p(0) = -1; {} p = {}",
                                   fmt::format(fmt::runtime(choices_of_field[next.below(3)]), after.text, fall),
                                   as_typed(start), when(event, next), next.one_in(2) ? "1" : "p + 2");
    question.times = {time.str()};
    if (time > event) {
        return asked_from_surface(question, after, time - event);
    }
    question.unknowns = {{"x", {[=] { return real(start - speed * time); }}}};
    return asked_program(question);
}

// 9/10 of the time at which the bounces accumulate.
rational latest_time(const rational& force, const rational& height, const rational& kept) {
    constexpr double part = 0.9;
    if (kept == 1) {
        return 1000;
    }
    const double fall = std::sqrt(rational(2 * height / force).convert_to<double>());
    return rational(part * fall * rational((1 + kept) / (1 - kept)).convert_to<double>());
}

// x'' = -force, with steps, where x > 0: x stays above 0, because each bounce turns the velocity.
outcome ask_bounce(choices& next) {
    const rational height(next.between(1, 8), next.between(1, 3));
    const rational kept(next.between(4, 10), 10);
    for (;;) {
        const rational time(next.between(1, 40), 10);
        const sign_term term = sign_term_choices(next, "x", always_one).any(2);
        const rational force = next.between(1, 9) - term.value(1, 1);
        if (force <= 0 || time > latest_time(force, height, kept)) {
            continue;
        }
        printed_question question;
        question.problem = fmt::format("x'' = {} - {}; x(0) = {}; x'(0) = 0; when x = 0 down: x' = -{}*x'", term.text,
                                       as_typed(force + term.value(1, 1)), as_typed(height), as_typed(kept));
        question.times = {time.str()};
        question.slides = false;
        question.digits = next.between(2, 20);
        question.unknowns = {{"x", {[=] {
                                  mpfr left = real(time);
                                  mpfr speed = sqrt(mpfr(2 * real(force * height)));  // at the next bounce
                                  const mpfr fall = speed / real(force);
                                  if (left <= fall) {
                                      return mpfr(real(height) - real(force) * left * left / 2);
                                  }
                                  left -= fall;
                                  for (;;) {
                                      speed *= real(kept);
                                      const mpfr flight = 2 * speed / real(force);
                                      if (left <= flight) {
                                          return mpfr(left * (speed - real(force) * left / 2));
                                      }
                                      left -= flight;
                                  }
                              }}}};
        return asked_program(question);
    }
}

// x'' = -x for x > 0, written with steps: half turns, each with a part of the velocity of the one before.
outcome ask_bouncing_oscillator(choices& next) {
    static constexpr std::array<const char*, 5> forces{"abs(x)", "x*sign(x)", "max(x, -x)", "if(x >= 0, x, -x)",
                                                       "max(x, 0)"};
    const rational height(next.between(1, 8), next.between(1, 3));
    const rational kept(next.between(4, 10), 10);
    const rational time(next.between(1, 90), 10);
    printed_question question;
    question.problem = fmt::format("x'' = -{}; x(0) = {}; x'(0) = 0; when x = 0 down: x' = -{}*x'",
                                   forces[next.below(forces.size())], as_typed(height), as_typed(kept));
    question.times = {time.str()};
    question.slides = false;
    question.digits = next.between(2, 20);
    question.unknowns = {{"x", {[=] {
                              const mpfr since = real(time) + pi_value() / 2;  // of the first half turn
                              const mpfr turns = floor(mpfr(since / pi_value()));
                              return mpfr(real(height) * pow(real(kept), turns) *
                                          sin(mpfr(since - turns * pi_value())));
                          }}}};
    return asked_program(question);
}

}  // namespace

outcome ask_changed_field(choices& next) {
    switch (next.below(6)) {
        case 0: return ask_bounce(next);
        case 1: return ask_bouncing_oscillator(next);
        default: break;
    }
    const sign_term velocity = sign_term_choices(next, "x", always_one).any(next.between(1, 2));
    return velocity.value(1, 1) >= 0 && next.one_in(3) ? ask_reset_to_surface(velocity, next)
                                                       : ask_reset_of_field(velocity, next);
}

}  // namespace libration::attack
