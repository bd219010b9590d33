#include "libration/plane/singularity_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "libration/equation/dependency.hpp"
#include "refined_place.hpp"
#include "scaled_problem.hpp"
#include "singularity_search.hpp"

namespace libration::ode {

namespace {

using wide_complex = complex_number<mpfr>;

// The factor by which the bound grows in each step of a search without a given bound.
constexpr double search_growth = 1.4;
constexpr double farthest_search = 64;
constexpr double part_before_unfollowed = 0.999;

// The images of a singularity under the symmetry, itself first.
std::vector<found_singularity> images_of(const found_singularity& one, int rotation) {
    std::vector<found_singularity> all;
    const precision_scope scope(static_cast<int>(mpfr_get_prec(handle(one.offset.re)) * 30103L / 100'000L) + 2);
    const mpfr size = modulus_of(one.offset);
    const auto known = [&](const wide_complex& z) {
        return std::ranges::any_of(
            all, [&](const found_singularity& each) { return mpfr(modulus_of(each.offset - z)) < size / 1'000'000; });
    };
    for (int turn = 0; turn < rotation; ++turn) {
        for (const bool mirrored : {false, true}) {
            found_singularity image = one;
            const mpfr angle = pi<mpfr>() * (2 * turn) / rotation;
            wide_complex z = mirrored ? wide_complex{one.offset.re, mpfr(-one.offset.im)} : one.offset;
            if (turn != 0) {
                z = z * wide_complex{mpfr(cos(angle)), mpfr(sin(angle))};
            }
            if (abs(z.im) < one.uncertainty) {
                z.im = mpfr(0);
            }
            if (abs(z.re) < one.uncertainty) {
                z.re = mpfr(0);
            }
            if (known(z)) {
                continue;
            }
            image.offset = z;
            const plane_point way = std::polar(1.0, 2 * std::numbers::pi * turn / rotation);
            for (plane_point& each : image.path) {
                each = (mirrored ? std::conj(each) : each) * way;
            }
            all.push_back(std::move(image));
        }
    }
    return all;
}

std::vector<std::string> names_of(const explicit_system& of, const std::vector<std::size_t>& unknowns) {
    std::vector<std::string> names;
    names.reserve(unknowns.size());
    for (const std::size_t i : unknowns) {
        names.push_back(of.unknowns()[i].name);
    }
    return names;
}

// The indices of unknowns of these names and of their lower derivatives.
leaf_group leaves_named(const explicit_system& of, const std::vector<std::string>& names) {
    leaf_group leaves;
    std::size_t leaf = 0;
    for (const unknown_function& each : of.unknowns()) {
        const bool is_in = std::ranges::find(names, each.name) != names.end();
        for (int j = 0; j < each.order; ++j, ++leaf) {
            if (is_in) {
                leaves.push_back(leaf);
            }
        }
    }
    return leaves;
}

// A place that a search found and to which no path could be followed.
struct unfollowed_place {
    double modulus;
    error reason;
};

// The search for the singularities of the unknowns of one strongly connected component: in the system of these and of
// all unknowns that they depend on, in its own units.
class component_search {
public:
    component_search(const explicit_system& whole, const std::vector<std::size_t>& component,
                     const dependency_graph& graph, long most_points, const plane_watch& watch)
        : part_(subsystem_of(whole, graph.closure(component.front()))),
          scaled_(scaled_to_start(part_.system)),
          paths_(part_.system),
          rotation_(std::max(1, tape::about_start(part_.system).stride())),
          most_points_(most_points),
          watch_(watch) {
        const dependency_graph inner(part_.system);
        for (const auto& each : inner.strong_components()) {
            names_.push_back(names_of(part_.system, each));
        }
        // The unknowns that the component depends on precede it.
        own_ = leaves_named(part_.system, names_.back());
        scaled_paths_ = std::make_unique<path_system>(scaled_.system);
        search_ = made_search(rotation_);
    }

    // All distances are from the initial point, in the units of the whole system.
    double first_radius() const { return in_time(search_->first_radius()); }
    void search(double within) { search_->search(in_units(within)); }
    long points() const { return search_->points(); }
    long unexplained() const { return search_->unexplained(); }

    double nearest() const {
        double least = std::numeric_limits<double>::infinity();
        for (const candidate& each : search_->found()) {
            if (is_own(each)) {
                least = std::min(least, in_time(std::abs(each.at)));
            }
        }
        return least;
    }

    // Adds the singularities of the component, in high precision.
    void refine(double within, long digits, std::vector<found_singularity>& all,
                std::vector<unfollowed_place>& unfollowed) const {
        for (const candidate& each : search_->found()) {
            if (!is_own(each) || in_time(std::abs(each.at)) > within) {
                continue;
            }
            candidate in_place = each;
            in_place.at = in_time(each.at);
            in_place.reach = in_time(each.reach);
            for (plane_point& corner : in_place.path) {
                corner = in_time(corner);
            }
            try {
                const auto one = of_whole(refined_place(paths_, in_place, own_, digits));
                for (found_singularity& image : images_of(one, rotation_)) {
                    all.push_back(std::move(image));
                }
            } catch (const error& reason) {
                if (reason.kind() != error_kind::undecided) {
                    throw;
                }
                unfollowed.push_back({std::abs(in_place.at), reason});
            }
            if (watch_) {
                watch_(plane_step::point);
            }
        }
    }

    // Every point of the square, from a search that uses no symmetry except the reflection.
    std::vector<plane_value> portrait(int across, double within, const std::string& of) const {
        const auto search = made_search(1);
        search->search(in_units(std::numbers::sqrt2 * within));
        const auto& unknowns = part_.system.unknowns();
        const auto size = static_cast<int>(scaled_.sizes[static_cast<std::size_t>(
            std::ranges::find(unknowns, of, &unknown_function::name) - unknowns.begin())]);
        const std::size_t leaf = leaves_named(scaled_.system, {of}).front();
        std::vector<plane_value> all;
        for (int row = 0; row < across; ++row) {
            for (int i = 0; i < across; ++i) {
                const plane_point z{within * (2.0 * i / (across - 1) - 1), within * (2.0 * row / (across - 1) - 1)};
                const auto value = search->value_at({in_units(z.real()), in_units(z.imag())}, leaf);
                const plane_point known = value.value_or(0);
                all.push_back({z, {std::ldexp(known.real(), size), std::ldexp(known.imag(), size)}, value.has_value()});
            }
        }
        return all;
    }

private:
    double in_time(double x) const { return std::ldexp(x, static_cast<int>(scaled_.time)); }
    plane_point in_time(const plane_point& z) const { return {in_time(z.real()), in_time(z.imag())}; }
    double in_units(double x) const { return std::ldexp(x, static_cast<int>(-scaled_.time)); }

    bool is_own(const candidate& each) const { return each.group + 1 == names_.size(); }

    std::unique_ptr<singularity_search> made_search(int rotation) const {
        std::vector<leaf_group> groups;
        for (const auto& each : names_) {
            groups.push_back(leaves_named(scaled_.system, each));
        }
        return std::make_unique<singularity_search>(*scaled_paths_, std::move(groups), rotation, most_points_, watch_);
    }

    found_singularity of_whole(found_singularity found) const {
        std::vector<std::complex<double>> exponents(part_.leaves_of_whole, 0);
        for (std::size_t k = 0; k < found.exponents.size(); ++k) {
            exponents[part_.leaves[k]] = found.exponents[k];
        }
        found.exponents = std::move(exponents);
        found.unknown = part_.leaves[found.unknown];
        return found;
    }

    closed_subsystem part_;
    scaled_problem scaled_;
    path_system paths_;
    std::unique_ptr<path_system> scaled_paths_;
    int rotation_;
    long most_points_;
    const plane_watch& watch_;
    std::vector<std::vector<std::string>> names_;  // of the strong components, this one last
    leaf_group own_;
    std::unique_ptr<singularity_search> search_;
};

using component_searches = std::vector<std::unique_ptr<component_search>>;

// The searches of the components whose solutions are not entire by their form.
component_searches searches_of(const explicit_system& system, const singularity_request& request) {
    component_searches all;
    const dependency_graph graph(system);
    auto components = graph.strong_components();
    std::ranges::sort(components);  // by their first unknowns
    for (const auto& each : components) {
        if (!has_entire_solutions(subsystem_of(system, graph.closure(each.front())).system)) {
            all.push_back(std::make_unique<component_search>(system, each, graph, request.most_points, request.watch));
        }
    }
    return all;
}

double nearest_of(const component_searches& all) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& each : all) {
        least = std::min(least, each->nearest());
    }
    return least;
}

bool has_points_left(const component_searches& all, long most_points) {
    return std::ranges::any_of(all, [&](const auto& each) { return each->points() < most_points; });
}

// Runs all searches, as far as requested; returns the distance.
double search_all(const component_searches& all, const singularity_request& request) {
    const auto search = [&](double within) {
        for (const auto& each : all) {
            each->search(within);
        }
        return within;
    };
    if (request.within) {
        return search(*request.within);
    }
    double bound = std::numeric_limits<double>::infinity();
    for (const auto& each : all) {
        const double first = each->first_radius();
        bound = first > 0 ? std::min(bound, first) : bound;
    }
    bound = std::isfinite(bound) ? bound : 1;
    double searched = 0;
    for (double within = bound; within < farthest_search * bound && has_points_left(all, request.most_points);
         within *= search_growth) {
        searched = search(within);
        const double nearest = nearest_of(all);
        if (nearest <= within) {
            return search((request.nearest_alone ? 1.001 : 2) * nearest);
        }
    }
    return searched;
}

// What the progress callback throws, distinguished from the errors of the work.
struct ended_by_watch {
    error of;
};

plane_watch marking(const plane_watch& watch) {
    if (!watch) {
        return {};
    }
    return [&watch](plane_step step) {
        try {
            watch(step);
        } catch (const error& reason) {
            throw ended_by_watch{reason};
        }
    };
}

// Until the progress callback ends it. Without a given distance the map ends before the nearest place that cannot be followed.
void refine_all(const component_searches& searches, const singularity_request& request, singularity_map& map) {
    std::vector<unfollowed_place> unfollowed;
    try {
        for (const auto& each : searches) {
            each->refine(map.within, request.digits, map.all, unfollowed);
        }
    } catch (const ended_by_watch& reason) {
        map.ended = reason.of;
    }
    if (unfollowed.empty()) {
        return;
    }
    const auto& nearest = *std::ranges::min_element(unfollowed, {}, &unfollowed_place::modulus);
    const double end = nearest.modulus * part_before_unfollowed;
    std::erase_if(map.all, [&](const found_singularity& each) { return rounded_size(each.offset) > end; });
    if (request.within || map.all.empty()) {
        throw error(nearest.reason);
    }
    map.within = std::min(map.within, end);
}

bool is_before(const found_singularity& a, const found_singularity& b) {
    const double of_a = rounded_size(a.offset);
    const double of_b = rounded_size(b.offset);
    return std::abs(of_a - of_b) > 1e-9 * of_a ? of_a < of_b
                                               : std::arg(rounded_point(a.offset)) < std::arg(rounded_point(b.offset));
}

}  // namespace

std::string words_of(singularity_kind kind, double exponent) {
    switch (kind) {
        case singularity_kind::pole: return "pole of order " + std::to_string(std::lround(-exponent));
        case singularity_kind::branch_pole:
            return "pole of order " + std::to_string(std::lround(-exponent)) + " with branches";
        case singularity_kind::algebraic: return "algebraic";
        case singularity_kind::logarithm: return "logarithm";
        case singularity_kind::complex_power: return "complex power";
        case singularity_kind::unclear: break;
    }
    return "unclear";
}

namespace {

singularity_map searched(const explicit_system& system, const singularity_request& request) {
    singularity_map map;
    const auto searches = searches_of(system, request);
    map.entire = searches.empty();
    if (map.entire) {
        return map;
    }
    map.within = search_all(searches, request);
    if (request.portrait >= 2) {
        const dependency_graph graph(system);
        const component_search first(system, graph.component_of(0), graph, request.most_points, request.watch);
        map.portrait = first.portrait(request.portrait, map.within, system.unknowns().front().name);
    }
    for (const auto& each : searches) {
        map.points += each->points();
        map.unexplained += each->unexplained();
    }
    refine_all(searches, request, map);
    map.complete = map.unexplained == 0;
    std::ranges::stable_sort(map.all, is_before);
    return map;
}

}  // namespace

singularity_map singularities_of(const explicit_system& system, const singularity_request& request) {
    singularity_request watched = request;
    watched.watch = marking(request.watch);
    try {
        return searched(system, watched);
    } catch (const ended_by_watch& reason) {
        throw error(reason.of);
    }
}

}  // namespace libration::ode
