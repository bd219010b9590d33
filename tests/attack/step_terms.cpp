#include "attack/step_terms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace libration::attack {

namespace {

rational floor_of_fraction(const rational& q) {
    const integer above = numerator(q);
    const integer below = denominator(q);
    integer whole = above / below;  // towards 0
    if (whole * below > above) {
        --whole;
    }
    return whole;
}

void add_inside(partition& ends, const rational& time) {
    if (*ends.begin() < time && time < *ends.rbegin()) {
        ends.insert(time);
    }
}

// Adds the times at which u is a multiple of `unit`, or 0 if that is 0.
void add_crossings(partition& ends, const std::function<line(const rational&)>& u, const rational& unit = 0) {
    const std::vector<rational> old(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < old.size(); ++i) {
        const line here = u((old[i] + old[i + 1]) / 2);
        if (here.slope == 0) {
            continue;
        }
        const rational least = std::min(here.at(old[i]), here.at(old[i + 1]));
        const rational most = std::max(here.at(old[i]), here.at(old[i + 1]));
        rational level = unit == 0 ? rational(0) : rational(floor_of_fraction(least / unit) * unit);
        for (; level <= most; level += unit) {
            if (level > least && level < most) {
                ends.insert((level - here.constant) / here.slope);
            }
            if (unit == 0) {
                break;
            }
        }
    }
}

line difference(const line& a, const line& b) { return {a.constant - b.constant, a.slope - b.slope}; }

// A term f(u) whose pieces end where u is a multiple of `unit`.
step_term function_of(const std::string& text, const step_term& u, const rational& unit,
                      const std::function<line(const line& u, const rational& inside)>& f, bool is_step) {
    return {text, [=](const rational& inside) { return f(u.near(inside), inside); },
            [=](partition& ends) {
                u.divide(ends);
                add_crossings(ends, u.near, unit);
            },
            is_step};
}

}  // namespace

std::string any_relation(choices& next) {
    static constexpr std::array<const char*, 6> relations{">", ">=", "<", "<=", "==", "!="};
    return relations[next.below(relations.size())];
}

bool holds(const std::string& relation, int sign) {
    if (relation == "==" || relation == "!=") {
        return (sign == 0) == (relation == "==");
    }
    if (sign == 0) {
        return relation.size() == 2;  // >= and <=
    }
    return (sign > 0) == (relation[0] == '>');
}

std::string as_typed(const rational& q) {
    const std::string text = q.str();
    return q.sign() < 0 || denominator(q) != 1 ? "(" + text + ")" : text;
}

step_term constant_term(const std::string& text, const rational& value) {
    return {text, [=](const rational&) { return line{value, 0}; }, [](partition&) {}, true};
}

step_term linear_term(const std::string& text, const line& value) {
    return {text, [=](const rational&) { return value; }, [](partition&) {}, value.slope == 0};
}

step_term bent_term(const std::string& text, const line& before, const rational& time, const line& after) {
    return {text, [=](const rational& inside) { return inside < time ? before : after; },
            [=](partition& ends) { add_inside(ends, time); }, before.slope == 0 && after.slope == 0};
}

step_term sum(const step_term& a, const step_term& b) {
    return {fmt::format("({} + {})", a.text, b.text),
            [=](const rational& inside) {
                const line u = a.near(inside);
                const line v = b.near(inside);
                return line{u.constant + v.constant, u.slope + v.slope};
            },
            [=](partition& ends) {
                a.divide(ends);
                b.divide(ends);
            },
            a.is_step && b.is_step};
}

step_term product(const step_term& a, const step_term& b) {
    return {fmt::format("{}*{}", a.text, b.text),
            [=](const rational& inside) {
                const line u = a.near(inside);
                const line v = b.near(inside);
                return line{u.constant * v.constant, u.constant * v.slope + u.slope * v.constant};
            },
            [=](partition& ends) {
                a.divide(ends);
                b.divide(ends);
            },
            a.is_step && b.is_step};
}

step_term absolute(const step_term& u) {
    return function_of(
        fmt::format("abs({})", u.text), u, 0,
        [](const line& at, const rational& inside) { return at.at(inside) < 0 ? difference({}, at) : at; }, u.is_step);
}

step_term sign_of_term(const step_term& u) {
    return function_of(
        fmt::format("sign({})", u.text), u, 0,
        [](const line& at, const rational& inside) {
            return line{at.at(inside).sign(), 0};
        },
        true);
}

step_term heaviside(const step_term& u) {
    return function_of(
        fmt::format("heaviside({})", u.text), u, 0,
        [](const line& at, const rational& inside) {
            return line{rational(1 + at.at(inside).sign(), 2), 0};
        },
        true);
}

step_term floor_of(const step_term& u, const rational& divisor) {
    const std::string text =
        divisor == 1 ? fmt::format("floor({})", u.text) : fmt::format("floor(({})/{})", u.text, as_typed(divisor));
    return function_of(
        text, u, divisor,
        [=](const line& at, const rational& inside) {
            return line{floor_of_fraction(at.at(inside) / divisor), 0};
        },
        true);
}

step_term extreme(bool largest, const step_term& u, const step_term& v) {
    const auto apart = [=](const rational& inside) { return difference(u.near(inside), v.near(inside)); };
    return {fmt::format("{}({}, {})", largest ? "max" : "min", u.text, v.text),
            [=](const rational& inside) {
                const bool above = apart(inside).at(inside) > 0;
                return above == largest ? u.near(inside) : v.near(inside);
            },
            [=](partition& ends) {
                u.divide(ends);
                v.divide(ends);
                add_crossings(ends, apart);
            },
            u.is_step && v.is_step};
}

step_condition comparison(const step_term& u, const std::string& relation, const step_term& v) {
    const auto apart = [=](const rational& inside) { return difference(u.near(inside), v.near(inside)); };
    return {fmt::format("{} {} {}", u.text, relation, v.text),
            [=](const rational& inside) { return holds(relation, apart(inside).at(inside).sign()); },
            [=](partition& ends) {
                u.divide(ends);
                v.divide(ends);
                add_crossings(ends, apart);
            }};
}

step_condition combined(bool all, const step_condition& p, const step_condition& q, choices& next) {
    const auto divide = [=](partition& ends) {
        p.divide(ends);
        q.divide(ends);
    };
    const std::string word = all ? "and" : "or";
    const std::string text = next.one_in(3) ? fmt::format("{}({}, {})", word, p.text, q.text)
                                            : fmt::format("({}) {} ({})", p.text,
                                                          next.one_in(2) ? word
                                                          : all          ? "&&"
                                                                         : "||",
                                                          q.text);
    return {text,
            [=](const rational& inside) {
                return all ? p.holds(inside) && q.holds(inside) : p.holds(inside) || q.holds(inside);
            },
            divide};
}

step_condition opposite(const step_condition& of, choices& next) {
    return {fmt::format("{}({})", next.one_in(2) ? "not " : "!", of.text),
            [=](const rational& inside) { return !of.holds(inside); }, of.divide};
}

step_term conditional(const step_condition& condition, const step_term& p, const step_term& q) {
    return {fmt::format("if({}, {}, {})", condition.text, p.text, q.text),
            [=](const rational& inside) { return condition.holds(inside) ? p.near(inside) : q.near(inside); },
            [=](partition& ends) {
                condition.divide(ends);
                p.divide(ends);
                q.divide(ends);
            },
            p.is_step && q.is_step};
}

namespace {

rational whole(const std::string& name, const rational& x) {
    const rational half(1, 2);
    if (name == "ceil") {
        return -floor_of_fraction(-x);
    }
    if (name == "trunc") {
        return x < 0 ? rational(-floor_of_fraction(-x)) : floor_of_fraction(x);
    }
    if (name == "round") {
        return x < 0 ? rational(-floor_of_fraction(half - x)) : floor_of_fraction(x + half);
    }
    const rational up = floor_of_fraction(x + half);
    const bool odd = up - 2 * floor_of_fraction(up / 2) != 0;
    return up - half == x && odd ? rational(up - 1) : up;
}

}  // namespace

step_term whole_of(const std::string& name, const step_term& u) {
    return function_of(
        fmt::format("{}({})", name, u.text), u, rational(1, 2),
        [=](const line& at, const rational& inside) {
            return line{whole(name, at.at(inside)), 0};
        },
        true);
}

step_term remainder_of(const std::string& name, const step_term& u, const rational& k) {
    return function_of(
        fmt::format("{}({}, {})", name, u.text, as_typed(k)), u, k / 2,
        [=](const line& at, const rational& inside) {
            const rational quotient = at.at(inside) / k;
            const rational n =
                name == "mod" ? floor_of_fraction(quotient) : whole(name == "fmod" ? "trunc" : "rint", quotient);
            return line{at.constant - k * n, at.slope};
        },
        u.is_step);
}

step_term square_wave(const step_term& u, const std::string& argument) {
    return function_of(
        fmt::format("square({})", argument), u, 1,
        [](const line& at, const rational& inside) {
            const rational half = floor_of_fraction(at.at(inside) / 2) * 2;
            return line{at.at(inside) - half < 1 ? 1 : -1, 0};
        },
        true);
}

step_term sawtooth_wave(const step_term& u, const std::string& argument) {
    return function_of(
        fmt::format("sawtooth({})", argument), u, 2,
        [](const line& at, const rational& inside) {
            const rational turns = floor_of_fraction(at.at(inside) / 2) * 2;
            return line{at.constant - turns - 1, at.slope};
        },
        false);
}

rational integral(const step_term& of, const rational& from, const rational& to) {
    if (to <= from) {
        return 0;
    }
    partition ends{from, to};
    of.divide(ends);
    rational result = 0;
    for (auto right = std::next(ends.begin()); right != ends.end(); ++right) {
        const rational& left = *std::prev(right);
        const rational middle = (left + *right) / 2;
        result += of.near(middle).at(middle) * (*right - left);
    }
    return result;
}

rational term_choices::level() {
    const long below = next_.one_in(4) ? 3 : next_.between(1, 2);
    return {next_.between(-2 * below, 4 * below), below};
}

step_term term_choices::leaf() {
    const step_term& variable = leaves_[next_.below(leaves_.size())];
    switch (next_.below(4)) {
        case 0: return variable;
        case 1:
            return sum(product(number_term(rational(next_.one_in(2) ? -1 : next_.between(1, 3))), variable),
                       number_term(level()));
        default: return sum(variable, number_term(-level()));
    }
}

step_term term_choices::operand(long depth) { return depth <= 0 || next_.one_in(5) ? leaf() : any(depth - 1); }

// Of at most so many comparisons.
step_condition term_choices::condition(long depth, long parts) {
    if (parts > 1 && next_.one_in(2)) {
        const bool all = next_.one_in(2);
        const step_condition p = condition(depth - 1, parts / 2);
        const step_condition q = condition(depth - 1, parts / 2);
        return combined(all, p, q, next_);
    }
    if (next_.one_in(6)) {
        return opposite(condition(depth, 1), next_);
    }
    const step_term u = operand(depth);
    const step_term v = next_.one_in(3) ? operand(depth) : number_term(level());
    return comparison(u, any_relation(next_), v);
}

step_term term_choices::chosen(long depth) {
    const step_condition holds = condition(depth, 4);
    const step_term p = next_.one_in(3) ? operand(depth - 1) : number_term(next_.between(-2, 5));
    const step_term q = next_.one_in(3) ? operand(depth - 1) : number_term(next_.between(-2, 5));
    return conditional(holds, p, q);
}

// A term that is constant on its pieces.
step_term term_choices::step(long depth) {
    static constexpr std::array<const char*, 4> whole_numbers{"ceil", "trunc", "round", "rint"};
    switch (next_.below(5)) {
        case 0: return sign_of_term(operand(depth));
        case 1: return heaviside(operand(depth));
        case 3: return whole_of(whole_numbers[next_.below(whole_numbers.size())], operand(depth));
        case 2: return floor_of(operand(depth), next_.one_in(3) ? rational(next_.between(1, 4), 2) : rational(1));
        default: {
            const step_term u = operand(depth);
            return conditional(u, next_.one_in(2) ? ">" : ">=", number_term(level()), number_term(next_.between(-2, 3)),
                               number_term(next_.between(-2, 3)));
        }
    }
}

step_term term_choices::against_steps(long depth) {
    const step_term& time = leaves_.front();
    const step_term steps = step(depth - 1);
    const step_term apart = sum(time, product(number_term(next_.one_in(2) ? -1 : next_.between(1, 3)), steps));
    switch (next_.below(6)) {
        case 0: return extreme(next_.one_in(2), time, steps);
        case 1: return floor_of(apart, 1);
        case 2: return absolute(apart);
        case 3: return product(sign_of_term(apart), leaf());
        default:
            return conditional(time, any_relation(next_), steps, number_term(next_.between(-2, 5)),
                               number_term(next_.between(-2, 5)));
    }
}

step_term term_choices::any(long depth) {
    if (depth <= 0) {
        return leaf();
    }
    static constexpr std::array<const char*, 3> remainders{"mod", "fmod", "remainder"};
    switch (next_.below(12)) {
        case 0:
        case 1: return absolute(operand(depth));
        case 8:
            return remainder_of(remainders[next_.below(remainders.size())], operand(depth),
                                rational(next_.between(1, 4), next_.between(1, 2)));
        case 2: return extreme(next_.one_in(2), operand(depth), operand(depth));
        case 3: return extreme(next_.one_in(2), operand(depth), number_term(level()));
        case 4: return sum(operand(depth), product(number_term(next_.between(-2, 2)), step(depth)));
        case 5: return product(step(depth), operand(depth));
        case 6:
            if (!half_turn_.empty()) {
                const step_term& time = leaves_.front();
                return next_.one_in(2) ? square_wave(time, half_turn_) : sawtooth_wave(time, half_turn_);
            }
            return step(depth);
        case 7: return step(depth);
        default: return chosen(depth);
    }
}

}  // namespace libration::attack
