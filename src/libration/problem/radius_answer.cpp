#include "libration/problem/radius_answer.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "libration/convergence/exponent_uncertainty.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/decimal.hpp"
#include "verdict_columns.hpp"

namespace libration {

using namespace convergence;

namespace {

constexpr long uncertainty_digits = 3;

using estimate_row = std::vector<answer_value>;

// The columns that the notes repeat.
struct place {
    static constexpr std::size_t radius = 1;
    static constexpr std::size_t exact = 3;
    static constexpr std::size_t relative_error = 4;
    static constexpr std::size_t position_re = 5;
    static constexpr std::size_t position_im = 6;
    static constexpr std::size_t note = 9;
    static constexpr std::size_t exponent = 10;
};

answer_value number_value(std::string text) { return {std::move(text), ""}; }

std::string relative_error(const std::string& found, const std::optional<mpfr>& exact, long digits) {
    if (found.empty() || !exact || isinf(*exact)) {
        return "";
    }
    const precision_scope scope(digits + radius_guard_digits);
    return to_decimal(mpfr(abs(from_exact<mpfr>(read_exact(found)) / *exact - 1)), uncertainty_digits);
}

// Without commas, so that a reader of CSV without support for quotes is also correct.
std::string without_commas(std::string text) {
    std::ranges::replace(text, ',', ';');
    return text;
}

estimate_row row_of(const radius_estimate<mpfr>& estimate, const std::optional<mpfr>& exact, long digits) {
    const printed_estimate shown = printed(estimate, digits);
    return {text_value(estimate.method),
            number_value(shown.radius),
            number_value(shown.uncertainty),
            number_value(exact ? to_decimal(*exact, digits) : ""),
            number_value(relative_error(shown.radius, exact, digits)),
            number_value(shown.position_re),
            number_value(shown.position_im),
            text_value(estimate.kind == singularity_kind::unknown ? "" : name_of(estimate.kind)),
            estimate.count > 0 ? whole_value(estimate.count) : text_value(""),
            text_value(without_commas(estimate.note)),
            number_value(shown.exponent),
            number_value(shown.exponent_uncertainty),
            text_value("heuristic")};
}

// "2 simple poles", "1 pole of order 2", "4 logarithms", "3 algebraic branch points", "2 branch points".
// A list that satisfies no linear equation may be that of a natural boundary.
std::string kind_in_words(const radius_estimate<mpfr>& estimate, bool exact) {
    const std::string plural = estimate.count == 1 ? "" : "s";
    std::string what = estimate.count == 1 ? "singularity" : "singularities";
    if (estimate.kind == singularity_kind::pole) {
        const rational order = -simple_exponent(estimate).value_or(rational(-1));
        what = order == 1 ? "simple pole" + plural : "pole" + plural + " of order " + order.str();
    } else if (estimate.kind == singularity_kind::logarithm) {
        what = "logarithm" + plural;
    } else if (estimate.kind == singularity_kind::algebraic) {
        what = "algebraic branch point" + plural;
    } else if (estimate.kind == singularity_kind::confluent) {
        what = "logarithm" + plural + " or pair" + plural + " of confluent powers";
    } else if (estimate.kind == singularity_kind::irregular) {
        what = "irregular singular point" + plural + (exact ? "" : " or natural boundary");
    }
    return estimate.count > 0 ? std::to_string(estimate.count) + " " + what : what;
}

// "2 simple poles at 1.57 and the point symmetric to it": number, kind and position of the nearest singularities.
std::string nearest_in_words(const radius_estimate<mpfr>& estimate, const estimate_row& row, bool exact) {
    if (estimate.kind == singularity_kind::boundary) {
        return "the whole circle of convergence is a boundary";
    }
    std::string words = kind_in_words(estimate, exact);
    if (estimate.position) {
        const std::string& real = row[place::position_re].text;
        const std::string& imaginary = row[place::position_im].text;
        words += " at ";
        words += real == "0" && imaginary != "0" ? imaginary + " i" : complex_text(real, imaginary, " i");
        words += estimate.count > 2    ? " and the points symmetric to it"
                 : estimate.count == 2 ? " and the point symmetric to it"
                                       : "";
    }
    return estimate.kind == singularity_kind::unknown ? words + ", of undetermined kind" : words;
}

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& each : names) {
        all += (all.empty() ? "" : ", ") + each;
    }
    return all;
}

// "y; the radii of x, z agree with it; that of w is another one or not found": the unknown of the verdict, and the
// verdicts of the others.
std::string whose_verdict(const std::vector<radius_answers>& all, const std::vector<unknown_series>& unknowns,
                          std::size_t nearest) {
    const radius_estimate<mpfr>& verdict = all[nearest].rows.front();
    std::vector<std::string> agree;
    std::vector<std::string> differ;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != nearest) {
            const radius_estimate<mpfr>& other = all[i].rows.front();
            const bool agrees = verdict.radius && other.radius &&
                                abs(*verdict.radius - *other.radius) <= verdict.uncertainty + other.uncertainty;
            (agrees ? agree : differ).push_back(unknowns[i].name);
        }
    }
    std::string text = unknowns[nearest].name;
    if (!agree.empty()) {
        text += agree.size() == 1 ? "; the radius of " + agree.front() + " agrees with it"
                                  : "; the radii of " + joined(agree) + " agree with it";
    }
    if (!differ.empty()) {
        text += differ.size() == 1 ? "; that of " + differ.front() + " is another one or not found"
                                   : "; those of " + joined(differ) + " are others or not found";
    }
    return text;
}

// Counts the singularities that symmetry makes of the one that the radius is of, whose kind the row states; others at the
// same distance are in the ring.
void count_as_lead(radius_estimate<mpfr>& estimate, const list_verdict& verdict) {
    if (verdict.ring.size() > 1) {
        estimate.count = verdict.pattern.stride * (verdict.position->im == 0 ? 1 : 2);
    }
}

// `unknown` describes the unknown of the verdict; empty for a list without a name.
std::vector<answer_note> verdict_in_words(const radius_answers& answers, const estimate_row& row,
                                          const std::string& unknown, const request& how) {
    const radius_estimate<mpfr>& verdict = answers.rows.front();
    std::vector<answer_note> notes{{"coefficients", "n = 0 .. " + std::to_string(answers.verdict.pattern.order) + "; " +
                                                        answers.verdict.pattern.text() +
                                                        (answers.floor.empty() ? "" : "; ") + answers.floor}};
    if (!unknown.empty()) {
        notes.push_back({"unknown", unknown});
    }
    const auto with_uncertainty = [&](std::size_t at) { return row[at].text + " +- " + row[at + 1].text; };
    const bool bounded =
        answers.verdict.growth == growth_class::zero || answers.verdict.growth == growth_class::infinite;
    const std::string bound = answers.verdict.bound == radius_bound::at_least  ? "at least "
                              : answers.verdict.bound == radius_bound::at_most ? "at most "
                                                                               : "";
    notes.push_back({"radius", verdict.radius ? bound + with_uncertainty(place::radius)
                               : bounded      ? row[place::radius].text
                                              : "none"});
    if (verdict.radius) {
        notes.push_back({"nearest", nearest_in_words(verdict, row, answers.verdict.exact)});
        if (verdict.exponent) {
            notes.push_back({"exponent", with_uncertainty(place::exponent)});
        }
    }
    if (const std::string& exact = row[place::exact].text; !exact.empty()) {
        const std::string& error = row[place::relative_error].text;
        notes.push_back({"exact", exact + (error.empty() ? "" : ", relative error " + error)});
    }
    for (answer_note& each : notes_of(answers.verdict, how)) {
        notes.push_back(std::move(each));
    }
    notes.push_back({"why", row[place::note].text});
    return notes;
}

// Whether the exponent is that of a pole within its uncertainty.
bool has_exponent_of_pole(const radius_estimate<mpfr>& verdict) {
    if (!verdict.exponent || verdict.exponent_uncertainty * 20 > 1) {
        return false;
    }
    const mpfr nearest = round(*verdict.exponent);
    return nearest < 0 && abs(mpfr(*verdict.exponent - nearest)) <= verdict.exponent_uncertainty;
}

// The equations decide whether what looks like a pole is one.
void settle_kind(radius_estimate<mpfr>& verdict, const branch_analysis& analysis) {
    const bool open = verdict.kind == singularity_kind::pole || verdict.kind == singularity_kind::unknown;
    if (!open || !verdict.position || !analysis || !has_exponent_of_pole(verdict)) {
        return;
    }
    const auto single_valued = analysis(*verdict.position);
    if (single_valued && *single_valued) {
        verdict.kind = singularity_kind::pole;
    } else if (single_valued && !*single_valued) {
        verdict.kind = singularity_kind::unknown;
        verdict.note += "; no pole: by its equations the solution has branches there";
    }
}

}  // namespace

answer radius_answer(const std::vector<unknown_series>& unknowns, const std::optional<mpfr>& exact, const request& how,
                     const branch_analysis& analysis) {
    const bool several = unknowns.size() > 1;
    const long digits = how.printed_digits();
    std::vector<radius_answers> all;
    all.reserve(unknowns.size());
    for (const unknown_series& each : unknowns) {
        all.push_back(answers_of(each.lists, how.scalar, how.run));
        radius_estimate<mpfr>& verdict = all.back().rows.front();
        count_as_lead(verdict, all.back().verdict);
        settle_kind(verdict, analysis);
    }
    answer result{.names = {"method", "radius", "uncertainty", "exact", "relative_error", "position_re", "position_im",
                            "kind", "count", "note", "exponent", "exponent_uncertainty", "rigour"},
                  .rows = {},
                  .rigour = "heuristic"};
    const auto own = verdict_columns();
    const std::vector<answer_value> none(own.size(), text_value(""));
    const auto add = [&](std::size_t unknown, const radius_estimate<mpfr>& estimate) {
        result.rows.push_back(row_of(estimate, exact, digits));
        auto& row = result.rows.back();
        if (several) {
            row.push_back(text_value(unknowns[unknown].name));
        }
        const bool is_verdict = &estimate == &all[unknown].rows.front();
        const list_verdict& verdict = all[unknown].verdict;
        const auto further = is_verdict ? values_of(verdict, digits, unknowns[unknown].lists.root) : none;
        row.insert(row.end(), further.begin(), further.end());
        if (is_verdict) {
            row[place::radius].text = radius_text(verdict, row[place::radius].text);
        }
    };
    const std::size_t nearest = nearest_of(all);
    if (several) {
        result.names.emplace_back("unknown");
    }
    result.names.insert(result.names.end(), own.begin(), own.end());
    if (several) {
        add(nearest, all[nearest].rows.front());
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const auto& estimate : all[i].rows) {
            add(i, estimate);
        }
    }
    result.notes =
        verdict_in_words(all[nearest], result.rows.front(), several ? whose_verdict(all, unknowns, nearest) : "", how);
    return result;
}

}  // namespace libration
