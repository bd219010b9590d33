// Sets on which an enclosure may break down: single points, sets that hold an equilibrium, on which the equations or
// their polynomial form are singular, of 1e+-300, or from which some solutions do not reach the time asked.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "attack/facts.hpp"
#include "attack/program.hpp"
#include "attack/question.hpp"

namespace libration::attack {

namespace {

// Of an equation whose solutions are monotone in x(0).
struct degenerate_set {
    std::string equation;      ///< and its constants
    std::string lower, upper;  ///< of x(0), as typed
    std::string time;
    /// The sign of b minus the value at the time of the solution from the lower (-1) or the upper (1) end; empty if that
    /// solution, or one between, does not exist or is not the only one there: then there is nothing to prove.
    std::function<int(const rational& b, int end)> sign = {};
    /// Up to which all solutions exist.
    std::optional<truth> end = {};
};

std::string positive_decimal(choices& next) {
    return fmt::format("{}.{:03}", next.between(0, 2), next.between(1, 999));
}

truth typed_number(const std::string& decimal) {
    return [exact = typed_fraction(decimal)] { return real(exact); };
}

// By the value itself.
std::function<int(const rational&, int)> by_value(const std::function<mpfr(const mpfr&)>& value, const truth& lower,
                                                  const truth& upper) {
    return [=](const rational& b, int end) {
        return sign_of([&] { return mpfr(real(b) - value(end < 0 ? lower() : upper())); });
    };
}

// From [c, c] or c +- 0: decay and a blow-up.
degenerate_set any_point(choices& next) {
    const std::string c = positive_decimal(next);
    const std::string t = positive_decimal(next);
    const truth time = typed_number(t);
    switch (next.below(3)) {
        case 0:
            return {"x' = -x", c, c, t,
                    by_value([=](const mpfr& x) { return mpfr(x * exp(mpfr(-time()))); }, typed_number(c),
                             typed_number(c))};
        case 1:
            return {"x' = -x^3/2", c, c, t,
                    by_value([=](const mpfr& x) { return mpfr(x / sqrt(mpfr(1 + x * x * time()))); }, typed_number(c),
                             typed_number(c))};
        default: {
            degenerate_set found{"x' = x^2", c, c, t, {}, [c] { return mpfr(1 / typed_number(c)()); }};
            if (typed_fraction(c) * typed_fraction(t) < 1) {
                found.sign = by_value([=](const mpfr& x) { return mpfr(x / (1 - x * time())); }, typed_number(c),
                                      typed_number(c));
            }
            return found;
        }
    }
}

// An equilibrium at an end of the set or within it.
degenerate_set any_equilibrium(choices& next) {
    const std::string c = next.one_in(3) ? "0" : "-" + positive_decimal(next);
    const std::string d = next.one_in(4) && c != "0" ? "0" : positive_decimal(next);
    const std::string t = positive_decimal(next);
    const truth time = typed_number(t);
    const auto value = [&](const std::function<mpfr(const mpfr&)>& of) {
        return by_value(of, typed_number(c), typed_number(d));
    };
    switch (next.below(4)) {
        case 0: return {"x' = -x", c, d, t, value([=](const mpfr& x) { return mpfr(x * exp(mpfr(-time()))); })};
        case 1:
            return {"x' = -x^3/2", c, d, t,
                    value([=](const mpfr& x) { return mpfr(x / sqrt(mpfr(1 + x * x * time()))); })};
        case 2: {
            const std::string e = fmt::format("0.{:03}", next.between(500, 999));
            const std::string f = fmt::format("1.{:03}", next.between(0, 300));
            return {"x' = x*(1 - x)", e, f, t,
                    by_value([=](const mpfr& x) { return mpfr(x / (x + (1 - x) * exp(mpfr(-time())))); },
                             typed_number(e), typed_number(f))};
        }
        default: {
            degenerate_set found{"x' = x^2", c, d, t, {}};
            if (typed_fraction(d) > 0) {
                found.end = [d] { return mpfr(1 / typed_number(d)()); };
            }
            if (typed_fraction(d) * typed_fraction(t) < 1) {
                found.sign = value([=](const mpfr& x) { return mpfr(x / (1 - x * time())); });
            }
            return found;
        }
    }
}

// Equations that have no solution, or several, from a point of the set; or poles of the right-hand side beside the real
// axis, where there is one from each point: H(x(t)) = H(x(0)) + t for an increasing H.
degenerate_set set_around_singularity(choices& next) {
    const std::string c = "-" + positive_decimal(next);
    const std::string d = positive_decimal(next);
    const std::string t = positive_decimal(next);
    const std::vector<std::string> slopes = {
        "1/x",      "sqrt(x)",    "log(x)", "x^(1/3)",     "cbrt(x)",      "sqrt(x)/2",       "1/sqrt(x)",
        "x*log(x)", "sin(x)/x^2", "-1/x",   "1/(x + x^2)", "x^(-1/2) - 1", "a/x; a = [1, 2]", "a*sqrt(x); a = [0, 1]"};
    const rational square(1, next.between(2, 400));
    const auto implicit = [=](const std::function<mpfr(const mpfr&)>& h) {
        return [=](const rational& b, int end) {
            return sign_of([&] { return mpfr(h(real(b)) - h(typed_number(end < 0 ? c : d)()) - typed_number(t)()); });
        };
    };
    switch (next.below(3)) {
        case 0: {
            const auto h = [=](const mpfr& x) { return mpfr(x * x * x / 3 + x * real(square)); };
            return {"x' = 1/(x^2 + " + square.str() + ")", c, d, t, implicit(h)};
        }
        case 1: {
            // x^2/2 + s log |x| = .. - t keeps the sign of x; of a bound of the other sign nothing is left to judge.
            const auto h = [=](const mpfr& x) { return mpfr(-x * x / 2 - real(square) * log(abs(x))); };
            return {"x' = -x/(x^2 + " + square.str() + ")", c, d, t,
                    [=](const rational& b, int end) { return b * end <= 0 ? -end : -end * implicit(h)(b, end); }};
        }
        default: return {"x' = " + slopes[next.below(slopes.size())], next.one_in(3) ? "0" : c, d, t};
    }
}

// Numbers of 1e+-300.
degenerate_set any_scaled(choices& next) {
    const long p = next.one_in(2) ? 300 : -300;
    const std::string c = fmt::format("{}e{}", next.between(1, 9), p);
    const std::string d = fmt::format("{}e{}", next.between(10, 19), p);
    const std::string t = positive_decimal(next);
    const truth time = typed_number(t);
    if (next.one_in(2)) {
        const std::string low = next.one_in(2) ? "-" + d : c;
        return {
            "x' = -x", low, d, t,
            by_value([=](const mpfr& x) { return mpfr(x * exp(mpfr(-time()))); }, typed_number(low), typed_number(d))};
    }
    const std::string rate = fmt::format("1e{}", -p);
    return {"x' = -a*x^2; a = " + rate, c, d, t,
            by_value([=](const mpfr& x) { return mpfr(x / (1 + typed_number(rate)() * x * time())); }, typed_number(c),
                     typed_number(d))};
}

// Some solutions end before the time, or the bounds hold.
degenerate_set any_blow_up(choices& next) {
    const std::string c = positive_decimal(next);
    const std::string d = (typed_fraction(c) + rational(next.between(1, 100), 100)).str();
    const std::string t = positive_decimal(next);
    const truth upper = [q = rational(d)] { return real(q); };
    degenerate_set found{"x' = x^2", c, d, t, {}, [=] { return mpfr(1 / upper()); }};
    if (rational(d) * typed_fraction(t) < 1) {
        found.sign =
            by_value([=](const mpfr& x) { return mpfr(x / (1 - x * typed_number(t)())); }, typed_number(c), upper);
    }
    return found;
}

degenerate_set any_set(choices& next) {
    switch (next.below(5)) {
        case 0: return any_point(next);
        case 1: return any_equilibrium(next);
        case 2: return any_scaled(next);
        case 3: return any_blow_up(next);
        default: return set_around_singularity(next);
    }
}

// A refusal states nothing false.
void add_refusal(outcome& result, const degenerate_set& set, const std::string& message) {
    const refusal_facts facts = facts_of(message);
    const bool one_line = std::ranges::count(message, '\n') <= 2;  // and the number of parts
    const bool exists = !facts.exists_up_to || !set.end ||
                        sign_of([&] { return mpfr((*set.end)() - typed_number(*facts.exists_up_to)()); }) >= 0;
    result.add(one_line && exists ? verdict::refused : verdict::wrong, message);
}

void add_bound(outcome& result, const degenerate_set& set, const std::string& bound, int end) {
    const bool right = set.sign && set.sign(typed_fraction(bound), end) * end >= 0;
    result.add(right ? verdict::right : verdict::wrong,
               fmt::format("the {} bound {}", end < 0 ? "lower" : "upper", bound));
}

}  // namespace

outcome ask_degenerate_set(choices& next) {
    const degenerate_set set = any_set(next);
    const std::string start =
        set.lower == set.upper && next.one_in(2) ? set.lower + " +- 0" : fmt::format("[{}, {}]", set.lower, set.upper);
    const std::string parts = next.one_in(2) ? fmt::format(" --parts {}", next.between(1, 9)) : "";
    const std::string text = fmt::format("{}; x(0) = {}", set.equation, start);
    // The last column of values: of a time or of a span that ends in it, or of events beyond all solutions.
    const std::size_t way = next.below(5);
    const bool over = way == 1;
    const bool until = way == 2 && !set.sign && !set.end;
    const std::string when = until
                                 ? " --until \"x = 1000\" --before " + set.time + (next.one_in(2) ? " --how-many" : "")
                             : over ? fmt::format(" --over {0}:{0}", set.time)
                                    : " --time " + set.time;
    outcome result;
    result.command =
        announce(fmt::format("libration reference --problem \"{}\"{}{} --timeout 5", text, when, until ? "" : parts));
    const auto answer = answer_of(result.command + " --format csv");
    if (!answer.done) {
        add_refusal(result, set, answer.message);
        return result;
    }
    if (until) {
        result.add(verdict::wrong, "an answer about solutions that do not all exist");
        return result;
    }
    for (const std::string& line : answer.lines) {
        if (cell_of(line, over ? 2 : 1) == "x") {
            add_bound(result, set, cell_of(line, over ? 3 : 2), -1);
            add_bound(result, set, cell_of(line, over ? 4 : 3), 1);
        }
    }
    return result;
}

}  // namespace libration::attack
