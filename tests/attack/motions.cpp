// Random motions, times and digits, each printed digit checked by an independent route (motion_route.hpp).
//
// Energies 10^-300 .. 10^300, gaps 10^-300 .. 1 on both sides of E = 2, initial states (theta0, omega0), Jacobi's
// functions with m or 1-m down to 10^-300, and at complex arguments with any real m, 10^-300 .. 10^300; times 10^-10 ..
// 10^300 and fractions of T; 1 to 300 digits.
#include "attack/motions.hpp"

#include <fmt/core.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "attack/complex_route.hpp"
#include "attack/motion_route.hpp"
#include "corner_numbers.hpp"
#include "libration/elliptic/digits_enclosure.hpp"
#include "libration/elliptic/elliptic.hpp"
#include "libration/elliptic/function_condition.hpp"
#include "libration/elliptic/named_function.hpp"
#include "libration/elliptic/proved_functions.hpp"
#include "libration/elliptic/theta_values.hpp"
#include "libration/pendulum/proved_states.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "table/elliptic_values.hpp"

namespace libration::attack {

namespace {

using namespace libration::pendulum;
using namespace libration::tests;

// Random numbers as they are typed.
class typed_numbers {
public:
    explicit typed_numbers(unsigned long seed) : corners_(seed) {}

    long below(long n) { return corners_.between(0, n - 1); }
    long between(long least, long most) { return least + below(most - least + 1); }
    /// D.DDDDe+N with an exponent in a range; half of the time D.D..D is a corner case.
    std::string number(long least, long most) {
        const std::string digits = corners_.half([&] { return corners_.decimal(); },
                                                 [&] { return fmt::format("{}.{:04}", between(1, 9), below(10000)); });
        return fmt::format("{}e{}", digits, between(least, most));
    }
    /// A random number of digits; small ones are more frequent.
    long digits() { return between(1, between(1, 300)); }

private:
    corner_numbers corners_;
};

rational fraction_of(const std::string& text) { return read_exact(text).coefficient; }

/// A value as it was printed, and its description.
struct printed_value {
    std::string what;
    std::string text;
};

// Whether a decimal is less than one unit of its last digit away from all of the ball; std::nullopt if undecided.
std::optional<bool> is_right(const std::string& text, const ball& truth, long digits) {
    if (text == "0") {
        return contains_zero(truth) ? std::optional(certainly_less(abs(truth), pow(ball(10), -digits - 100)))
                                    : std::optional(false);
    }
    const auto parts = parts_of(from_exact<mpfr>(read_exact(text)), digits, MPFR_RNDN);
    const ball error = abs(ball(truth - from_rational<ball>(fraction_of(text))));
    if (certainly_less(error, parts.unit())) {
        return true;
    }
    return certainly_less(parts.unit(), error) ? std::optional(false) : std::nullopt;
}

// The number of wrong values compared with the true ones that `route` computes in increasing precision.
template <class Route>
int wrong_ones(const std::vector<printed_value>& values, long digits, const Route& route) {
    for (long more = 60; more <= 20000; more *= 2) {
        const precision_scope scope(digits + more);
        const std::vector<ball> truths = route();
        int wrong = 0;
        bool open = false;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto right = is_right(values[i].text, truths[i], digits);
            open = open || !right;
            if (right && !*right) {
                fmt::print(stderr, "wrong: {} is {}\n", values[i].what, values[i].text);
                ++wrong;
            }
        }
        if (!open || wrong > 0) {
            return wrong;
        }
    }
    fmt::print(stderr, "open: {}\n", values.front().what);
    return static_cast<int>(values.size());
}

struct question {
    rational energy;
    rational gap;
    std::string named;
    std::string time;
    long digits;
};

question ask_from_top(typed_numbers& next) {
    question q;
    if (next.below(2) == 0) {
        q.named = next.number(-300, 300);
        q.energy = fraction_of(q.named);
        q.gap = 2 - q.energy;
        q.named = "--energy " + q.named;
    } else {
        const int sign = next.below(2) == 0 ? 1 : -1;
        const std::string size = next.number(-300, -1);
        q.gap = sign * fraction_of(size);
        q.energy = 2 - q.gap;
        q.named = std::string("--gap ") + (sign < 0 ? "-" : "") + size;
    }
    q.time = next.below(5) == 0 ? fmt::format("{}T/{}", next.between(1, 99), next.between(1, 16))
                                : next.number(-10, next.below(4) == 0 ? 300 : 20);
    q.digits = next.digits();
    return q;
}

int attack_from_top(typed_numbers& next, std::string& what) {
    const question q = ask_from_top(next);
    const motion m = motion::of_energy(q.energy);
    const exact time = read_exact(q.time);
    what = fmt::format("{} --time {} --digits {}", q.named, q.time, q.digits);
    proved_states states(m, q.digits);
    const auto printed = states.at(time);
    return wrong_ones({{"theta of " + what, printed.theta}, {"omega of " + what, printed.omega}}, q.digits, [&] {
        const precision_scope wider(working_digits() + 700);  // t/T of times of 300 digits at E of 300
        const route_from_top route(q.energy, q.gap);
        const ball periods = time.has_periods() ? from_rational<ball>(time.coefficient)
                                                : from_rational<ball>(time.coefficient) / route.period();
        auto state = route.at(periods);
        return std::vector<ball>{std::move(state.theta), std::move(state.omega)};
    });
}

int attack_from_start(typed_numbers& next, std::string& what) {
    const std::string theta0 = next.number(-20, -1);
    const std::string omega0 = next.number(-20, -1);
    const std::string angle = (next.below(2) == 0 ? "-" : "") + theta0;
    const std::string time = next.number(-5, 30);
    const long digits = next.digits();
    const rational from = fraction_of(angle) * 3;
    const rational speed = fraction_of(omega0) * 3;
    const rational length = fraction_of(time);
    what = fmt::format("--theta0 3*({}) --omega0 3*{} --time {} --digits {}", angle, omega0, time, digits);
    proved_states states(motion::of_state(exactly(from), exactly(speed)), digits);
    const auto printed = states.at(exactly(length));
    return wrong_ones({{"theta of " + what, printed.theta}, {"omega of " + what, printed.omega}}, digits, [&] {
        const precision_scope wider(working_digits() + 150);
        auto state = route_from_start(from, speed, length);
        return std::vector<ball>{std::move(state.theta), std::move(state.omega)};
    });
}

int attack_functions(typed_numbers& next, std::string& what) {
    const bool complementary = next.below(2) == 0;
    const std::string number = next.number(-300, -1);
    const elliptic::given_modulus modulus =
        complementary ? elliptic::given_modulus{{}, {}, number} : elliptic::given_modulus{{}, number, {}};
    const std::string u = next.number(-10, next.below(4) == 0 ? 300 : 10);
    const long digits = next.digits();
    what = fmt::format("--u {} --{} {} --digits {}", u, complementary ? "m1" : "m", number, digits);
    return wrong_ones({{"sn " + what, proved::sn(u, modulus, digits).text},
                       {"cn " + what, proved::cn(u, modulus, digits).text},
                       {"dn " + what, proved::dn(u, modulus, digits).text},
                       {"K " + what, proved::K(modulus, digits).text}},
                      digits, [&] {
                          const precision_scope wider(working_digits() + 700);
                          const ball given = sqrt(from_rational<ball>(fraction_of(number)));
                          const ball other = sqrt(from_rational<ball>(rational(1 - fraction_of(number))));
                          const arb_jacobi route(complementary ? other : given, complementary ? given : other);
                          const ball cycle = route.period() * 4;
                          const ball argument = from_rational<ball>(fraction_of(u));
                          const integer whole = nearest_integer(argument / cycle);
                          const auto at = route(ball(argument - cycle * from_rational<ball>(rational(whole))));
                          return std::vector<ball>{at.sn, at.cn, at.dn, route.period()};
                      });
}

// m or 1 - m, of either sign: m below 0, within and above 1.
typed_parameter ask_parameter(typed_numbers& next) {
    const bool complementary = next.below(2) == 0;
    const long most = next.below(3) == 0 ? 300 : 2;
    const exact number = read_exact((next.below(2) == 0 ? "-" : "") + next.number(-most, most));
    return {number,
            complementary ? &elliptic::real_parameter::from_complement : &elliptic::real_parameter::from_parameter};
}

std::string ask_part(typed_numbers& next, long most) {
    const std::string size = next.number(-10, next.below(4) == 0 ? most : 2);
    return (next.below(2) == 0 ? "-" : "") + size;
}

// One of the twelve functions, in a quarter of the cases at a real argument.
int attack_complex(typed_numbers& next, std::string& what) {
    constexpr std::string_view letters = "scdn";
    const auto above = static_cast<std::size_t>(next.below(4));
    const std::size_t below = (above + static_cast<std::size_t>(next.between(1, 3))) % 4;
    const std::string name{letters[above], letters[below]};
    const typed_parameter parameter = ask_parameter(next);
    const auto given = parameter.value();
    // For m = 0 and 1 the functions grow exponentially.
    const long most = given.m().coefficient == 0 || given.complement().coefficient == 0 ? 3 : 40;
    const std::string x = ask_part(next, most);
    const std::string y = next.below(4) == 0 ? "" : ask_part(next, most);
    const long digits = next.digits();
    elliptic_point at{read_exact(x), parameter};
    at.imaginary = y.empty() ? std::nullopt : std::optional(read_exact(y));
    what = fmt::format("{} --u={}{} m {} or 1-m {} --digits {}", name, x, y.empty() ? "" : ", " + y, given.m().text,
                       given.complement().text, digits);
    const auto texts = texts_of(*elliptic::find_function(name), at, digits);
    return wrong_ones({{"real " + what, texts[0]}, {"imaginary " + what, texts[1]}}, digits, [&] {
        const precision_scope wider(working_digits() + 1200);
        const complex_route route(given.m().coefficient, given.complement().coefficient);
        const complex_ball value = route(name, fraction_of(x), y.empty() ? rational(0) : fraction_of(y));
        return std::vector<ball>{value.real(), value.imaginary()};
    });
}

struct tally {
    std::atomic<long> values{0};
    std::atomic<long> wrong{0};
};

void attack(long values, unsigned long seed, tally& all) {
    typed_numbers next(seed);
    while (all.values < values) {
        const long kind = next.below(11);
        std::string what;  // is asked
        try {
            all.wrong += kind < 6    ? attack_from_top(next, what)
                         : kind < 8  ? attack_from_start(next, what)
                         : kind < 10 ? attack_functions(next, what)
                                     : attack_complex(next, what);
        } catch (const std::exception& problem) {
            fmt::print(stderr, "refused: {}: {}\n", what, problem.what());
            ++all.wrong;
        }
        all.values += kind < 8 || kind == 10 ? 2 : 4;
    }
    flint_cleanup();
}

}  // namespace

int attack_motions(long values, unsigned long seed, long threads) {
    tally all;
    {
        std::vector<std::jthread> workers;
        const long cores = std::max(1L, static_cast<long>(std::thread::hardware_concurrency()));
        for (long i = 0; i < (threads > 0 ? threads : cores); ++i) {
            workers.emplace_back([&, i] { attack(values, seed * 1000 + static_cast<unsigned long>(i), all); });
        }
    }
    fmt::print("{} values, {} wrong or refused\n", all.values.load(), all.wrong.load());
    return all.wrong == 0 ? 0 : 1;
}

int print_motions(long values) {
    typed_numbers next(7);
    fmt::print("energy,time,digits,theta,omega\n");
    for (long i = 0; i < values; i += 2) {
        question q = ask_from_top(next);
        q.digits = 1 + q.digits % 60;
        const motion m = motion::of_energy(q.energy);
        const auto at = proved_states(m, q.digits).at(read_exact(q.time));
        fmt::print("{},{},{},{},{}\n", q.energy.str(), q.time, q.digits, at.theta, at.omega);
    }
    return 0;
}

}  // namespace libration::attack
