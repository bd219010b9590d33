#include "motion/radius_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libration/convergence/radius_verdict.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

using namespace series;
using namespace convergence;

namespace {

const std::vector<column> radius_columns{{"method", ""},      {"radius", ""},         {"uncertainty", ""},
                                         {"exact", ""},       {"relative_error", ""}, {"position_re", ""},
                                         {"position_im", ""}, {"kind", ""},           {"count", ""},
                                         {"note", ""},        {"exponent", ""},       {"exponent_uncertainty", ""},
                                         {"rigour", ""}};

constexpr long uncertainty_digits = 3;

std::string relative_error(const std::string& radius, const known_radius& known, long digits) {
    if (radius.empty() || !known.true_size) {
        return "";
    }
    const precision_scope scope(digits + radius_guard_digits);
    return to_decimal(mpfr(abs(from_exact<mpfr>(read_exact(radius)) / *known.true_size - 1)), uncertainty_digits);
}

// Without commas, so that a reader without support for quotes is also correct.
std::string note_of(const radius_estimate<mpfr>& estimate) {
    std::string note = estimate.note;
    std::replace(note.begin(), note.end(), ',', ';');
    return note;
}

table_row_cells row_of(const radius_estimate<mpfr>& estimate, const known_radius& known, long digits) {
    const printed_estimate shown = printed(estimate, digits);
    return {estimate.method,
            number_cell(shown.radius),
            number_cell(shown.uncertainty),
            number_cell(known.text),
            number_cell(relative_error(shown.radius, known, digits)),
            number_cell(shown.position_re),
            number_cell(shown.position_im),
            estimate.kind == singularity_kind::unknown ? "" : name_of(estimate.kind),
            estimate.count > 0 ? cell(estimate.count) : cell(),
            note_of(estimate),
            number_cell(shown.exponent),
            number_cell(shown.exponent_uncertainty),
            "heuristic"};
}

// "2 simple poles", "1 pole of order 2", "4 logarithms", "3 algebraic branch points", "2 branch points".
std::string what_in_words(const radius_estimate<mpfr>& estimate) {
    const bool one = estimate.count == 1;
    const char* const plural = one ? "" : "s";
    std::string what = one ? "singularity" : "singularities";
    if (estimate.kind == singularity_kind::pole) {
        const rational order = -simple_exponent(estimate).value_or(rational(-1));
        what =
            order == 1 ? fmt::format("simple pole{}", plural) : fmt::format("pole{} of order {}", plural, order.str());
    } else if (estimate.kind == singularity_kind::logarithm) {
        what = fmt::format("logarithm{}", plural);
    } else if (estimate.kind == singularity_kind::algebraic) {
        what = fmt::format("algebraic branch point{}", plural);
    } else if (estimate.kind == singularity_kind::branch) {
        what = fmt::format("branch point{}", plural);
    }
    return estimate.count > 0 ? fmt::format("{} {}", estimate.count, what) : what;
}

// "2 simple poles at 1.57 and the point symmetric to it": number, kind and position of the nearest singularities.
std::string nearest_in_words(const radius_estimate<mpfr>& estimate, const table_row_cells& row) {
    if (estimate.kind == singularity_kind::boundary) {
        return "the whole circle of convergence is a boundary";
    }
    std::string words = what_in_words(estimate);
    if (estimate.position) {
        const std::string& re = row[5].text();
        const std::string& im = row[6].text();
        words += " at " + (im == "0" ? re : re == "0" ? im + " i" : fmt::format("{} + {} i", re, im));
        words += estimate.count > 2    ? " and the points symmetric to it"
                 : estimate.count == 2 ? " and the point symmetric to it"
                                       : "";
    }
    return estimate.kind == singularity_kind::unknown ? words + ", of a kind that the coefficients do not decide"
                                                      : words;
}

// `unknown` is the unknown of the verdict; empty for a list without a name.
std::string verdict_in_words(const radius_answers& answers, const known_radius& known, const table& data,
                             const std::string& unknown = "") {
    const radius_estimate<mpfr>& verdict = answers.rows.front();
    const auto& row = data.rows().front();
    std::string text;
    const auto say = [&](const char* name, const std::string& what) { text += fmt::format("{:<14}{}\n", name, what); };
    say("coefficients", fmt::format("n = 0 .. {}; {}{}{}", answers.pattern.order, answers.pattern.text(),
                                    answers.floor.empty() ? "" : "; ", answers.floor));
    if (!unknown.empty()) {
        say("unknown", unknown);
    }
    if (verdict.radius) {
        say("radius", fmt::format("{} +- {}", row[1].text(), row[2].text()));
        say("nearest", nearest_in_words(verdict, row));
        if (verdict.exponent) {
            say("exponent", fmt::format("{} +- {}", row[10].text(), row[11].text()));
        }
    } else {
        say("radius", "none");
    }
    if (!known.text.empty()) {
        say("exact", row[4].is_empty() ? known.text : fmt::format("{}, relative error {}", known.text, row[4].text()));
    }
    say("why", row[9].text());
    return text;
}

// "y; the radii of x, z agree with it; that of w is another one or not found": the unknown of the verdict, and the
// verdicts of the others.
std::string whose_verdict(const std::vector<radius_answers>& all, const std::vector<std::string>& names,
                          std::size_t nearest) {
    const radius_estimate<mpfr>& verdict = all[nearest].rows.front();
    std::vector<std::string> agree;
    std::vector<std::string> differ;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != nearest) {
            const radius_estimate<mpfr>& other = all[i].rows.front();
            const bool agrees = verdict.radius && other.radius &&
                                abs(*verdict.radius - *other.radius) <= verdict.uncertainty + other.uncertainty;
            (agrees ? agree : differ).push_back(names[i]);
        }
    }
    std::string text = names[nearest];
    if (!agree.empty()) {
        text += agree.size() == 1 ? fmt::format("; the radius of {} agrees with it", agree.front())
                                  : fmt::format("; the radii of {} agree with it", fmt::join(agree, ", "));
    }
    if (!differ.empty()) {
        text += differ.size() == 1 ? fmt::format("; that of {} is another one or not found", differ.front())
                                   : fmt::format("; those of {} are others or not found", fmt::join(differ, ", "));
    }
    return text;
}

}  // namespace

table radius_table(const radius_answers& answers, const known_radius& known, long digits) {
    table data(radius_columns);
    for (const auto& answer : answers.rows) {
        data.add_row(row_of(answer, known, digits));
    }
    return data;
}

std::string radius_text(const radius_answers& answers, const known_radius& known, const table& data) {
    const table shown = data.with_columns({0, 1, 2, 4, 9});
    const table tests(shown.columns(), {shown.rows().begin() + 1, shown.rows().end()});
    return verdict_in_words(answers, known, data) + "\n" + to_text(tests) +
           "\nheuristic estimate: finitely many coefficients cannot prove a radius\n";
}

table radius_table_of_unknowns(const std::vector<radius_answers>& all, const std::vector<std::string>& names,
                               std::size_t nearest, const known_radius& known, long digits) {
    auto columns = radius_columns;
    columns.push_back({"unknown", ""});
    table data(columns);
    const auto add = [&](std::size_t unknown, const radius_estimate<mpfr>& answer) {
        auto row = row_of(answer, known, digits);
        row.emplace_back(names[unknown]);
        data.add_row(std::move(row));
    };
    add(nearest, all[nearest].rows.front());
    for (std::size_t unknown = 0; unknown < all.size(); ++unknown) {
        for (const auto& answer : all[unknown].rows) {
            add(unknown, answer);
        }
    }
    return data;
}

std::string radius_text_of_unknowns(const std::vector<radius_answers>& all, const std::vector<std::string>& names,
                                    std::size_t nearest, const known_radius& known, const table& data) {
    const table shown = data.with_columns({radius_columns.size(), 0, 1, 2, 9});
    const table rows(shown.columns(), {shown.rows().begin() + 1, shown.rows().end()});
    return verdict_in_words(all[nearest], known, data, whose_verdict(all, names, nearest)) + "\n" + to_text(rows) +
           "\nheuristic estimate: finitely many coefficients cannot prove a radius\n";
}

}  // namespace libration
