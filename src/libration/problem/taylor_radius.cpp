// Proved bounds of the radius of convergence of any system, and the proof in words.
#include <algorithm>
#include <stdexcept>

#include "law_radius.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/decimal.hpp"
#include "plane_work.hpp"
#include "taylor_solution.hpp"
#include "words_of_evidence.hpp"

namespace libration {

namespace {

constexpr long digits_of_place = 12;

std::string place_in_words(const complex_number<mpfr>& z) {
    return complex_text(to_decimal(z.re, digits_of_place), to_decimal(z.im, digits_of_place));
}

// Without the primes of the derivative to which the loop refers.
std::string unknown_of(const ode::explicit_system& system, const ode::loop_result& loop) {
    std::string name = ode::first_order_form(system).names[loop.unknown];
    name.erase(std::ranges::find(name, '\''), name.end());
    return name;
}

std::string words_of_loop(const ode::explicit_system& system, const ode::loop_result& loop) {
    const std::string name = ode::first_order_form(system).names[loop.unknown];
    if (loop.evidence == ode::loop_evidence::change) {
        return name + " does not return to its value around it";
    }
    const std::string factor = loop.power == 0 ? "" : "(t - t*)^" + std::to_string(loop.power) + " ";
    return "the contour integral of " + factor + name + " is nonzero";
}

// A covering with the same digits costs as much as the first; one with more digits, many times that.
void require_second_bounds(const ode::explicit_system& system, long digits, const ode::outward_bounds& first,
                           const ode::plane_watch& watch) {
    ode::proof_route route = ode::proof_route::second();
    route.watch = watch;
    const auto second = ode::outward_decimals(ode::prove_radius(system, digits, route), digits);
    if (!intervals_meet(first.lower, first.upper, second.lower, second.upper)) {
        throw std::runtime_error("the two proofs disagree on the radius: " + first.lower + " to " + first.upper +
                                 " by the first, " + second.lower + " to " + second.upper + " by the second");
    }
}

std::vector<answer_note> notes_of(const ode::explicit_system& system, const ode::proved_radius& radius) {
    if (radius.infinite) {
        return {{"radius", radius.constant ? "the solution is constant" : words_of_entire_solutions}};
    }
    const std::string systems =
        radius.systems > 1    ? ", once for each of " + std::to_string(radius.systems) + " independent systems"
        : radius.rotation > 1 ? " up to rotation by 1/" + std::to_string(radius.rotation) + " turn"
                              : "";
    const ode::proved_singularity& found = *radius.evidence;
    return {{"lower", std::to_string(radius.cover.discs.size()) + " discs cover |t - t0| <= R" + systems},
            {"upper", "a singularity of " + unknown_of(system, found.evidence) + " within " +
                          upper_bound_text(found.reach.exact()) + " of " + place_in_words(found.centre) + ", because " +
                          words_of_evidence(system, found)}};
}

}  // namespace

std::string words_of_evidence(const ode::explicit_system& system, const ode::proved_singularity& proved) {
    std::string loop = words_of_loop(system, proved.evidence);
    if (proved.pole_order == 0) {
        return loop;
    }
    return loop + "; 1/" + unknown_of(system, proved.evidence) + " has a " +
           (proved.pole_order == 1 ? "simple" : "double") + " zero";
}

answer taylor_solution::proved_radius(const series_request& of, const request& how) const {
    if (!of.about.empty()) {
        throw error(error_kind::argument, error_subject::point, of.about,
                    "is not the initial point, the only one for which the radius of these equations is bounded");
    }
    const auto checked = checked_products(how.check);
    const long digits = how.printed_digits();
    if (auto found = how.check ? std::nullopt : radius_by_linear_law(system_, how)) {
        return *std::move(found);
    }
    plane_work work(how);
    const ode::proved_radius radius = ode::prove_radius(system_, digits, {.watch = work.watch()});
    const ode::outward_bounds bounds = ode::outward_decimals(radius, digits);
    answer result{.names = {"lower", "upper"},
                  .rows = {{{bounds.lower, ""}, {bounds.upper, ""}}},
                  .rigour = "proved",
                  .notes = notes_of(system_, radius)};
    if (const std::string kinds = radius.infinite ? "" : kinds_by_law(system_, how); !kinds.empty()) {
        result.notes.push_back({"nearest", kinds});
    }
    if (how.check) {
        result.missing = undecided_in([&] { require_second_bounds(system_, digits, bounds, work.watch()); });
    }
    return result;
}

}  // namespace libration
