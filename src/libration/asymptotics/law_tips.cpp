#include "law_tips.hpp"

#include <algorithm>
#include <cmath>

#include "../algebra/dense_matrix.hpp"
#include "libration/plane/frobenius_series.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Of the part of the slit that its expansion allows.
constexpr double part_of_reach = 0.97;
constexpr double part_of_slit = 0.85;
constexpr double least_angle_of_rays = 1e-6;

// A number of few bits, at this part of the interval from the nearest singularity to the end of the slits.
double few_bits_after(double nearest, double end, double part) {
    const double unit = std::exp2(std::floor(std::log2(end - nearest)) - 4);
    return std::floor((nearest + part * (end - nearest)) / unit) * unit;
}

}  // namespace

void refuse_law(const std::string& why) { throw error(error_kind::undecided, error_subject::problem, "", why); }

double double_below(const ball& x) { return arf_get_d(arb_midref(lower_bound(x).handle()), ARF_RND_DOWN); }

double circle_of_slits(const std::vector<algebraic_point>& all, double wanted, bool given) {
    double end = wanted;
    double nearest = wanted;
    for (const algebraic_point& each : all) {
        const double modulus = double_below(modulus_in_balls(each.place));
        end = std::min(end, modulus * (1 + part_of_reach * std::pow(double_below(each.reach), each.sheets)));
        nearest = std::min(nearest, modulus);
    }
    if (end >= wanted) {
        return wanted;
    }
    if (given) {
        refuse_law("has no proved law up to " + std::to_string(wanted) +
                   ": the expansion at a branch point reaches to " + std::to_string(end) +
                   "; write a smaller RHO as --within");
    }
    // A number of few bits between.
    const double unit = std::exp2(std::floor(std::log2(end - nearest)) - 4);
    return std::floor((nearest + part_of_slit * (end - nearest)) / unit) * unit;
}

covering_tip tip_of(const algebraic_point& of) {
    const std::complex<double> place = rounded_midpoint(of.place);
    covering_tip tip{place, std::abs(place) * part_of_reach * std::pow(double_below(of.reach), of.sheets),
                     std::abs(of.base) * (1 + 1e-12)};
    if (!(std::abs(of.base - place) < tip.radius)) {
        throw precision_exhausted("the base of a branch point");
    }
    return tip;
}

tip_bound bounds_of_tips(const std::vector<algebraic_point>& all) {
    return [&all](std::size_t k, const complex_ball& offset) {
        const complex_ball part = complex_ball(1) - offset / all[k].place;
        const ball root = pow(modulus_in_balls(part), ball(ball(1) / all[k].sheets));
        return all[k].bound_over(root);
    };
}

std::vector<movable_point> movable_points_in(const explicit_system& system, const chart_atlas& atlas, std::size_t shown,
                                             law_circle& circle, bool given, const plane_watch& watch) {
    std::vector<movable_point> all;
    std::vector<double> moduli;
    double end = circle.rho;
    const auto cut_before = [&](double modulus) {
        end = std::min(end, moduli.front() + 0.97 * (modulus - moduli.front()));
    };
    for (const found_singularity& each : circle.inside) {
        const std::complex<double> near(static_cast<double>(each.offset.re), static_cast<double>(each.offset.im));
        const double modulus = std::abs(near);
        if (modulus > end) {
            break;
        }
        const auto is_at = [&](const movable_point& of) {
            return std::abs(rounded_midpoint(of.place) - near) < 1e-8 * modulus;
        };
        if (std::ranges::any_of(all, is_at)) {
            continue;  // found by another component
        }
        const bool is_behind = std::ranges::any_of(all, [&](const movable_point& of) {
            return std::abs(std::arg(near / rounded_midpoint(of.place))) < least_angle_of_rays;
        });
        if (is_behind && !given) {
            cut_before(modulus);
            break;
        }
        if (watch) {
            watch(plane_step::disc);
        }
        try {
            all.push_back(movable_point_near(system, atlas, shown, exact_point(near)));
        } catch (const error& missing) {
            const bool at_nearest = all.empty() || modulus < moduli.front() * (1 + 1e-6);
            if (at_nearest || given || missing.kind() != error_kind::undecided) {
                throw;
            }
            cut_before(modulus);
            break;
        }
        moduli.push_back(modulus);
        end = std::min(end, modulus * (1 + part_of_reach * all.back().reach));
    }
    if (end < circle.rho) {
        if (given) {
            refuse_law("has no proved law up to " + std::to_string(circle.rho) +
                       ": the expansion at a singularity reaches to " + std::to_string(end) +
                       "; write a smaller RHO as --within");
        }
        // Of the gaps between the moduli, the last that is wide, else the widest.
        std::erase_if(moduli, [&](double each) { return each >= end; });
        double widest = 0;
        for (std::size_t i = 0; i < moduli.size(); ++i) {
            const double next = i + 1 < moduli.size() ? moduli[i + 1] : end;
            const double gap = next - moduli[i];
            if (gap >= std::min(widest, 0.3 * (end - moduli.front())) && gap > 1e-9 * end) {
                widest = std::max(widest, gap);
                circle.rho = few_bits_after(moduli[i], next, next == end ? part_of_slit : 0.5);
            }
        }
    }
    std::erase_if(all, [&](const movable_point& each) {
        return certainly_less(exactly(circle.rho), modulus_in_balls(each.place));
    });
    return all;
}

covering_tip tip_of(const movable_point& of) {
    const std::complex<double> place = rounded_midpoint(of.place);
    covering_tip tip{place, std::abs(place) * part_of_reach * of.reach, std::abs(of.base) * (1 + 1e-12)};
    if (!(std::abs(of.base - place) < tip.radius)) {
        throw precision_exhausted("the base of a singularity");
    }
    return tip;
}

tip_bound bounds_of_tips(const std::vector<movable_point>& all) {
    return [&all](std::size_t k, const complex_ball& offset) {
        return all[k].bound_over(modulus_in_balls(complex_ball(1) - offset / all[k].place));
    };
}

}  // namespace libration::ode
