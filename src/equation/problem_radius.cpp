#include "equation/problem_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "text/cell.hpp"

namespace libration {

namespace {

constexpr long digits_of_place = 12;

std::string at_words(const complex_number<mpfr>& z) {
    if (z.im == 0) {
        return to_decimal(z.re, digits_of_place);
    }
    return fmt::format("{} {} {}i", to_decimal(z.re, digits_of_place), z.im < 0 ? "-" : "+",
                       to_decimal(mpfr(abs(z.im)), digits_of_place));
}

// Without the primes of the derivative to which the loop refers.
std::string unknown_of(const ode::explicit_system& system, const ode::loop_result& loop) {
    std::string name = ode::first_order_form(system).names[loop.unknown];
    name.erase(std::find(name.begin(), name.end(), '\''), name.end());
    return name;
}

std::string words_of_loop(const ode::explicit_system& system, const ode::loop_result& loop) {
    const std::string name = ode::first_order_form(system).names[loop.unknown];
    if (loop.evidence == ode::loop_evidence::change) {
        return name + " does not return to its value around it";
    }
    return loop.power == 0 ? fmt::format("the contour integral of {} is nonzero", name)
                           : fmt::format("the contour integral of (t - t*)^{} {} is nonzero", loop.power, name);
}

// A covering with the same digits costs as much as the first; one with more digits, many times that.
void check_bounds(const ode::explicit_system& system, long digits, const ode::outward_bounds& first) {
    const auto second = ode::outward_decimals(ode::prove_radius(system, digits, ode::proof_route::second()), digits);
    if (!intervals_meet(first.lower, first.upper, second.lower, second.upper)) {
        throw std::runtime_error(
            fmt::format("the two proofs disagree on the radius: {} to {} by the first, {} to {} "
                        "by the second",
                        first.lower, first.upper, second.lower, second.upper));
    }
}

}  // namespace

std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved) {
    std::string loop = words_of_loop(system, proved.evidence);
    if (proved.pole_order == 0) {
        return loop;
    }
    return fmt::format("{}; 1/{} has a {} zero", loop, unknown_of(system, proved.evidence),
                       proved.pole_order == 1 ? "simple" : "double");
}

proved_radius_answer proved_radius_of(const ode::explicit_system& system, long digits, bool check) {
    const auto checked = checked_products(check);
    const ode::proved_radius radius = ode::prove_radius(system, digits);
    if (check) {
        check_bounds(system, digits, ode::outward_decimals(radius, digits));
    }
    proved_radius_answer answer{table({{"lower", ""}, {"upper", ""}, {"digits", ""}, {"rigour", ""}}), ""};
    if (radius.infinite) {
        answer.data.add_row({cell::number("inf", digits), cell::number("inf", digits), digits, "proved"});
        answer.text = "radius  inf  proved: the equation is linear with entire coefficients\n";
        return answer;
    }
    const auto [lower, upper] = ode::outward_decimals(radius, digits);
    answer.data.add_row({number_cell(lower), number_cell(upper), digits, "proved"});
    const std::string systems = radius.systems > 1
                                    ? fmt::format(", once for each of {} independent systems", radius.systems)
                                : radius.rotation > 1 ? fmt::format(" up to rotation by 1/{} turn", radius.rotation)
                                                      : "";
    answer.text =
        fmt::format("lower  {}  proved: {} discs cover |t - t0| <= R{}\n", lower, radius.cover.discs.size(), systems) +
        fmt::format("upper  {}  proved: a singularity of {} within {} of {}, because {}\n", upper,
                    unknown_of(system, radius.evidence->evidence), upper_bound_text(radius.evidence->reach.exact()),
                    at_words(radius.evidence->centre), words_of_evidence(system, *radius.evidence));
    return answer;
}

}  // namespace libration
