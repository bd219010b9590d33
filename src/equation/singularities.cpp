// libration singularities: the map of the complex t-plane, for any problem.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "equation/problem_options.hpp"
#include "equation/problem_radius.hpp"
#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/first_order_form.hpp"
#include "libration/ode/proved/proved_singularity.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/constants.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/progress.hpp"
#include "text/cell.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr long usual_digits = 15;
constexpr long most_digits = 1000;
constexpr int exponent_digits = 9;

struct singularities_options {
    problem_options problem;
    output_options output;
    std::optional<std::string> within, digits;
    bool prove = false, check = false;

    std::optional<double> radius() const {
        return within ? std::optional(from_exact<double>(positive_number_of("--within", *within))) : std::nullopt;
    }
};

// Removes rounding errors from values that are 0 or integers: relative to `size`.
double tidied(double x, double size) {
    const double nearest = std::round(x);
    return std::abs(x - nearest) < 1e-7 * size ? nearest + 0.0 : x;
}

// Empty if it has no value in the range of double.
cell small_cell(double x, double size) {
    return std::isfinite(x) ? number_cell(fmt::format("{:.{}g}", tidied(x, size), exponent_digits)) : cell();
}

double size_of_exponent(const std::complex<double>& z) { return std::max(1.0, std::abs(z)); }

std::string complex_words(const std::complex<double>& z) {
    const double re = tidied(z.real(), size_of_exponent(z));
    const double im = tidied(z.imag(), size_of_exponent(z));
    return im == 0 ? fmt::format("{:.9g}", re) : fmt::format("{:.9g}{:+.9g}i", re, im);
}

std::string joined(const std::vector<std::complex<double>>& all) {
    std::string words;
    for (const auto& each : all) {
        words += (words.empty() ? "" : " ") + complex_words(each);
    }
    return words;
}

std::vector<column> columns_of_map() {
    return {{"position_re", "time of the singularity, real part"},
            {"position_im", "time of the singularity, imaginary part"},
            {"modulus", "distance from the initial point"},
            {"uncertainty", "error bound of the position as printed"},
            {"kind", "pole, with branches, algebraic, logarithm, complex power, or unclear if no power is found"},
            {"exponent_re", "exponent p of the leading behaviour, real part"},
            {"exponent_im", "imaginary part"},
            {"rigour",
             "proved: that this unknown is singular within the uncertainty, and a pole by a zero of its inverse; other "
             "kinds are heuristic"},
            {"unknown", "the unknown that is singular there, with that behaviour"},
            {"coefficient_re", "c in c (t - t*)^p, or c (1 - (t - t0)/(t* - t0))^p if p is not an integer"},
            {"coefficient_im", "imaginary part"},
            {"resonances", "r: perturbations grow like (t - t*)^(p + r)"},
            {"evidence", "what proves it, or why it is not proved"}};
}

// Whether the discs of two proofs of one unknown intersect.
bool discs_meet(const ode::proved_singularity& a, std::size_t of_a, const ode::proved_singularity& b,
                std::size_t of_b) {
    const complex_number<mpfr> apart{mpfr(a.centre.re - b.centre.re), mpfr(a.centre.im - b.centre.im)};
    return of_a == of_b && modulus_of(apart) <= midpoint_of(a.reach.exact()) + midpoint_of(b.reach.exact());
}

// Another search and another proof, with more digits: as many rows, each of which intersects one of the first.
void check_positions(const singularities_options& options, const ode::explicit_system& system, long digits,
                     const ode::singularity_map& map, const std::vector<ode::proved_singularity>& first) {
    ode::singularity_request request;
    request.digits = digits + ode::more_digits_of_second_proof + 3;
    request.within = options.radius();
    const auto again = ode::singularities_of(system, request);
    const auto second = ode::prove_singularities(system, again.all, digits + ode::more_digits_of_second_proof, {},
                                                 ode::proof_route::second());
    for (const auto& each : second) {
        if (!each.refusal.empty()) {
            throw error(error_kind::undecided, "--check", "", "has no second proof: the problem " + each.refusal);
        }
    }
    const precision_scope scope(request.digits + 30);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (!first[i].refusal.empty()) {
            continue;
        }
        bool met = first.size() == second.size();
        for (std::size_t j = 0; met && j < second.size(); ++j) {
            if (discs_meet(first[i], map.all[i].unknown, second[j], again.all[j].unknown)) {
                break;
            }
            met = j + 1 < second.size();
        }
        if (!met) {
            throw std::runtime_error(
                fmt::format("the two proofs disagree on the singularity near {} + {}i: {} discs by the first, one "
                            "within {} of it, {} by the second, none of which meets that",
                            to_decimal(first[i].centre.re, digits), to_decimal(first[i].centre.im, digits),
                            first.size(), upper_bound_text(first[i].reach.exact()), second.size()));
        }
    }
}

/// The rows, and how many of them were to be proved and are not.
struct map_rows {
    table data;
    std::size_t refused = 0;
};

// A bound of the distance between a position and its decimals: its own error, and their rounding.
std::string uncertainty_of(const complex_number<ball>& time, const ball& error, const cell& re, const cell& im) {
    const ball of_re = time.re - from_rational<ball>(read_exact(re.text()).coefficient);
    const ball of_im = time.im - from_rational<ball>(read_exact(im.text()).coefficient);
    return upper_bound_text(sqrt(ball(of_re * of_re + of_im * of_im)) + error);
}

map_rows rows_of_map(const singularities_options& options, const ode::explicit_system& system,
                     const ode::singularity_map& map, long digits) {
    map_rows rows{table(columns_of_map())};
    const auto names = ode::first_order_form(system).names;
    const precision_scope scope(digits + 30);
    const mpfr origin = ode::constant_value<mpfr>::of(system.point());
    const ball enclosed_origin = ode::constant_value<ball>::of(system.point());
    std::vector<ode::proved_singularity> proofs;
    if (options.prove) {
        progress shown("singularities", map.all.size());
        const auto checked = checked_products(options.check);
        proofs = ode::prove_singularities(system, map.all, digits, [&] { shown.step(); });
        if (options.check) {
            check_positions(options, system, digits, map, proofs);
        }
    }
    for (std::size_t i = 0; i < map.all.size(); ++i) {
        const auto& each = map.all[i];
        const bool proved = options.prove && proofs[i].refusal.empty();
        rows.refused += options.prove && !proved ? 1 : 0;
        const cell re = decimal_cell(mpfr(origin + each.offset.re), digits);
        const cell im = decimal_cell(each.offset.im, digits);
        const ball error = proved ? proofs[i].reach.exact() : ball(each.uncertainty);
        const std::string evidence = !options.prove ? ""
                                     : proved       ? words_of_evidence(system, proofs[i])
                                                    : "not proved: it " + proofs[i].refusal;
        const auto number = [&](double x, double size) {
            return each.kind == ode::singularity_kind::unclear ? cell() : small_cell(x, size);
        };
        const double size = std::abs(each.coefficient);
        rows.data.add_row({re, im, decimal_cell(mpfr(modulus_of(each.offset)), digits),
                           number_cell(uncertainty_of(
                               {ball(enclosed_origin + ball(each.offset.re)), ball(each.offset.im)}, error, re, im)),
                           ode::words_of(each.kind, each.exponent.real()),
                           number(each.exponent.real(), size_of_exponent(each.exponent)),
                           number(each.exponent.imag(), size_of_exponent(each.exponent)),
                           proved ? "proved" : "heuristic", names[each.unknown], number(each.coefficient.real(), size),
                           number(each.coefficient.imag(), size), joined(each.resonances), evidence});
    }
    return rows;
}

std::string number_words(const std::string& name, const cell& re, const cell& im) {
    if (re.is_empty() || im.is_empty()) {
        return "";
    }
    return fmt::format(", {} {}", name, re.text()) + (im.text() == "0" ? "" : fmt::format(" + {}i", im.text()));
}

std::string text_of(const table& data, const ode::singularity_map& map) {
    std::string text;
    if (map.entire) {
        return "none: the equation is linear with entire coefficients\n";
    }
    for (const auto& row : data.rows()) {
        const bool real = row[1].text() == "0";
        text += fmt::format("{}{}  +- {}  {}  {}: {}{}{}\n", row[0].text(),
                            real ? ""
                                 : fmt::format(" {} {}i", row[1].text().starts_with("-") ? "-" : "+",
                                               row[1].text().substr(row[1].text().starts_with("-") ? 1 : 0)),
                            row[3].text(), row[7].text(), row[8].text(), row[4].text(),
                            number_words("exponent", row[5], row[6]), number_words("coefficient", row[9], row[10]));
        if (!row[11].is_empty()) {
            text += fmt::format("    resonances {}\n", row[11].text());
        }
        if (!row[12].is_empty()) {
            text += fmt::format("    {}\n", row[12].text());
        }
    }
    return text + fmt::format(
                      "within {:.6g} of the initial point, on the branch reached along rays from it; {} expansion "
                      "points{}\n",
                      map.within, map.points,
                      map.complete ? ""
                                   : fmt::format(", {} cells unresolved: singularities "
                                                 "accumulate, possibly a natural boundary",
                                                 map.unexplained));
}

int run_singularities(const singularities_options& options) {
    options.output.check();
    if (!options.problem.given()) {
        options.problem.require_problem();
        throw input_error("no problem is given: add --problem P");
    }
    if (options.check && !options.prove) {
        throw input_error("--check compares two proofs and requires --prove: add it, or leave --check out");
    }
    const ode::explicit_system system = options.problem.choose();
    const long digits = options.digits ? digits_of(options.digits) : usual_digits;
    if (digits > most_digits) {
        throw input_error("--digits", *options.digits, "is more than 1000", "write a smaller number");
    }
    ode::singularity_request request;
    request.digits = options.prove ? digits + 3 : digits;
    request.within = options.radius();
    const auto map = naming_option("--problem", [&] { return ode::singularities_of(system, request); });
    if (map.all.empty() && !map.entire && !options.within) {
        throw error(
            error_kind::undecided, "--problem", *options.problem.problem(),
            fmt::format(
                "has no known singularity within {:.6g} of its initial point, which does not prove that there is "
                "none: --within RHO searches a larger disc",
                map.within));
    }
    const map_rows rows = rows_of_map(options, system, map, digits);
    options.output.write(rows.data, text_of(rows.data, map));
    if (rows.refused != 0) {
        throw error(error_kind::undecided, "--prove", "",
                    fmt::format("leaves {} of {} singularities unproved: their rows are heuristic and give the reason",
                                rows.refused, map.all.size()));
    }
    return 0;
}

}  // namespace

subcommand singularities_command(CLI::App& program) {
    const auto options = std::make_shared<singularities_options>();
    CLI::App* command = program.add_subcommand(
        "singularities", "the singularities of any problem in the complex t-plane, proved on request");
    options->problem.add_to(*command);
    options->output.add_to(*command);
    command
        ->add_option("--within", options->within,
                     "the distance from the initial point (default: twice that of the nearest)")
        ->type_name("RHO");
    command->add_flag("--prove", options->prove, "encloses each in a disc, to D digits (theorem C)");
    command->add_option("--digits", options->digits, "digits of the positions (15)")->type_name("D");
    command->add_flag("--check", options->check,
                      "with --prove: compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_singularities(*options); }};
}

}  // namespace libration
