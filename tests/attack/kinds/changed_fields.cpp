// Events that change the field of the surface on which they leave the solution, and bounces under forces with steps.
#include <fmt/core.h>

#include <array>

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

// x falls to 0, where p changes and with it the equation of x, which depends on the sign of x from then on.
outcome ask_changed_field(const sign_term& after, choices& next) {
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
    question.unknowns = {{"x", {std::nullopt}}};
    if (time < event) {
        question.unknowns[0].values[0] = [=] { return real(start - speed * time); };
        return asked_program(question);
    }
    const sign_field field = [&](int u, int) { return plane_vector{after.value(u, 1), 0}; };
    const known_end end = end_of(field, {0, 1}, time - event);
    question.slides = end.on_a_surface;
    if (end.end) {
        const rational x = end.end->u;
        question.unknowns[0].values[0] = [=] { return real(x); };
    }
    return asked_program(question);
}

// x'' = -force, with steps, where x > 0: x stays above 0, because each bounce turns the velocity.
outcome ask_bounce(choices& next) {
    const rational height(next.between(1, 8), next.between(1, 3));
    const rational kept(next.between(4, 10), 10);
    const rational time(next.between(1, 40), 10);
    for (;;) {
        const sign_term term = sign_term_choices(next, "x", always_one).any(2);
        const rational force = next.between(1, 9) - term.value(1, 1);
        if (force <= 0) {
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
    switch (next.below(5)) {
        case 0: return ask_bounce(next);
        case 1: return ask_bouncing_oscillator(next);
        default: return ask_changed_field(sign_term_choices(next, "x", always_one).any(next.between(1, 2)), next);
    }
}

}  // namespace libration::attack
