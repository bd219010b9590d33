// Is the verdict on the coefficients of solutions right, where the law of all their coefficients is proved?
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "shared/list_answers.hpp"

namespace libration::studies {

namespace series_against_laws_study {

namespace {

constexpr long proved_digits_of_truth = 45;  // more than the verdict has

// A problem, and the unknown whose coefficients are tested.
struct tested_problem {
    const char* name;
    const char* text;
    const char* show;
};

constexpr std::array<tested_problem, 16> problems{{
    {"tangent", "y' = 1 + y^2; y(0) = 0", "y"},
    {"riccati", "y' = 1 + t - y + 2*y^2; y(0) = 1/2", "y"},
    {"airy_riccati", "y' = t + y^2; y(0) = 0", "y"},
    {"painleve_1", "y'' = 6*y^2 + t; y(0) = 1; y'(0) = 0", "y"},
    {"painleve_2", "y'' = 2*y^3 + t*y + 1/3; y(0) = 1; y'(0) = -1/2", "y"},
    {"quartic", "x'' = -x^3; x(0) = 1; x'(0) = 1/2", "x"},
    {"pendulum", "th'' = -sin(th); th(0) = 0; th'(0) = sqrt(17/5)", "th"},
    {"abel", "y' = y^3 + t; y(0) = 1", "y"},
    {"abel_4", "y' = y^4 + t; y(0) = 1", "y"},
    {"root", "y' = (2 + t)/y; y(0) = 1", "y"},
    {"van_der_pol", "x'' = 2*(1-x^2)*x' - x; x(0) = 1; x'(0) = 0", "x"},
    {"legendre", "(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2", "y"},
    {"gegenbauer", "(1-t^2)*y'' - 5/3*t*y' + y = 0; y(0) = 1; y'(0) = 1", "y"},
    {"exponential", "y' = exp(y); y(0) = 0", "y"},
    {"blasius", "f''' = -f*f''/2; f(0) = 0; f'(0) = 0; f''(0) = 1", "f"},
    {"lotka_volterra", "x' = x - x*y; y' = x*y - y; x(0) = 2; y(0) = 1", "x"},
}};

const tested_problem* problem_of(const std::string& name) {
    const auto* const found =
        std::ranges::find_if(problems, [&](const tested_problem& each) { return name == each.name; });
    return found == problems.end() ? nullptr : found;
}

// What the law proves of the nearest singularities.
struct proved_truth {
    std::optional<mpfr> radius;
    std::string exponent, kind;
    int count = 0;
};

proved_truth truth_of(const ode::explicit_system& system, const tested_problem& of) {
    const proved_law law(system, {.show = of.show}, proved_digits(proved_digits_of_truth));
    proved_truth result;
    if (const auto radius = law.radius(proved_digits_of_truth).decimal) {
        result.radius = from_exact<mpfr>(read_exact(radius->text));
    }
    const answer all = law.singularities(proved_digits_of_truth);
    const auto modulus = [&](std::size_t row) { return std::stod(all.at(row, "modulus")); };
    std::size_t nearest = 0;
    for (std::size_t row = 1; row < all.rows.size(); ++row) {
        nearest = modulus(row) < modulus(nearest) ? row : nearest;
    }
    for (std::size_t row = 0; row < all.rows.size(); ++row) {
        result.count += modulus(row) <= modulus(nearest) * (1 + 1e-12) ? 1 : 0;
    }
    result.exponent = all.at(nearest, "exponent");
    result.kind = without_commas(all.at(nearest, "kind"));
    return result;
}

struct tested_row {
    const tested_problem* of;
    answered_list found;
    proved_truth truth;

    std::optional<mpfr> error() const {
        return found.found.radius && truth.radius ? std::optional(mpfr(abs(mpfr(*found.found.radius - *truth.radius))))
                                                  : std::nullopt;
    }
    std::optional<mpfr> exponent_error() const {
        if (!found.found.exponent || truth.exponent.empty() || truth.exponent.find('i') != std::string::npos) {
            return std::nullopt;
        }
        return mpfr(abs(mpfr(*found.found.exponent - from_exact<mpfr>(read_exact(truth.exponent)))));
    }
};

const column_list<tested_row>& columns() {
    using row = tested_row;
    constexpr int few = 3;
    const auto part_of_radius = [](const row& r, const std::optional<mpfr>& x) {
        return x && r.truth.radius ? decimal_cell(mpfr(*x / *r.truth.radius), few) : cell();
    };
    static const column_list<row> all{
        {"problem", "its name in this table", [](const row& r) { return r.of->name; }},
        {"order", "N: coefficients 0 .. N are known to the verdict", [](const row& r) { return r.found.order; }},
        {"radius", "by the verdict (heuristic); empty if it has none",
         [](const row& r) { return decimal_cell(r.found.found.radius, 20); }},
        {"proved_radius", "by the law of all coefficients (proved)",
         [](const row& r) { return decimal_cell(r.truth.radius, 20); }},
        {"relative_error", "|radius/proved_radius - 1|", [=](const row& r) { return part_of_radius(r, r.error()); }},
        {"relative_uncertainty", "that the verdict states, divided by proved_radius",
         [=](const row& r) {
             return part_of_radius(r, r.found.found.radius ? std::optional(r.found.found.uncertainty) : std::nullopt);
         }},
        {"holds", "whether the proved radius is within the uncertainty; empty without a radius",
         [](const row& r) {
             const auto error = r.error();
             return error ? cell(*error <= r.found.found.uncertainty ? "yes" : "no") : cell();
         }},
        {"exponent", "by the verdict, of (1 - x/x0)^exponent, 0 for a logarithm",
         [](const row& r) { return decimal_cell(r.found.found.exponent, 10); }},
        {"exponent_uncertainty", "that the verdict states",
         [](const row& r) {
             return r.found.found.exponent ? decimal_cell(r.found.found.exponent_uncertainty, few) : cell();
         }},
        {"proved_exponent", "of the nearest singularity (proved)",
         [](const row& r) { return read_cell(r.truth.exponent); }},
        {"exponent_error", "|exponent - proved_exponent|",
         [](const row& r) { return decimal_cell(r.exponent_error(), few); }},
        {"kind", "by the verdict", [](const row& r) { return convergence::name_of(r.found.found.kind); }},
        {"proved_kind", "of the nearest singularity (proved)", [](const row& r) { return r.truth.kind; }},
        {"count", "nearest singularities by the verdict; 0 where it does not tell",
         [](const row& r) { return r.found.found.count; }},
        {"proved_count", "those at the least distance (proved)", [](const row& r) { return r.truth.count; }},
        {"equation", "with initial values", [](const row& r) { return without_commas(r.of->text); }},
        {"unknown", "whose coefficients are tested", [](const row& r) { return r.of->show; }},
    };
    return all;
}

// The problems as the values of an axis.
const problem_family& problems_as_family() {
    static const problem_family result{"problems with proved laws",
                                       {{.name = "equation",
                                         .option = "--equations",
                                         .help = "names of problems with proved laws",
                                         .forms = "a,b,c, or all",
                                         .form = axis_form::words,
                                         .remedy = "write all or some of the names of the study such as abel,legendre",
                                         .check =
                                             [](const exact& word) {
                                                 if (word.text != "all" && problem_of(word.text) == nullptr) {
                                                     throw error(error_kind::argument, "list", word.text,
                                                                 "is not a problem of the study");
                                                 }
                                             },
                                         .coordinate = "equation"}}};
    return result;
}

std::vector<tested_problem> chosen_of(const std::vector<exact>& words) {
    std::vector<tested_problem> chosen;
    for (const exact& word : words) {
        if (word.text == "all") {
            chosen.insert(chosen.end(), problems.begin(), problems.end());
        } else {
            chosen.push_back(*problem_of(word.text));
        }
    }
    return chosen;
}

std::vector<tested_row> rows_of(const tested_problem& of, const std::vector<int>& orders, const scalar_spec& scalar) {
    const ode::explicit_system system(ode::parse(of.text));
    const proved_truth truth = truth_of(system, of);
    const precision_scope scope(scalar.digits + guard_of_lists);
    const auto lists = lists_about_start(system, orders.back(), scalar.digits + guard_of_lists);
    std::vector<tested_row> rows;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        if (system.unknowns()[i].name == of.show) {
            for (const int order : orders) {
                rows.push_back({problem_of(of.name),
                                answers_to(of.show, lists[i].coefficients(), order, scalar, is_verdict, 1).front(),
                                truth});
            }
        }
    }
    return rows;
}

study_plan plan(const study_request& request) {
    const auto chosen = chosen_of(request.values.of("equation"));
    const auto orders = orders_from(request, least_order_of_lists, "is too short a list for a verdict");
    const scalar_spec scalar = request.scalar.value_or(read_scalar("mpfr:30"));
    return plan_of_cells(
        {head_of("", scalar, columns())}, {"equation"}, chosen.size(),
        [chosen](std::size_t i) {
            return cell_inputs{{"equation", chosen[i].name}};
        },
        [chosen, orders, scalar](std::size_t i) {
            const precision_scope scope(scalar.digits + guard_of_lists);
            return std::vector<table>{make_table(columns(), rows_of(chosen[i], orders, scalar))};
        });
}

}  // namespace
}  // namespace series_against_laws_study

const study& series_against_laws() {
    using namespace series_against_laws_study;
    static const study result{
        .name = "series_against_laws",
        .title = "The verdict on coefficients against proved laws",
        .question = "How far is the verdict on coefficients from the proved law of all of them?",
        .reading =
            "Coefficients of solutions whose law is proved: radius, exponent and kind of the nearest singularities are "
            "theorems. The verdict is from the first N + 1 coefficients alone. Filled marks are its true error, empty "
            "ones "
            "the uncertainty that it states; a filled mark to the right of the empty one is a wrong statement.",
        .of = &problems_as_family(),
        .parameters = {{"--equations", "all", "names of problems with proved laws"},
                       {"--orders", "40,80", "N, last powers of the lists under test"},
                       {"--scalar", "mpfr:30", "arithmetic of the lists under test"}},
        .quick = {{"--equations", "tangent,riccati", ""}, {"--orders", "12", ""}},
        .seconds = 60,
        .plan = plan};
    return result;
}

}  // namespace libration::studies
