// Eigenvalues of wells in closed form: oscillators, sech^2, Morse's and Coulomb's wells, boxes, and polynomial wells of a known ground
// state, with one or two minima.
#include <fmt/core.h>

#include <array>
#include <vector>

#include "attack/question.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/query/well/eigenvalues.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

struct asked_well {
    std::string equation;
    std::string ends;
    std::vector<truth> values;  // the first ones
    bool all = false;           // and there are no others
};

std::string written(const rational& q) { return fmt::format("({}/{})", numerator(q).str(), denominator(q).str()); }

rational positive(choices& next) { return {next.between(1, 9), next.between(1, 4)}; }
rational any_fraction(choices& next) { return {next.between(-9, 9), next.between(1, 4)}; }

truth exact_value(const rational& q) {
    return [q] { return mpfr(q); };
}

const char* const whole_line = "psi(-inf) = 0; psi(inf) = 0";

// c psi'' = (k^2 (x - b)^2 + d - E) psi on the line, or on a half of it: d + k sqrt(c) (2 n + 1), c a square.
asked_well of_oscillator(choices& next) {
    const rational k = positive(next);
    const rational b = any_fraction(next);
    const rational d = any_fraction(next);
    const long r = next.between(1, 3);
    const long part = next.between(0, 2);  // the line, odd ones, even ones
    asked_well asked{fmt::format("{}*psi'' = ({}^2*(x-{})^2 + {} - E)*psi", r * r, written(k), written(b), written(d)),
                     part == 0   ? whole_line
                     : part == 1 ? fmt::format("psi({0}) = 0; psi({1}) = 0", b.str(), next.one_in(2) ? "inf" : "-inf")
                                 : fmt::format("psi'({0}) = 0; psi({1}) = 0", b.str(), next.one_in(2) ? "inf" : "-inf"),
                     {}};
    for (long n = 0; n < 3; ++n) {
        const long index = part == 0 ? n : part == 1 ? 2 * n + 1 : 2 * n;
        asked.values.push_back(exact_value(rational(d + k * r * (2 * index + 1))));
    }
    return asked;
}

// -l (l + 1) r^2 sech(r x)^2: -r^2 (l - n)^2 for n < l, all of them.
asked_well of_sech(choices& next) {
    const rational l(next.between(2, 13), 4);
    const rational r = positive(next);
    asked_well asked{
        fmt::format("psi'' = (-{}*{}^2*sech({}*x)^2 - E)*psi", written(rational(l * (l + 1))), written(r), written(r)),
        whole_line,
        {},
        denominator(l) != 1};  // for an integer l the last one is at the continuous spectrum
    for (rational rest = l; rest > 0; rest -= 1) {
        asked.values.push_back(exact_value(rational(-r * r * rest * rest)));
    }
    return asked;
}

// r^2 (exp(-2 r x) - 2 a exp(-r x)): -r^2 (a - n - 1/2)^2 for n < a - 1/2, all of them.
asked_well of_morse(choices& next) {
    const rational a(next.between(4, 14), 4);
    const rational r = positive(next);
    asked_well asked{fmt::format("psi'' = ({0}^2*(exp(-2*{0}*x) - 2*{1}*exp(-{0}*x)) - E)*psi", written(r), written(a)),
                     whole_line,
                     {},
                     denominator(rational(2 * a)) != 1};
    for (rational rest = a - rational(1, 2); rest > 0; rest -= 1) {
        asked.values.push_back(exact_value(rational(-r * r * rest * rest)));
    }
    return asked;
}

// l (l + 1)/x^2 - 2 z/x: -z^2/(n + l + 1)^2; l (l + 1)/x^2 + k^2 x^2: k (4 n + 2 l + 3).
asked_well of_radial(choices& next) {
    const rational z = positive(next);
    const bool coulomb = next.one_in(2);
    const rational l(next.between(coulomb ? 0 : 1, 4), 2);
    const std::string wall = l == 0 ? "" : fmt::format("{}/x^2 + ", written(rational(l * (l + 1))));
    asked_well asked{coulomb ? fmt::format("psi'' = ({}(-2)*{}/x - E)*psi", wall, written(z))
                             : fmt::format("psi'' = ({}{}^2*x^2 - E)*psi", wall, written(z)),
                     "psi(0) = 0; psi(inf) = 0",
                     {}};
    for (long n = 0; n < 2; ++n) {
        const rational level = n + l + 1;
        asked.values.push_back(
            exact_value(coulomb ? rational(-z * z / (level * level)) : rational(z * (4 * n + 2 * l + 3))));
    }
    return asked;
}

// psi = exp(-int W): V = W^2 - W' + d has the ground state d, where W is of odd degree with a positive leading coefficient.
asked_well of_superpotential(choices& next) {
    const std::array<long, 4> w{next.between(-3, 3), next.between(-4, 4), next.between(-2, 2), next.between(1, 2)};
    const rational d = any_fraction(next);
    return {fmt::format("psi'' = ((({0})+({1})*x+({2})*x^2+{3}*x^3)^2 - (({1})+2*({2})*x+3*{3}*x^2) + {4} - E)*psi",
                        w[0], w[1], w[2], w[3], written(d)),
            whole_line,
            {exact_value(d)}};
}

// The same with W = sign(x) w(|x|), w(0) = 0, so that psi' = 0 at 0: V = w^2 - w' + d in |x|.
asked_well of_mirrored(choices& next) {
    const std::array<long, 3> w{next.between(-4, 4), next.between(-2, 2), next.between(1, 2)};
    const rational d = any_fraction(next);
    const char* const y = next.one_in(2) ? "abs(x)" : "max(x, -x)";
    return {fmt::format("psi'' = ((({0})*{4}+({1})*x^2+{2}*{4}^3)^2 - (({0})+2*({1})*{4}+3*{2}*x^2) + {3} - E)*psi",
                        w[0], w[1], w[2], written(d), y),
            whole_line,
            {exact_value(d)}};
}

// d between walls at a and b: d + ((n + 1) pi/(b - a))^2.
asked_well of_box(choices& next) {
    const rational a = any_fraction(next);
    const rational length = positive(next);
    const rational d = any_fraction(next);
    asked_well asked{fmt::format("psi'' = ({} - E)*psi", written(d)),
                     fmt::format("psi({}) = 0; psi({}) = 0", a.str(), rational(a + length).str()),
                     {}};
    for (long n = 1; n < 4; ++n) {
        asked.values.push_back([=] {
            const mpfr k = mpfr(n) * pi_value() / mpfr(length);
            return mpfr(mpfr(d) + k * k);
        });
    }
    return asked;
}

asked_well any_well(choices& next) {
    switch (next.below(8)) {
        case 0: return of_oscillator(next);
        case 1: return of_sech(next);
        case 2: return of_morse(next);
        case 3: return of_radial(next);
        case 4: return of_box(next);
        case 5: return of_mirrored(next);
        default: return of_superpotential(next);
    }
}

}  // namespace

outcome ask_eigenvalue(choices& next) {
    const asked_well asked = any_well(next);
    const long digits = next.between(1, 40);
    const auto known = static_cast<long>(asked.values.size());
    const long count = asked.all ? known + 1 : next.between(1, known);
    const std::string text = asked.equation + "; " + asked.ends;
    const std::string command =
        fmt::format("libration find --eigenvalue E --problem \"{}\" --count {} --digits {}", text, count, digits);
    return answered(command, [&](outcome& result) {
        const ode::separated_text separated = ode::with_limits_separated(text);
        ode::eigenvalue_question question{
            ode::changed(ode::parse(separated.problem), "E = 1"), "E", {}, count, {}, digits};
        for (const std::string& each : separated.limits) {
            question.limits.push_back(ode::parse_limit(question.system, each));
        }
        const auto found = ode::proved_eigenvalues(question, [](const ball&, long) { require_time_left(); });
        for (const auto& each : found.values) {
            const std::string name = fmt::format("E_{}", each.index);
            if (each.index >= known) {
                result.add(verdict::wrong, name + " does not exist");
                continue;
            }
            add_number(result, each.value, digits, asked.values[static_cast<std::size_t>(each.index)], name);
        }
        if (found.missing) {
            const bool first = static_cast<long>(found.values.size()) < known;
            result.add(first ? verdict::refused : verdict::right, found.missing->what());
        }
    });
}

}  // namespace libration::attack
