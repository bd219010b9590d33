// Is the verdict on published lists of coefficients right, and how sharp is it?
#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "libration/convergence/coefficient_list.hpp"
#include "libration/convergence/radius_answers.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/problem_family.hpp"
#include "shared/plan_of_values.hpp"
#include "text/input_error.hpp"
#include "text/table.hpp"

namespace libration::studies {

namespace series_verdicts_study {

namespace {

constexpr long working_digits = 60;
constexpr long printed_digits = 20;
constexpr int uncertainty_digits = 3;

// What is known of a list: a row of problems/series/published.csv.
using known_facts = std::map<std::string, std::string>;

std::vector<known_facts> all_known() {
    std::vector<known_facts> all;
    for (const catalogue_entry& entry : series_catalogue()) {
        if (entry.name == "published") {
            const table data = from_csv(std::string(entry.text));
            for (const table_row_cells& row : data.rows()) {
                known_facts& facts = all.emplace_back();
                for (std::size_t i = 0; i < row.size(); ++i) {
                    facts[data.columns()[i].name] = row[i].text();
                }
            }
        }
    }
    return all;
}

convergence::radius_answers verdict_on_list(const std::string& name) {
    for (const catalogue_entry& entry : series_catalogue()) {
        if (entry.name == name) {
            convergence::listed_series list;
            list.written = convergence::read_coefficients(entry.text);
            std::vector<mpfr> values;
            for (const exact& number : list.written) {
                values.push_back(from_exact<mpfr>(number));
            }
            list.coefficients = series::power_series<mpfr>(std::move(values));
            return convergence::answers_of({{list}}, {scalar_kind::arbitrary, working_digits});
        }
    }
    throw input_error("--series", name, "is not a published list", "see problems/series");
}

struct verdict_row {
    known_facts known;
    convergence::list_verdict found;
    convergence::printed_estimate shown;

    std::optional<mpfr> fact(const char* name) const {
        const std::string& text = known.at(name);
        return text.empty() ? std::nullopt : std::optional(from_exact<mpfr>(read_exact(text)));
    }
    std::optional<mpfr> radius() const {
        return found.growth == convergence::growth_class::zero ? std::optional(mpfr(0)) : found.radius;
    }
    std::optional<mpfr> error() const {
        return radius() ? std::optional(mpfr(abs(mpfr(*radius() - *fact("radius"))))) : std::nullopt;
    }
    // Whether the published value, with its own uncertainty, is within that of the verdict.
    bool holds() const { return error() && *error() <= found.uncertainty + *fact("radius_error"); }
};

const column_list<verdict_row>& columns() {
    using row = verdict_row;
    const auto known = [](const char* name) { return [name](const row& r) { return read_cell(r.known.at(name)); }; };
    static const column_list<row> all{
        {"list", "name in problems/series", known("name")},
        {"quantity", "the quantity that the list enumerates or expands", known("quantity")},
        {"order", "N, last power of the list", [](const row& r) { return cell(r.found.pattern.order); }},
        {"radius", "by the verdict",
         [](const row& r) { return r.radius() && *r.radius() == 0 ? cell(0) : number_cell(r.shown.radius); }},
        {"uncertainty", "of it, by the verdict", [](const row& r) { return number_cell(r.shown.uncertainty); }},
        {"published", "radius, from the source", known("radius")},
        {"published_error", "its uncertainty; 0 for an exact value", known("radius_error")},
        {"relative_error", "|radius/published - 1|; 0 for a radius of 0",
         [](const row& r) {
             return r.error() ? decimal_cell(*r.fact("radius") == 0 ? *r.error() : mpfr(*r.error() / *r.fact("radius")),
                                             uncertainty_digits)
                              : cell();
         }},
        {"relative_uncertainty", "uncertainty/radius",
         [](const row& r) {
             return r.found.radius ? decimal_cell(mpfr(r.found.uncertainty / *r.found.radius), uncertainty_digits)
                                   : cell();
         }},
        {"holds", "whether the published radius is within the uncertainties",
         [](const row& r) { return cell(r.holds() ? "yes" : "no"); }},
        {"exponent", "by the verdict", [](const row& r) { return number_cell(r.shown.exponent); }},
        {"exponent_uncertainty", "of it, by the verdict",
         [](const row& r) { return number_cell(r.shown.exponent_uncertainty); }},
        {"published_exponent", "from the source", known("exponent")},
        {"kind", "of the singularity, by the verdict",
         [](const row& r) {
             return cell(r.found.kind == convergence::singularity_kind::unknown ? ""
                                                                                : convergence::name_of(r.found.kind));
         }},
        {"gevrey", "order of the growth of a list of radius 0",
         [](const row& r) { return cell(r.found.gevrey ? r.found.gevrey->str() : ""); }},
        {"action", "where its Borel transform is singular",
         [](const row& r) {
             return r.found.action ? decimal_cell(r.found.action->re, uncertainty_digits + 10) : cell();
         }},
        {"data", "where the coefficients are from", known("data")},
        {"source", "of the published values", known("published")},
    };
    return all;
}

std::optional<known_facts> known_list(const std::string& name) {
    const auto all = all_known();
    const auto at = std::ranges::find_if(all, [&](const known_facts& each) { return each.at("name") == name; });
    return at == all.end() ? std::nullopt : std::optional(*at);
}

// The lists as the values of an axis.
const problem_family& lists_as_problem() {
    static const problem_family result{"lists",
                                       {{.name = "list",
                                         .option = "--series",
                                         .help = "names of problems/series",
                                         .forms = "a,b,c, or all",
                                         .form = axis_form::words,
                                         .remedy = "write all or names of problems/series such as walks_square",
                                         .check =
                                             [](const exact& word) {
                                                 if (word.text != "all" && !known_list(word.text)) {
                                                     throw error(error_kind::argument, "list", word.text,
                                                                 "is not a published list");
                                                 }
                                             },
                                         .coordinate = "list"}}};
    return result;
}

std::vector<known_facts> chosen_lists(const std::vector<exact>& words) {
    std::vector<known_facts> chosen;
    for (const exact& word : words) {
        if (word.text == "all") {
            const auto all = all_known();
            chosen.insert(chosen.end(), all.begin(), all.end());
        } else {
            chosen.push_back(*known_list(word.text));
        }
    }
    return chosen;
}

verdict_row row_of(const known_facts& known) {
    const auto answers = verdict_on_list(known.at("name"));
    return {known, answers.verdict, convergence::printed(answers.rows.front(), printed_digits)};
}

study_plan plan(const study_request& request) {
    const auto lists = chosen_lists(request.values.of("list"));
    return plan_of_cells(
        {head_of("", {scalar_kind::arbitrary, working_digits}, columns())}, {"list"}, lists.size(),
        [lists](std::size_t i) {
            return cell_inputs{{"list", lists[i].at("name")}};
        },
        [lists](std::size_t i) {
            const precision_scope scope(working_digits);
            return std::vector<table>{make_table(columns(), std::vector<verdict_row>{row_of(lists[i])})};
        });
}

}  // namespace
}  // namespace series_verdicts_study

const study& series_verdicts() {
    using namespace series_verdicts_study;
    static const study result{
        .name = "series_verdicts",
        .title = "Published lists of coefficients",
        .question = "Is the verdict on published lists of coefficients right, and how sharp is it?",
        .reading =
            "Published enumerations and perturbation series, each with the verdict on its list alone: no position, "
            "exponent or method is chosen for it. The relative error is the distance from the published radius, which "
            "is "
            "itself an estimate for most lattices; the uncertainty is the one that the verdict states.",
        .of = &lists_as_problem(),
        .parameters = {{"--series", "all", "names of problems/series"}},
        .quick = {{"--series", "ising_square_low,walks_triangular", ""}},
        .seconds = 15,
        .plan = plan};
    return result;
}

}  // namespace libration::studies
