// The singularities of a solution in the complex plane, proved on request.
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/decimal.hpp"
#include "plane_work.hpp"
#include "taylor_solution.hpp"
#include "words_of_evidence.hpp"

namespace libration {

namespace {

constexpr int exponent_digits = 9;
constexpr int digits_of_distance = 6;
constexpr long guard_digits = 30;
constexpr long digits_of_proof = 3;  ///< of positions, in addition to those that are proved

std::string short_text(double x, int digits) {
    std::array<char, 40> text{};
    auto* const end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

// Removes rounding errors from values that are 0 or integers: relative to `size`.
double tidied(double x, double size) {
    constexpr double whole = 1e-7;
    const double nearest = std::round(x);
    return std::abs(x - nearest) < whole * size ? nearest + 0.0 : x;
}

// Empty if it has no value in the range of double.
answer_value small_value(double x, double size) {
    return {std::isfinite(x) ? short_text(tidied(x, size), exponent_digits) : "", ""};
}

double size_of_exponent(const std::complex<double>& z) { return std::max(1.0, std::abs(z)); }

std::string complex_words(const std::complex<double>& z) {
    const double im = tidied(z.imag(), size_of_exponent(z));
    const std::string real = short_text(tidied(z.real(), size_of_exponent(z)), exponent_digits);
    return im == 0 ? real : real + (im < 0 ? "" : "+") + short_text(im, exponent_digits) + "i";
}

std::string joined(const std::vector<std::complex<double>>& all) {
    std::string words;
    for (const auto& each : all) {
        words += (words.empty() ? "" : " ") + complex_words(each);
    }
    return words;
}

// Whether the discs of two proofs of one unknown intersect.
bool discs_meet(const ode::proved_singularity& a, std::size_t of_a, const ode::proved_singularity& b,
                std::size_t of_b) {
    const complex_number<mpfr> apart{mpfr(a.centre.re - b.centre.re), mpfr(a.centre.im - b.centre.im)};
    return of_a == of_b && modulus_of(apart) <= midpoint_of(a.reach.exact()) + midpoint_of(b.reach.exact());
}

// Another search and another proof, with more digits: as many rows, each of which intersects one of the first.
void require_second_discs(const ode::explicit_system& system, const std::optional<double>& within, long digits,
                          const ode::singularity_map& map, const std::vector<ode::proved_singularity>& first,
                          const ode::plane_watch& watch) {
    ode::singularity_request request;
    request.digits = digits + ode::more_digits_of_second_proof + digits_of_proof;
    request.within = within;
    request.watch = watch;
    const auto again = ode::singularities_of(system, request);
    if (again.ended) {
        throw error(*again.ended);
    }
    ode::proof_route route = ode::proof_route::second();
    route.watch = watch;
    const auto second =
        ode::prove_singularities(system, again.all, digits + ode::more_digits_of_second_proof, {}, route);
    for (const auto& each : second) {
        if (!each.refusal.empty()) {
            throw error(error_kind::undecided, "--check", "", "has no second proof: the problem " + each.refusal);
        }
    }
    const precision_scope scope(request.digits + guard_digits);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (!first[i].refusal.empty()) {
            continue;
        }
        bool met = false;
        for (std::size_t j = 0; !met && first.size() == second.size() && j < second.size(); ++j) {
            met = discs_meet(first[i], map.all[i].unknown, second[j], again.all[j].unknown);
        }
        if (!met) {
            throw std::runtime_error(
                "the two proofs disagree on the singularity near " +
                complex_text(to_decimal(first[i].centre.re, digits), to_decimal(first[i].centre.im, digits)) + ": " +
                std::to_string(first.size()) + " discs by the first, one within " +
                upper_bound_text(first[i].reach.exact()) + " of it, " + std::to_string(second.size()) +
                " by the second, none of which meets that");
        }
    }
}

// Each with a reason if the search has ended.
std::vector<ode::proved_singularity> proofs_of(const ode::explicit_system& system, const ode::singularity_map& map,
                                               const request& how, const ode::plane_watch& watch) {
    if (map.ended) {
        ode::proved_singularity refused;
        refused.refusal = std::string("was not decided: ") + map.ended->what();
        return std::vector(map.all.size(), refused);
    }
    const auto checked = checked_products(how.check);
    std::size_t done = 0;
    std::optional<error> ended;
    const auto show = [&] {
        ++done;
        if (how.progress && !ended) {
            ended =
                undecided_in([&] { how.progress(static_cast<double>(done) / static_cast<double>(map.all.size())); });
        }
    };
    ode::proof_route route;
    route.watch = [&](ode::plane_step step) {
        if (ended) {
            throw error(*ended);
        }
        if (watch) {
            watch(step);
        }
    };
    return ode::prove_singularities(system, map.all, how.printed_digits(), show, route);
}

// A bound of the distance between a position and its decimals: its own error, and their rounding.
std::string uncertainty_of(const complex_number<ball>& time, const ball& error, const std::string& re,
                           const std::string& im) {
    const ball of_re = time.re - from_rational<ball>(read_exact(re).coefficient);
    const ball of_im = time.im - from_rational<ball>(read_exact(im).coefficient);
    return upper_bound_text(sqrt(ball(of_re * of_re + of_im * of_im)) + error);
}

// A number within an error of an enclosure, of which `nearest` is the decimal.
answer_value value_near(const ball& enclosure, const ball& error, std::string nearest) {
    const ball apart = enclosure - from_rational<ball>(read_exact(nearest).coefficient);
    return {std::move(nearest), upper_bound_text(abs(apart) + error)};
}

// `proof` is nullptr if none was requested.
std::vector<answer_value> row_of(const ode::explicit_system& system, const ode::found_singularity& found,
                                 const ode::proved_singularity* proof, long digits) {
    const std::string re = to_decimal(mpfr(ode::constant_value<mpfr>::of(system.point()) + found.offset.re), digits);
    const std::string im = to_decimal(found.offset.im, digits);
    const bool proved = proof != nullptr && proof->refusal.empty();
    const ball error = proved ? proof->reach.exact() : ball(found.uncertainty);
    const complex_number<ball> offset{ball(found.offset.re), ball(found.offset.im)};
    const complex_number<ball> time{ball(ode::constant_value<ball>::of(system.point()) + offset.re), offset.im};
    const std::string evidence = proof == nullptr ? ""
                                 : proved         ? words_of_evidence(system, *proof)
                                                  : "not proved: it " + proof->refusal;
    const auto number = [&](double x, double size) {
        return found.kind == ode::singularity_kind::unclear ? answer_value{} : small_value(x, size);
    };
    const double size_of_p = size_of_exponent(found.exponent);
    const double size_of_c = std::abs(found.coefficient);
    return {value_near(time.re, error, re),
            value_near(time.im, error, im),
            value_near(modulus_of(offset), error, to_decimal(mpfr(modulus_of(found.offset)), digits)),
            {uncertainty_of(time, error, re, im), ""},
            text_value(ode::words_of(found.kind, found.exponent.real())),
            number(found.exponent.real(), size_of_p),
            number(found.exponent.imag(), size_of_p),
            text_value(proved ? "proved" : "heuristic"),
            text_value(ode::first_order_form(system).names[found.unknown]),
            number(found.coefficient.real(), size_of_c),
            number(found.coefficient.imag(), size_of_c),
            text_value(joined(found.resonances)),
            text_value(evidence)};
}

std::string counted(long n, const std::string& what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string extent_of(const ode::singularity_map& map) {
    if (map.entire) {
        return std::string("none: ") + words_of_entire_solutions;
    }
    const std::string unresolved = map.complete ? ""
                                                : ", " + counted(map.unexplained, "cell") +
                                                      " unresolved: singularities accumulate, possibly a "
                                                      "natural boundary";
    return "within " + short_text(map.within, digits_of_distance) +
           " of the initial point, on the branch reached along rays from it; " +
           counted(map.points, "expansion point") + unresolved;
}

}  // namespace

answer taylor_solution::singularities(const std::optional<double>& within, const request& how) const {
    const bool prove = how.scalar.kind == scalar_kind::proved;
    const long digits = how.printed_digits();
    plane_work work(how);
    ode::singularity_request request;
    request.digits = prove ? digits + digits_of_proof : digits;
    request.within = within;
    request.watch = work.watch();
    const auto map = ode::singularities_of(system_, request);
    const bool none_found = map.all.empty() && !map.entire && !map.ended;
    const std::string searched = short_text(map.within, digits_of_distance);
    if (none_found && !within) {
        throw error(error_kind::undecided, error_subject::solution, "",
                    "has no known singularity within " + searched +
                        " of its initial point, which does not prove that there is none");
    }
    answer result{
        .names = {"position_re", "position_im", "modulus", "uncertainty", "kind", "exponent_re", "exponent_im",
                  "rigour", "unknown", "coefficient_re", "coefficient_im", "resonances", "evidence"},
        .rows = {},
        .rigour = prove && !none_found ? "proved" : "heuristic",
        .missing = map.ended,
        .complete = map.complete,
        .notes = {{"extent", map.ended ? "of those " + extent_of(map) : extent_of(map)}}};
    if (none_found) {
        result.notes.push_back({"none", "none found within " + searched + ", which does not prove that there is none"});
    }
    const precision_scope scope(digits + guard_digits);
    const auto proofs = prove ? proofs_of(system_, map, how, work.watch()) : std::vector<ode::proved_singularity>();
    std::size_t refused = 0;
    for (std::size_t i = 0; i < map.all.size(); ++i) {
        result.rows.push_back(row_of(system_, map.all[i], prove ? &proofs[i] : nullptr, digits));
        refused += prove && !proofs[i].refusal.empty() ? 1 : 0;
    }
    if (how.check && prove && !map.ended) {
        result.missing =
            undecided_in([&] { require_second_discs(system_, within, digits, map, proofs, work.watch()); });
    }
    if (refused != 0 && !map.ended) {
        result.missing = error(error_kind::undecided, error_subject::proof, "",
                               "leaves " + std::to_string(refused) + " of " + std::to_string(map.all.size()) +
                                   " singularities unproved: their rows are heuristic and give the reason");
    }
    return result;
}

// Of a disc that ends shortly beyond the place.
std::optional<bool> taylor_solution::is_single_valued(const series_request& of, const complex_number<mpfr>& place,
                                                      const request& how) const {
    constexpr double beyond = 1.01;
    constexpr double near = 1e-4;
    if (!of.corners.empty()) {
        return std::nullopt;
    }
    complex_number<mpfr> from_start = place;
    if (!of.about.empty()) {
        const ode::complex_constant about = point_in(of.about);
        from_start.re += ode::constant_value<mpfr>::of(about.re - system_.point());
        from_start.im += ode::constant_value<mpfr>::of(about.im);
    }
    plane_work work(how);
    ode::singularity_request request;
    request.within = beyond * modulus_of(from_start).convert_to<double>();
    request.watch = work.watch();
    ode::singularity_map map;
    try {
        map = ode::singularities_of(system_, request);
    } catch (const error&) {  // a path that cannot be followed
        return std::nullopt;
    }
    std::optional<bool> single;
    for (const ode::found_singularity& each : map.all) {
        const complex_number<mpfr> apart{mpfr(each.offset.re - from_start.re), mpfr(each.offset.im - from_start.im)};
        if (modulus_of(apart) <= modulus_of(place) * near && each.kind != ode::singularity_kind::unclear) {
            single = single.value_or(true) && each.kind == ode::singularity_kind::pole;
        }
    }
    return single;
}

}  // namespace libration
