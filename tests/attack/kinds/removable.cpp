// Quotients with removable singularities, at and near the number where they are removed, by elementary integrals.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/states.hpp"

namespace libration::attack {

namespace {

// y' = text, in which {u} is an expression u with u' = rate, and {w} an unknown that is equal to u: the quotient is one
// of u, and the factor in w makes the integral from u0 elementary, over u.
struct removable_quotient {
    const char* text;
    mpfr (*primitive)(const mpfr& u);
    int least, most;  ///< u is between them, in tenths
};

const std::vector<removable_quotient>& removable_quotients() {
    static const std::vector<removable_quotient> all{
        {"sin({u})/({u})*{w}", [](const mpfr& u) { return mpfr(-cos(u)); }, -60, 60},
        {"({u})/(exp({u}) - 1)*(exp({w}) - 1)", [](const mpfr& u) { return mpfr(u * u / 2); }, -60, 60},
        {"{w}^2*(1 - cos({u}))/({u})^2", [](const mpfr& u) { return mpfr(u - sin(u)); }, -60, 60},
        {"(exp(2*({u})) - exp(-({u})/3))/({u})*{w}",
         [](const mpfr& u) { return mpfr(exp(mpfr(2 * u)) / 2 + 3 * exp(mpfr(-u / 3))); }, -30, 30},
        {"{w}/({u})*log(1 + {u})", [](const mpfr& u) { return mpfr((1 + u) * log(mpfr(1 + u)) - u); }, -8, 60},
        {"sin({w})*({u})/tan({u})", [](const mpfr& u) { return mpfr(u * sin(u) + cos(u)); }, -28, 28},
        {"tanh({u})/({u})*{w}", [](const mpfr& u) { return mpfr(log(cosh(u))); }, -60, 60},
        {"(sqrt(1 + {u}) - 1)/({u})*{w}", [](const mpfr& u) { return mpfr(2 * (1 + u) * sqrt(mpfr(1 + u)) / 3 - u); },
         -8, 60},
        {"({u})/log(1 + {u})*log(1 + {w})", [](const mpfr& u) { return mpfr(u * u / 2); }, -8, 60},
        {"(cosh({u})/sinh({u}) - 1/({u}))*{w}*sinh({w})", [](const mpfr& u) { return mpfr(u * sinh(u) - 2 * cosh(u)); },
         -28, 28},
        {"(1/sin({u}) - 1/({u}))*{w}*sin({w})", [](const mpfr& u) { return mpfr(u * u / 2 + cos(u)); }, -28, 28},
        {"sin({u})/sinh({u})*sinh({w})", [](const mpfr& u) { return mpfr(-cos(u)); }, -28, 28},
    };
    return all;
}

std::string with_expressions(std::string text, const std::string& u) {
    for (const auto& [name, by] : {std::pair<std::string, std::string>{"{u}", u}, {"{w}", "w"}}) {
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + by.size())) {
            text.replace(at, name.size(), by);
        }
    }
    return text;
}

}  // namespace

outcome ask_removable(choices& next) {
    const auto& all = removable_quotients();
    const removable_quotient& of = all[static_cast<std::size_t>(next.below(static_cast<int>(all.size())))];
    // u = a x + b, a p/q, x' = 1.
    const rational a(next.between(1, 4) * (next.one_in(2) ? 1 : -1), next.between(1, 3));
    const rational b(next.between(-9, 9), next.between(1, 4));
    const rational from = next.one_in(3) ? rational(0) : rational(next.between(of.least, of.most), 10);
    const rational to = next.one_in(4) ? rational(0) : rational(next.between(of.least, of.most), 10);
    const rational start = (from - b) / a;
    const rational since = abs((to - from) / a);
    const rational rate = (to - from) * a < 0 ? rational(-1) : rational(1);
    const std::string u = fmt::format("({})*x + ({})", a.str(), b.str());
    const std::string text = fmt::format("x' = {0}; w' = ({1})*({0}); y' = {2}; x(0) = {3}; w(0) = {4}; y(0) = 0",
                                         rate.str(), a.str(), with_expressions(of.text, u), start.str(), from.str());
    const long digits = next.between(1, 40);
    return answered(
        fmt::format("libration reference --problem \"{}\" --time={} --digits {}", text, since.str(), digits),
        [&](outcome& result) {
            const auto found = ode::proved_part_of_trajectory(system_of(text), {time_number(since.str())}, digits,
                                                              [](const ball&, long) { require_time_left(); });
            const rational slope = a * rate;
            const auto value = [&] { return mpfr((of.primitive(real(to)) - of.primitive(real(from))) / real(slope)); };
            if (!found.states.front().empty()) {
                add_number(result, found.states.front()[2], digits, value, "y");
            }
            if (found.missing) {
                result.add(verdict::refused, found.missing->what());
            }
        });
}

}  // namespace libration::attack
