// Terms made of nested steps of piecewise linear functions of the time, with their exact values.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "attack/constants.hpp"

namespace libration::attack {

/// constant + slope t.
struct line {
    rational constant = 0;
    rational slope = 0;

    rational at(const rational& time) const { return constant + slope * time; }
};

/// The ends of the pieces into which an interval of time is divided.
using partition = std::set<rational>;

/// A term that is linear in the time on each piece, by the meaning of its functions: sign(0) = 0, heaviside(0) = 1/2,
/// and a condition by its relation as written. Its value at the ends of pieces has no influence on an integral.
struct step_term {
    std::string text;
    std::function<line(const rational& inside)> near;  ///< at a time that is not the end of a piece
    std::function<void(partition& ends)> divide;       ///< adds the ends of its pieces
    bool is_step = false;                              ///< constant on each piece
};

/// A condition: whether it holds, and the ends of the pieces on which it does or does not.
struct step_condition {
    std::string text;
    std::function<bool(const rational& inside)> holds;
    std::function<void(partition& ends)> divide;
};

/// >, >=, <, <=, == or !=.
std::string any_relation(choices& next);
/// Whether a RELATION b, by the sign of a - b.
bool holds(const std::string& relation, int sign);

/// A nonnegative integer as it is, any other fraction in parentheses.
std::string as_typed(const rational& q);

step_term constant_term(const std::string& text, const rational& value);
inline step_term number_term(const rational& value) { return constant_term(as_typed(value), value); }
/// The time, as it is typed, or an unknown that changes linearly.
step_term linear_term(const std::string& text, const line& value);
/// An unknown that changes linearly, before and after a time.
step_term bent_term(const std::string& text, const line& before, const rational& time, const line& after);

step_term sum(const step_term& a, const step_term& b);
/// One of the factors is_step.
step_term product(const step_term& a, const step_term& b);
step_term absolute(const step_term& u);
step_term sign_of_term(const step_term& u);
step_term heaviside(const step_term& u);
/// floor(u/divisor).
step_term floor_of(const step_term& u, const rational& divisor);
/// min(u, v) or max(u, v).
step_term extreme(bool largest, const step_term& u, const step_term& v);
/// u RELATION v.
step_condition comparison(const step_term& u, const std::string& relation, const step_term& v);
/// `p and q` or `p or q`, in any notation, and `not p`.
step_condition combined(bool all, const step_condition& p, const step_condition& q, choices& next);
step_condition opposite(const step_condition& of, choices& next);
/// if(condition, p, q).
step_term conditional(const step_condition& condition, const step_term& p, const step_term& q);
/// if(u RELATION v, p, q).
inline step_term conditional(const step_term& u, const std::string& relation, const step_term& v, const step_term& p,
                             const step_term& q) {
    return conditional(comparison(u, relation, v), p, q);
}
/// ceil(u), trunc(u), round(u) with halves away from 0, or rint(u) with halves to even numbers.
step_term whole_of(const std::string& function, const step_term& u);
/// mod(u, k), fmod(u, k) or remainder(u, k), for a positive k.
step_term remainder_of(const std::string& function, const step_term& u, const rational& k);
/// square(pi u), sawtooth(pi u) for u = slope t + constant, slope not 0.
step_term square_wave(const step_term& u, const std::string& argument);
step_term sawtooth_wave(const step_term& u, const std::string& argument);

rational integral(const step_term& of, const rational& from, const rational& to);

/// Random terms of leaves.
class term_choices {
public:
    /// `half_turn` is the text of pi times the time; without it there are no waves.
    term_choices(choices& next, std::vector<step_term> leaves, std::string half_turn = "")
        : next_(next), leaves_(std::move(leaves)), half_turn_(std::move(half_turn)) {}

    /// Of at most so many functions inside each other.
    step_term any(long depth);
    /// A function of the first leaf and of steps that depend on any: its argument jumps where they do.
    step_term against_steps(long depth);
    /// Small multiples of 1/2 and of 1/3: many steps change at one time.
    rational level();

private:
    step_term leaf();
    step_term chosen(long depth);
    step_condition condition(long depth, long parts);
    step_term step(long depth);
    step_term operand(long depth);

    choices& next_;
    std::vector<step_term> leaves_;
    std::string half_turn_;
};

}  // namespace libration::attack
