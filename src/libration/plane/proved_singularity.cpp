#include "libration/plane/proved_singularity.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "../expansion/set_values.hpp"
#include "../integration/closed_form/constant_solution.hpp"
#include "disc_path.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/dependency.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/plane/regular_coordinates.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::ode {

namespace {

constexpr long loop_guard_bits = 48;
constexpr int most_loop_attempts = 6;
constexpr int most_pole_attempts = 3;
constexpr int most_smaller_loops = 3;
constexpr long least_digits_of_smaller_loop = 16;
constexpr int most_coverings = 4;
constexpr long most_discs_a_digit = 300;
constexpr long shown_digits = 12;
// Weights of the contour integrals beyond the order of the observed pole.
constexpr int largest_power = 8;

ball exact_ball(const mpfr& x) {
    ball result;
    arf_set_mpfr(arb_midref(result.handle()), handle(x));
    return result;
}

complex_ball exact_ball(const complex_number<mpfr>& z) { return {exact_ball(z.re), exact_ball(z.im)}; }

magnitude magnitude_of(const mpfr& x) { return magnitude(exact_ball(x)); }

int weights_for(const found_singularity& found) {
    int order = 1;
    for (const auto& each : found.exponents) {
        order = std::max(order, static_cast<int>(std::min(-each.real(), 1.0 * largest_power)));
    }
    return order - 1;
}

// The order of an observed pole if it is proved, with increasing precision; 0 otherwise.
int proved_pole_order(const explicit_system& system, const found_singularity& found,
                      const std::vector<complex_ball>& corners, const magnitude& reach, long bits,
                      const proof_route& route) {
    const auto regular = regular_coordinates::of(system);
    if (!regular || found.kind != singularity_kind::pole) {
        return 0;
    }
    const auto order = with_half_more_bits(bits, most_pole_attempts, [&](long now) {
        return is_pole_near(system, corners, exact_ball(found.offset), reach, now, route)
                   ? std::optional(regular->order())
                   : std::nullopt;
    });
    return order.value_or(0);
}

constexpr error_subject subject_of_refusals = error_subject::problem;

[[noreturn]] void refuse_proof(const std::string& why) {
    throw error(error_kind::undecided, subject_of_refusals, "", why);
}

std::string shown_number(const mpfr& x) { return to_decimal(x, shown_digits); }

std::string joined_names(const explicit_system& system) {
    std::string names;
    for (const unknown_function& each : system.unknowns()) {
        names += (names.empty() ? "" : ", ") + each.name;
    }
    return names;
}

// The system in which a singularity of an unknown is proved, and the leaves whose loops count as evidence.
struct proving_ground {
    closed_subsystem part;
    std::vector<std::size_t> of;
};

// The system that the unknown with this leaf of the whole system depends on; only its own leaves count as evidence, or
// all.
proving_ground ground_of(const explicit_system& whole, std::size_t leaf, bool all_count) {
    std::size_t which = 0;
    for (std::size_t last = 0; (last += static_cast<std::size_t>(whole.unknowns()[which].order)) <= leaf;) {
        ++which;
    }
    proving_ground ground{subsystem_of(whole, dependency_graph(whole).closure(which)), {}};
    std::size_t k = 0;
    for (std::size_t i = 0; i < ground.part.unknowns.size(); ++i) {
        const int order = ground.part.system.unknowns()[i].order;
        for (int j = 0; j < order; ++j, ++k) {
            if (all_count || ground.part.unknowns[i] == which) {
                ground.of.push_back(k);
            }
        }
    }
    return ground;
}

// Increases the precision until a loop gives evidence; std::nullopt if the maximum number of attempts does not.
std::optional<proved_singularity> shown_along(const proving_ground& ground, const found_singularity& found,
                                              const std::vector<complex_ball>& corners, const mpfr& reach,
                                              int most_attempts, const proof_route& route) {
    const precision_scope wide(static_cast<int>(mpfr_get_prec(handle(found.offset.re)) * 30103L / 100'000L) + 2);
    const explicit_system& system = ground.part.system;
    const mpfr size = modulus_of(found.offset);
    const long digits = -static_cast<long>(floor(log10(mpfr(reach / size))));
    const complex_ball centre = exact_ball(found.offset);
    const long first = bits_of_digits(std::max(digits, 1L) + 4) + loop_guard_bits;
    return with_half_more_bits(first, most_attempts, [&](long bits) -> std::optional<proved_singularity> {
        try {
            const complex_flow flow(system, bits, route);
            loop_result loop = loop_about(flow, corners, centre, magnitude_of(reach), weights_for(found), ground.of);
            if (loop.evidence != loop_evidence::none) {
                const int order = proved_pole_order(system, found, corners, loop.reach, bits, route);
                loop.unknown = ground.part.leaves[loop.unknown];
                return proved_singularity{found.offset, loop.reach, std::move(loop), order};
            }
        } catch (const precision_exhausted&) {
            // the next attempt has more bits
        }
        return std::nullopt;
    });
}

std::string shown_place(const found_singularity& found) {
    const precision_scope scope(shown_digits + 10);
    return shown_number(narrow<mpfr>(found.offset.re)) + " + " + shown_number(narrow<mpfr>(found.offset.im)) + "i";
}

[[noreturn]] void refuse_loop(const explicit_system& system, const found_singularity& found) {
    refuse_proof("is not proved to have a singularity of " + first_order_form(system).names[found.unknown] + " near " +
                 shown_place(found) + ": no change or integral of it around that point is distinguished from 0");
}

}  // namespace

bool is_pole_near(const explicit_system& system, const std::vector<complex_ball>& corners, const complex_ball& offset,
                  const magnitude& reach, long bits, const proof_route& route) {
    const auto regular = regular_coordinates::of(system);
    if (!regular) {
        return false;
    }
    const precision_scope scope(decimal_digits(bits));
    const ball origin = constant_value<ball>::of(system.point());
    const auto time_at = [&](const complex_ball& from_start) {
        return complex_ball(origin + from_start.re, from_start.im);
    };
    const auto none = [](const complex_disc&, const complex_ball&) {};
    try {
        const complex_flow flow(system, bits, route);
        disc_path path(flow);
        for (const complex_ball& each : corners) {
            path.go_to(each, none);
        }
        const complex_ball behind = path.now().about().offset;
        path.go_to(exact_midpoint(behind + exact_difference(offset, behind) / 2), none);
        const complex_ball here = path.now().about().offset;
        const auto coordinates = regular->from(time_at(here), values_of(path.now().about()));
        if (!all_finite(coordinates)) {
            return false;
        }
        const complex_flow beyond = complex_flow::about_points(regular->system(), bits, route);
        disc_path rest(beyond, set_about(here, coordinates));
        rest.go_to(offset, none);
        const complex_ball within{widened(offset.re, reach), widened(offset.im, reach)};
        const auto over = rest.now().values_over(within);
        const std::size_t q = regular->simple_zero();
        const complex_ball step = values_of(rest.now().about())[q] / regular->slopes(time_at(within), over)[q];
        const bool one_zero = certainly_within(step, reach);
        return one_zero && (regular->order() == 1 || certainly_not_zero(regular->factor(time_at(within), over)));
    } catch (const precision_exhausted&) {
        return false;
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        return false;  // there is a zero of y on the path, where 1/y is singular
    }
}

proved_singularity prove_singularity(const explicit_system& system, const found_singularity& found, const mpfr& reach,
                                     const proof_route& route) {
    std::vector<complex_ball> corners;
    for (const auto& each : found.path) {
        corners.push_back(exact_ball(complex_number<mpfr>{mpfr(each.real()), mpfr(each.imag())}));
    }
    auto proved =
        shown_along(ground_of(system, found.unknown, false), found, corners, reach, most_loop_attempts, route);
    if (!proved) {
        refuse_loop(system, found);
    }
    return *std::move(proved);
}

namespace {

proved_singularity proved_or_refused(const explicit_system& system, const found_singularity& found, const mpfr& reach,
                                     const proof_route& route) {
    try {
        return prove_singularity(system, found, reach, route);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        proved_singularity refused;
        refused.centre = found.offset;
        refused.refusal = problem.is_about(subject_of_refusals) ? problem.reason()
                                                                : std::string("was not decided: ") + problem.what();
        return refused;
    }
}

}  // namespace

std::vector<proved_singularity> prove_singularities(const explicit_system& system,
                                                    const std::vector<found_singularity>& found, long digits,
                                                    const std::function<void()>& done, const proof_route& route) {
    const precision_scope scope(digits + 30);
    std::vector<proved_singularity> proved;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const complex_number<mpfr>& at = found[i].offset;
        const auto before = found.begin() + static_cast<std::ptrdiff_t>(i);
        const auto image = std::find_if(found.begin(), before, [&](const found_singularity& each) {
            return each.unknown == found[i].unknown && each.offset.re == at.re && each.offset.im == -at.im;
        });
        if (image != before) {
            proved.push_back(proved[static_cast<std::size_t>(image - found.begin())]);
        } else {
            const mpfr modulus = modulus_of(at);
            const mpfr reach = pow(mpfr(10), -static_cast<int>(digits)) / 2;
            proved.push_back(proved_or_refused(system, found[i], modulus < 1 ? mpfr(reach * modulus) : reach, route));
        }
        if (done) {
            done();
        }
    }
    return proved;
}

namespace {

// The nearest singularity and a loop around it. Near a pole whose expansion has complex exponents there are
// singularities of other sheets, closer with each turn around it: only a small loop avoids them. So the loop may be
// smaller than the digits require; the digits that it proves are returned.
long find_upper_bound(const explicit_system& system, long digits, const proof_route& route, proved_radius& result) {
    long loop_digits = digits;
    for (int smaller = 0;; ++smaller) {
        if (smaller > 0) {
            loop_digits = std::max(2 * loop_digits, least_digits_of_smaller_loop);
        }
        singularity_request request;
        request.digits = loop_digits + 6;
        request.nearest_alone = true;
        request.watch = route.watch;
        const singularity_map map = singularities_of(system, request);
        if (map.ended) {
            throw error(*map.ended);
        }
        if (map.all.empty()) {
            refuse_proof("has no upper bound of its radius: no singularity was found within " +
                         shown_number(mpfr(map.within)) +
                         " of its initial point, which does not prove that there is none");
        }
        const precision_scope scope(static_cast<int>(request.digits) + 20);
        result.nearest = map.all.front();
        const mpfr reach = modulus_of(result.nearest->offset) * pow(mpfr(10), -static_cast<int>(loop_digits)) / 4;
        // Straight from the initial point: there is no nearer singularity on the path. The radius is that of all
        // unknowns, so the evidence may be from any of them.
        const bool last = smaller == most_smaller_loops;
        result.evidence = shown_along(ground_of(system, result.nearest->unknown, true), *result.nearest, {}, reach,
                                      last ? most_loop_attempts : 2, route);
        if (result.evidence) {
            return loop_digits;
        }
        if (last) {
            refuse_loop(system, *result.nearest);
        }
    }
}

// Covers |z| <= rho, with more bits if needed.
covering covered_with_bits(const explicit_system& system, const ball& rho, long digits, const proof_route& route) {
    covering_limits limits;
    limits.finest_bits = bits_of_digits(digits) + 8;
    limits.most_discs = most_discs_a_digit * (digits + 10);
    covering found;
    with_half_more_bits(bits_of_digits(digits) + loop_guard_bits, most_coverings, [&](long bits) {
        const complex_flow flow(system, bits, route);
        found = covered_disc(flow, rho, symmetry_of(system), limits);
        return found.complete ? std::optional(true) : std::nullopt;
    });
    return found;
}

// covered_with_bits(); if an error of the kind undecided ends it, the message contains the proved upper bound.
covering covered_or_ended(const explicit_system& system, const ball& rho, long digits, const proof_route& route,
                          const ball& upper) {
    try {
        return covered_with_bits(system, rho, digits, route);
    } catch (const error& reason) {
        if (reason.kind() != error_kind::undecided) {
            throw;
        }
        refuse_proof("has a radius of at most " + shown_number(midpoint_of(upper)) +
                     ", proved; a lower bound is not: " + reason.what());
    }
}

// The independent systems that are not entire, the one with this leaf first.
std::vector<closed_subsystem> systems_to_cover(const explicit_system& system, std::size_t leaf) {
    std::vector<closed_subsystem> all = independent_subsystems(system);
    std::erase_if(all, [](const closed_subsystem& each) { return has_entire_solutions(each.system); });
    std::stable_partition(all.begin(), all.end(), [&](const closed_subsystem& each) {
        return std::ranges::find(each.leaves, leaf) != each.leaves.end();
    });
    return all;
}

}  // namespace

proved_radius prove_radius(const explicit_system& system, long digits, const proof_route& route) {
    proved_radius result;
    result.constant = constancy_of(system) != constancy::none;
    if (result.constant || has_entire_solutions(system)) {
        result.infinite = true;
        return result;
    }
    const long loop_digits = find_upper_bound(system, digits, route, result);
    const precision_scope scope(static_cast<int>(loop_digits) + 26);
    const mpfr size = modulus_of(result.nearest->offset);
    const mpfr gap = size * pow(mpfr(10), -static_cast<int>(digits)) / 4;
    result.upper = result.evidence->evidence.farthest;
    const ball rho = exact_ball(mpfr(size - gap));
    const auto systems = systems_to_cover(system, result.nearest->unknown);
    result.systems = systems.size();
    result.rotation = symmetry_of(systems.front().system).rotation;
    for (const closed_subsystem& each : systems) {
        covering found = covered_or_ended(each.system, rho, digits, route, result.upper);
        if (!found.complete) {
            refuse_proof("has a radius of at most " + shown_number(midpoint_of(result.upper)) +
                         (systems.size() > 1 ? ", proved; of " + joined_names(each.system) + " it is at least "
                                             : " and at least ") +
                         shown_number(midpoint_of(found.covered)) +
                         (systems.size() > 1 ? ", proved" : ", both proved") + "; more is not: " + found.reason);
        }
        result.cover.complete = true;
        result.cover.covered = found.covered;
        result.cover.discs.insert(result.cover.discs.end(), found.discs.begin(), found.discs.end());
    }
    result.lower = rho;
    return result;
}

outward_bounds outward_decimals(const proved_radius& radius, long digits) {
    if (radius.infinite) {
        return {"inf", "inf"};
    }
    const precision_scope scope(digits + 40);
    const mpfr lower = midpoint_of(radius.lower);
    const mpfr upper = midpoint_of(radius.upper);
    constexpr long most_more_digits = 6;
    for (long more = 1;; ++more) {
        const decimal_parts below = parts_of(lower, digits + more, MPFR_RNDD);
        const decimal_parts above = parts_of(upper, digits + more, MPFR_RNDU);
        const ball gap = above.value() - below.value();
        if (more >= most_more_digits || certainly_less(gap * pow(ball(10), digits), below.value())) {
            return {below.text(), above.text()};
        }
    }
}

}  // namespace libration::ode
