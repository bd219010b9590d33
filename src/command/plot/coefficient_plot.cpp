#include "plot/coefficient_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "problem/coefficient_tables.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr std::size_t most_unknowns = 4;
// The cost of a Pade approximant and its roots grows like N^4, and its nearest poles settle much earlier.
constexpr int most_for_poles = 80;

void require_drawable(const unknown_series& of) {
    if (of.lists.parts.size() > 1) {
        throw input_error("--plot draws real coefficients, and those of " + of.name +
                          " are complex: leave --plot out, or draw about a real point");
    }
    if (of.lists.root > 1) {
        throw input_error("--plot draws power series, and " + of.name +
                          " is a series in powers of a root of the variable: leave --plot out");
    }
}

// The row of the verdict on an unknown.
const std::vector<answer_value>& verdict_on(const answer& found, const std::string& unknown) {
    const auto at = std::ranges::find(found.names, "unknown") - found.names.begin();
    const auto is_verdict = [&](const auto& row) {
        return row.front().text == "verdict" &&
               (at == std::ssize(found.names) || row[static_cast<std::size_t>(at)].text == unknown);
    };
    return *std::ranges::find_if(found.rows, is_verdict);
}

// The lists of the verdict with more than one row, as tables NAME_K.csv.
void add_lists(figure_content& content, const answer& found, const std::string& unknown, std::size_t k) {
    const auto& row = verdict_on(found, unknown);
    for (const std::string name : {"history", "fits", "predictions"}) {
        const auto at = static_cast<std::size_t>(std::ranges::find(found.names, name) - found.names.begin());
        const table list = table_of_list(cell::list(row[at].text));
        if (list.rows().size() > 1) {
            content.tables.push_back({fmt::format("{}_{}.csv", name, k), to_csv(list)});
        }
    }
}

series::power_series<mpfr> first_of(const series::power_series<mpfr>& a) {
    return a.truncated(std::min(a.order(), most_for_poles));
}

}  // namespace

figure_content coefficient_plot(const std::vector<unknown_series>& unknowns, const answer& found,
                                const std::string& title, long digits) {
    const std::size_t count = std::min(unknowns.size(), most_unknowns);
    figure_content content{"coefficient_plot", {{"radius.csv", to_csv(tests_of(found))}}, {}};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        const unknown_series& each = unknowns[i];
        require_drawable(each);
        names.push_back(each.name);
        content.tables.push_back({fmt::format("ratios_{}.csv", i + 1), to_csv(ratios_of(each.coefficients(), digits))});
        content.tables.push_back(
            {fmt::format("poles_{}.csv", i + 1), to_csv(poles_of(first_of(each.coefficients()), digits))});
        add_lists(content, found, each.name, i + 1);
    }
    const std::string more =
        unknowns.size() > count ? fmt::format("; the first {} of {} unknowns", count, unknowns.size()) : "";
    content.variables = {
        {"list_names", words_for_script(names)},
        {"pade_order",
         unknowns.front().coefficients().order() > most_for_poles ? fmt::format(" of order {}", most_for_poles) : ""},
        {"figure_title", title},
        {"figure_note",
         fmt::format("from the coefficients up to order {}{}", unknowns.front().coefficients().order(), more)}};
    return content;
}

}  // namespace libration
