#include "libration/ode/proved/proved_singularity.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "disc_path.hpp"
#include "libration/ode/singularity/regular_coordinates.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "needed_bits.hpp"
#include "set_values.hpp"

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
// Weights of the round integrals beyond the order of a pole that was seen.
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

// A pole that was seen, with more bits where it takes them.
int proved_pole_order(const explicit_system& system, const found_singularity& found,
                      const std::vector<complex_ball>& corners, const magnitude& reach, long bits,
                      const proof_route& route) {
    const auto regular = regular_coordinates::of(system);
    if (!regular || found.kind != singularity_kind::pole) {
        return 0;
    }
    for (int attempt = 0; attempt < most_pole_attempts; ++attempt) {
        if (is_pole_near(system, corners, exact_ball(found.offset), reach, bits, route)) {
            return regular->order();
        }
        bits += bits / 2;
    }
    return 0;
}

[[noreturn]] void refuse_proof(const std::string& why) { throw error(error_kind::undecided, "problem", "", why); }

std::string shown_number(const mpfr& x) { return to_decimal(x, shown_digits); }

// More bits until a loop shows something; nothing where so many attempts do not.
std::optional<proved_singularity> shown_along(const explicit_system& system, const found_singularity& found,
                                              const std::vector<complex_ball>& corners, const mpfr& reach,
                                              int most_attempts, const proof_route& route) {
    const precision_scope wide(static_cast<int>(mpfr_get_prec(handle(found.offset.re)) * 30103L / 100'000L) + 2);
    const mpfr size = modulus_of(found.offset);
    const long digits = -static_cast<long>(floor(log10(mpfr(reach / size))));
    const complex_ball centre = exact_ball(found.offset);
    long bits = bits_of_digits(std::max(digits, 1L) + 4) + loop_guard_bits;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        try {
            const complex_flow flow(system, bits, route);
            loop_result loop = loop_about(flow, corners, centre, magnitude_of(reach), weights_for(found));
            if (loop.evidence != loop_evidence::none) {
                const int order = proved_pole_order(system, found, corners, loop.reach, bits, route);
                return proved_singularity{found.offset, loop.reach, std::move(loop), order};
            }
        } catch (const precision_exhausted&) {
            // the next one has more bits
        }
        bits = bits + bits / 2;
    }
    return std::nullopt;
}

[[noreturn]] void refuse_loop(const found_singularity& found) {
    const precision_scope scope(shown_digits + 10);
    refuse_proof("is not proved to have a singularity near " + shown_number(narrow<mpfr>(found.offset.re)) + " + " +
                 shown_number(narrow<mpfr>(found.offset.im)) + "i: no change or integral round it is told from 0");
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
        return false;  // a zero of y is in the way, where 1/y is singular
    }
}

proved_singularity prove_singularity(const explicit_system& system, const found_singularity& found, const mpfr& reach,
                                     const proof_route& route) {
    std::vector<complex_ball> corners;
    for (const auto& each : found.path) {
        corners.push_back(exact_ball(complex_number<mpfr>{mpfr(each.real()), mpfr(each.imag())}));
    }
    auto proved = shown_along(system, found, corners, reach, most_loop_attempts, route);
    if (!proved) {
        refuse_loop(found);
    }
    return *std::move(proved);
}

std::vector<proved_singularity> prove_singularities(const explicit_system& system,
                                                    const std::vector<found_singularity>& found, long digits,
                                                    const std::function<void()>& done, const proof_route& route) {
    const precision_scope scope(digits + 30);
    std::vector<proved_singularity> proved;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const complex_number<mpfr>& at = found[i].offset;
        const auto before = found.begin() + static_cast<std::ptrdiff_t>(i);
        const auto image = std::find_if(found.begin(), before, [&](const found_singularity& each) {
            return each.offset.re == at.re && each.offset.im == -at.im;
        });
        if (image != before) {
            proved.push_back(proved[static_cast<std::size_t>(image - found.begin())]);
        } else {
            const mpfr modulus = modulus_of(at);
            const mpfr reach = pow(mpfr(10), -static_cast<int>(digits)) / 2;
            proved.push_back(prove_singularity(system, found[i], modulus < 1 ? mpfr(reach * modulus) : reach, route));
        }
        if (done) {
            done();
        }
    }
    return proved;
}

proved_radius prove_radius(const explicit_system& system, long digits, const proof_route& route) {
    proved_radius result;
    if (has_entire_solutions(system)) {
        result.infinite = true;
        return result;
    }
    // A pole where expansions have complex exponents has those of other sheets near it, nearer the further one goes
    // round: only a small loop meets none. So the loop may be smaller than the digits ask.
    long loop_digits = digits;
    for (int smaller = 0; !result.evidence; ++smaller) {
        if (smaller > 0) {
            loop_digits = std::max(2 * loop_digits, least_digits_of_smaller_loop);
        }
        singularity_request request;
        request.digits = loop_digits + 6;
        request.nearest_alone = true;
        const singularity_map map = singularities_of(system, request);
        if (map.all.empty()) {
            refuse_proof("shows no singularity within " + std::to_string(map.within) +
                         " of its start, so that nothing bounds its radius from above");
        }
        const precision_scope scope(static_cast<int>(request.digits) + 20);
        result.nearest = map.all.front();
        const mpfr reach = modulus_of(result.nearest->offset) * pow(mpfr(10), -static_cast<int>(loop_digits)) / 4;
        // Straight from the start: nothing nearer is in the way.
        const bool last = smaller == most_smaller_loops;
        result.evidence = shown_along(system, *result.nearest, {}, reach, last ? most_loop_attempts : 2, route);
        if (!result.evidence && last) {
            refuse_loop(*result.nearest);
        }
    }
    const precision_scope scope(static_cast<int>(loop_digits) + 26);
    const mpfr size = modulus_of(result.nearest->offset);
    const mpfr gap = size * pow(mpfr(10), -static_cast<int>(digits)) / 4;
    result.rotation = symmetry_of(system).rotation;
    result.upper = result.evidence->evidence.farthest;
    const ball rho = exact_ball(mpfr(size - gap));
    covering_limits limits;
    limits.finest_bits = bits_of_digits(digits) + 8;
    limits.most_discs = most_discs_a_digit * (digits + 10);
    covering found;
    long bits = bits_of_digits(digits) + loop_guard_bits;
    for (int attempt = 0; attempt < most_coverings && !found.complete; ++attempt) {
        const complex_flow flow(system, bits, route);
        found = covered_disc(flow, rho, {result.rotation}, limits);
        bits += bits / 2;
    }
    if (!found.complete) {
        refuse_proof("has a radius of at most " + shown_number(midpoint_of(result.upper)) + " and at least " +
                     shown_number(midpoint_of(found.covered)) + ", both proved; more is not: " + found.reason);
    }
    result.lower = rho;
    result.cover = std::move(found);
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
