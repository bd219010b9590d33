#include "attack/solved_problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace libration::attack {

namespace {

// The time since the initial time, as written in equations.
std::string since_start(const rational& origin) { return origin == 0 ? "t" : "(t-(" + origin.str() + "))"; }

std::string starting(const std::string& name, const rational& origin, const std::string& value) {
    return fmt::format("; {}({}) = {}", name, origin.str(), value);
}

rational any_origin(choices& next) {
    switch (next.below(4)) {
        case 0: return {next.between(-20, 20), next.between(1, 9)};
        case 1: return next.between(-2, 2);
        default: return 0;
    }
}

void bound_by(solved_problem& problem, const component& u) {
    problem.backward = problem.parts.empty() ? u.backward : std::min(problem.backward, u.backward);
    problem.forward = problem.parts.empty() ? u.forward : std::min(problem.forward, u.forward);
    problem.parts.push_back(u);
}

solved_problem of_two(const component& u, const component& v, const rational& origin) {
    solved_problem made;
    made.origin = origin;
    bound_by(made, u);
    bound_by(made, v);
    made.columns = {"x", "y"};
    return made;
}

solved_problem of_one(const component& u, const rational& origin, const std::string& name) {
    solved_problem made;
    made.origin = origin;
    made.columns = {name};
    made.part_of = {0};
    bound_by(made, u);
    return made;
}

}  // namespace

rational decimal_fraction(const integer& whole, long digits) {
    return {whole, pow(integer(10), static_cast<unsigned>(digits))};
}

std::string solved_problem::typed_time(const rational& since) const {
    if (unit.empty()) {
        return rational(origin + since).str();
    }
    const long thousandths = rational(since * 1000).convert_to<long>();
    return fmt::format("{}e{}", thousandths, std::stol(unit.substr(1)) - 3);
}

solved_problem alone(const component& u, const std::string& name) {
    solved_problem made = of_one(u, 0, name);
    made.text = fmt::format("{}' = {}{}", name, u.slope(name, "t"), starting(name, 0, u.start.text));
    made.values = {u.value};
    return made;
}

solved_problem beside(const std::vector<component>& all) {
    solved_problem made;
    static constexpr std::array names{"y", "z", "w", "v"};
    std::string starts;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = names[i];
        bound_by(made, all[i]);
        made.columns.push_back(name);
        made.values.push_back(all[i].value);
        made.part_of.push_back(i);
        made.text += fmt::format("{}{}' = {}", i == 0 ? "" : "; ", name, all[i].slope(name, "t"));
        starts += starting(name, 0, all[i].start.text);
    }
    made.text += starts;
    return made;
}

solved_problem mixed(const component& u, const component& v, choices& next) {
    static constexpr std::array<std::array<long, 4>, 4> matrices{
        {{1, 1, 1, -1}, {2, 1, 1, 1}, {1, 2, -1, 1}, {3, -1, 1, 2}}};
    const auto [a, b, c, d] = matrices[next.below(matrices.size())];
    const long det = a * d - b * c;
    solved_problem made = of_two(u, v, any_origin(next));
    const std::string s = since_start(made.origin);
    const std::string left = fmt::format("((({})*x+({})*y)/({}))", d, -b, det);
    const std::string right = fmt::format("((({})*x+({})*y)/({}))", -c, a, det);
    const auto row = [](long by_u, long by_v, const std::string& of_u, const std::string& of_v) {
        return fmt::format("({})*({})+({})*({})", by_u, of_u, by_v, of_v);
    };
    const std::string f = u.slope(left, s);
    const std::string g = v.slope(right, s);
    made.text = fmt::format("x' = {}; y' = {}{}{}", row(a, b, f, g), row(c, d, f, g),
                            starting("x", made.origin, row(a, b, u.start.text, v.start.text)),
                            starting("y", made.origin, row(c, d, u.start.text, v.start.text)));
    made.values = {[=](const mpfr& at) { return mpfr(a * u.value(at) + b * v.value(at)); },
                   [=](const mpfr& at) { return mpfr(c * u.value(at) + d * v.value(at)); }};
    return made;
}

solved_problem bent(const component& u, const component& v, long k) {
    solved_problem made = of_two(u, v, 0);
    const std::string f = u.slope("x", "t");
    made.text = fmt::format("x' = {0}; y' = {1}+{2}*x*({0}); x(0) = {3}; y(0) = {4}+{5}*({3})^2", f,
                            v.slope(fmt::format("(y-{}*x^2)", k), "t"), 2 * k, u.start.text, v.start.text, k);
    made.values = {u.value, [=](const mpfr& at) {
                       const mpfr x = u.value(at);
                       return mpfr(v.value(at) + k * x * x);
                   }};
    return made;
}

solved_problem scaled(const component& u, choices& next) {
    static constexpr std::array<const char*, 6> sizes{"1e1000", "1e-1000", "2^(-349)", "2^509", "1e-30", "1e300"};
    static constexpr std::array<std::array<long, 2>, 6> powers{
        {{10, 1000}, {10, -1000}, {2, -349}, {2, 509}, {10, -30}, {10, 300}}};
    const std::size_t which = next.below(sizes.size());
    const auto [base, exponent] = powers[which];
    const std::string size = fmt::format("({})", sizes[which]);
    solved_problem made = of_one(u, any_origin(next), "y");
    made.text = fmt::format("y' = {0}*({1}){2}", size, u.slope("(y/" + size + ")", since_start(made.origin)),
                            starting("y", made.origin, size + "*" + u.start.text));
    made.values = {[=](const mpfr& at) { return mpfr(u.value(at) * pow(mpfr(base), mpfr(exponent))); }};
    return made;
}

solved_problem stretched(const component& u, choices& next) {
    solved_problem made = of_one(u, 0, "y");
    made.unit = next.one_in(2) ? "e1000" : "e-1000";
    const std::string unit = "(1" + made.unit + ")";
    made.text = fmt::format("y' = ({})/{}; y(0) = {}", u.slope("y", "(t/" + unit + ")"), unit, u.start.text);
    made.values = {u.value};
    return made;
}

solved_problem any_problem(choices& next) {
    const component u = any_component(next);
    switch (next.below(12)) {
        case 0:
        case 1: return alone(u);
        case 2:
        case 3: return beside({u, any_component(next)});
        case 4: return beside({u, any_component(next), any_component(next)});
        case 5:
        case 6:
        case 7: return mixed(u, any_component(next), next);
        case 8:
        case 9: return bent(u, any_component(next), next.between(1, 3));
        case 10: return scaled(u, next);
        default: return stretched(u, next);
    }
}

rational reached_time(const solved_problem& problem, choices& next) {
    constexpr double longest = 3;
    const bool back = next.one_in(3);
    const double far = std::min(longest, 0.9 * (back ? problem.backward : problem.forward));
    const long most = std::max(1L, static_cast<long>(far * 1000));
    const rational since = decimal_fraction(next.between(1, most), 3);
    const rational small = next.one_in(12) && problem.unit.empty() ? rational(since / pow(integer(10), 40U)) : since;
    return back ? rational(-small) : small;
}

}  // namespace libration::attack
