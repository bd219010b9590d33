// Periodic orbits of families with known periods, and multipliers behind a change of coordinates.
#include <fmt/core.h>

#include <optional>
#include <utility>

#include "attack/facts.hpp"
#include "attack/question.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"

namespace libration::attack {

namespace {

// A problem with the initial values of an orbit, its period, and a multiplier.
struct asked_orbit {
    std::string text;
    truth period;
    std::optional<truth> multiplier = {};  // the last one
};

// Kepler's ellipse from its pericentre, with the semi-major axis a and the eccentricity e, turned by a right angle or not:
// 2 pi a^(3/2).
asked_orbit of_ellipse(choices& next) {
    const rational a(next.between(1, 5), next.between(1, 3));
    const rational e(next.between(0, 3), 5);
    const rational near = a * (1 - e);
    const rational square = (1 + e) / near;
    const bool turned = next.one_in(2);
    const std::string where =
        fmt::format("{}(0) = {}; {}(0) = 0; {}'(0) = 0; {}'(0) = sqrt({})", turned ? "y" : "x", near.str(),
                    turned ? "x" : "y", turned ? "y" : "x", turned ? "x" : "y", square.str());
    const truth period = [=] { return mpfr(8 * atan(mpfr(1)) * sqrt(real(a)) * real(a)); };
    return {"x'' = -x/(x^2+y^2)^(3/2); y'' = -y/(x^2+y^2)^(3/2); " + where, period};
}

// u' = w v, v' = -w u in X = u, Y = v + k u^2: isochronous, 2 pi/w.
asked_orbit of_hidden_oscillator(choices& next) {
    const rational w(next.between(1, 9), next.between(1, 4));
    const long k = next.between(0, 3);
    const rational start(next.between(1, 8), 8);
    const std::string v = fmt::format("(y-{}*x^2)", k);
    const truth period = [=] { return mpfr(8 * atan(mpfr(1)) / real(w)); };
    return {fmt::format("x' = {0}*{1}; y' = -{0}*x+{2}*x*{0}*{1}; x(0) = {3}; y(0) = {4}", w.str(), v, 2 * k,
                        start.str(), rational(k * start * start).str()),
            period};
}

// r' = a r (1 - r^2), a turn in 2 pi/w, and z' = -c z, in X = u, Y = v + k u^2, Z = z + l X: the multipliers are 1,
// exp(-4 pi a/w) and exp(-2 pi c/w).
asked_orbit of_hidden_cycle(choices& next) {
    const rational a(next.between(1, 3), 9);
    const rational c(next.between(1, 3), 9);
    const rational w(next.between(1, 3));
    const long k = next.between(0, 2);
    const long l = next.between(0, 2);
    const std::string v = k == 0 ? "y" : fmt::format("(y-{}*x^2)", k);
    const std::string rest = fmt::format("{}*(1-x^2-{}^2)", a.str(), v);
    const std::string of_u = fmt::format("{}*x-{}*{}", rest, w.str(), v);
    const std::string of_v = fmt::format("{}*{}+{}*x", rest, v, w.str());
    const rational start(101, 100);
    const rational slowest = 2 * a < c ? rational(2 * a) : c;
    const rational fastest = 2 * a < c ? c : rational(2 * a);
    const truth period = [=] { return mpfr(8 * atan(mpfr(1)) / real(w)); };
    const truth least = [=] { return mpfr(exp(mpfr(-8 * atan(mpfr(1)) * real(fastest) / real(w)))); };
    const bool apart = slowest != fastest;
    return {
        fmt::format("x' = {0}; y' = {1}+{2}*x*({0}); z' = -{3}*(z-{4}*x)+{4}*({0}); x(0) = {5}; y(0) = {6}; z(0) = {7}",
                    of_u, of_v, 2 * k, c.str(), l, start.str(), rational(k * start * start).str(),
                    rational(l * start).str()),
        period, apart ? std::optional(least) : std::nullopt};
}

asked_orbit any_orbit(choices& next) {
    switch (next.below(3)) {
        case 0: return of_ellipse(next);
        case 1: return of_hidden_oscillator(next);
        default: return of_hidden_cycle(next);
    }
}

}  // namespace

outcome ask_family(choices& next) {
    const asked_orbit asked = any_orbit(next);
    const long digits = next.between(3, 30);
    return answered(fmt::format("libration find --problem \"{}\" --periodic{} --digits {}", asked.text,
                                asked.multiplier ? " --multipliers" : "", digits),
                    [&](outcome& result) {
                        const ode::orbit_question question{digits, {}, asked.multiplier.has_value()};
                        const auto orbit =
                            ode::proved_periodic_orbit(ode::explicit_system(ode::parse(asked.text)), question, {},
                                                       [](const ball&, long) { require_time_left(); });
                        result.add(judged(orbit.period, digits, asked.period), "period = " + orbit.period.text);
                        if (asked.multiplier && orbit.multipliers.back().real.decimal) {
                            const auto& least = *orbit.multipliers.back().real.decimal;
                            result.add(judged(least, digits, *asked.multiplier), "multiplier = " + least.text);
                        }
                    });
}

}  // namespace libration::attack
