// Solutions that begin on one or two switching surfaces, or that reach two at one time.
#include <fmt/core.h>

#include "attack/plane_field.hpp"
#include "attack/printed_values.hpp"
#include "attack/sign_terms.hpp"
#include "attack/step_terms.hpp"

namespace libration::attack {

namespace {

// u = x + k y - a, v = y - b: as typed, and back.
struct coordinates {
    rational a, b;
    long k;

    std::string u() const {
        const std::string x = k == 0 ? "x" : fmt::format("x + {}*y", as_typed(k));
        return a == 0 && k == 0 ? x : fmt::format("({} - {})", x, as_typed(a));
    }
    std::string v() const { return b == 0 ? "y" : fmt::format("(y - {})", as_typed(b)); }
    plane_vector velocity(const plane_vector& of) const { return {of.u - k * of.v, of.v}; }
    plane_vector point(const plane_vector& of) const {
        const rational y = of.v + b;
        return {of.u + a - k * y, y};
    }
};

coordinates any_coordinates(choices& next) {
    if (next.one_in(2)) {
        return {0, 0, 0};
    }
    return {rational(next.between(-3, 3), 2), next.between(-2, 2), next.between(-1, 2)};
}

// The origin, a point of an axis, or one from which some fields lead to the origin.
plane_vector any_start(choices& next) {
    switch (next.below(4)) {
        case 0: return {0, rational(next.between(-3, 3), 2)};
        case 1: return {next.between(-1, 1), next.between(-1, 1)};
        default: return {0, 0};
    }
}

// Both velocities are piecewise constant.
outcome ask_plane(choices& next) {
    for (;;) {
        const coordinates axes = any_coordinates(next);
        sign_term_choices terms(next, axes.u(), axes.v());
        const sign_term x = terms.any(next.between(1, 2));
        const sign_term y = terms.any(next.between(1, 2));
        const sign_field field = [&](int u, int v) {
            const rational x_velocity = x.value(u, v);
            const rational y_velocity = y.value(u, v);
            return plane_vector{x_velocity + axes.k * y_velocity, y_velocity};
        };
        const plane_vector start = any_start(next);
        const rational time(next.between(1, 12), 4);
        const known_end end = end_of(field, start, time);
        if (!end.is_known) {
            continue;
        }
        const plane_vector from = axes.point(start);
        printed_question question;
        question.problem =
            fmt::format("x' = {}; y' = {}; x(0) = {}; y(0) = {}", x.text, y.text, as_typed(from.u), as_typed(from.v));
        question.times = {time.str()};
        question.unknowns = {{"x", {std::nullopt}}, {"y", {std::nullopt}}};
        question.slides = end.on_a_surface;
        if (end.end) {
            const plane_vector to = axes.point(*end.end);
            question.unknowns[0].values[0] = [=] { return real(to.u); };
            question.unknowns[1].values[0] = [=] { return real(to.v); };
        }
        return asked_program(question);
    }
}

// x' = if(x > 0, y, z), y' and z' constant by the sign of x, all 0 at first: x'' = y' above, z' below. With the part p
// of the field above, x = 0 as long as p y + (1 - p) z = 0: for a constant p where a quadratic polynomial is 0.
outcome ask_contact(choices& next) {
    const auto slope = [&] { return rational(next.one_in(4) ? next.between(-6, -1) : next.between(1, 6)); };
    const rational y_above = slope();
    const rational y_below = next.one_in(2) ? rational(-slope()) : slope();
    const rational z_above = next.one_in(2) ? rational(-slope()) : slope();
    const rational z_below = slope();
    const rational square = y_above - y_below - z_above + z_below;
    const rational linear = y_below + z_above - 2 * z_below;
    const auto at = [&](const rational& p) { return rational((square * p + linear) * p + z_below); };
    const rational middle = square == 0 ? rational(-1) : rational(-linear / (2 * square));
    const bool slides =
        at(0).sign() * at(1).sign() <= 0 || (middle > 0 && middle < 1 && at(middle).sign() * at(0).sign() <= 0);
    const bool rises = y_above > 0;
    const bool falls = z_below < 0;
    const rational time(next.between(1, 8), 4);
    printed_question question;
    question.problem = fmt::format(
        "x' = if(x > 0, y, z); y' = if(x > 0, {}, {}); z' = if(x > 0, {}, {}); x(0) = 0; y(0) = 0; z(0) = 0",
        as_typed(y_above), as_typed(y_below), as_typed(z_above), as_typed(z_below));
    question.times = {time.str()};
    question.slides = slides;
    const rational acceleration = rises ? y_above : falls ? z_below : rational(0);
    std::optional<truth> x;
    if ((slides ? 1 : 0) + (rises ? 1 : 0) + (falls ? 1 : 0) == 1) {
        x = [=] { return real(acceleration * time * time / 2); };
    }
    question.unknowns = {{"x", {x}}};
    return asked_program(question);
}

}  // namespace

outcome ask_surface_start(choices& next) { return next.one_in(8) ? ask_contact(next) : ask_plane(next); }

}  // namespace libration::attack
