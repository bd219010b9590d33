// libration claims: tests the statements of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "paper/claims/claim.hpp"
#include "paper/claims/printed_numbers.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct claims_options {
    std::vector<std::string> names;
    output_options output;
    std::optional<std::string> jobs;
};

std::vector<claim> chosen(const std::vector<std::string>& names) {
    auto all = all_claims();
    if (names.empty()) {
        return all;
    }
    std::vector<claim> result;
    for (const std::string& name : names) {
        const std::size_t before = result.size();
        std::ranges::copy_if(all, std::back_inserter(result),
                             [&](const claim& each) { return each.name == name || concerns(each.label, name); });
        if (result.size() == before) {
            throw input_error("claims", name, "is not a claim, nor a label or a printed number that claims concern",
                              "see 'libration claims'; labels are as fig:subcrit, numbers as 'Figure 4' or '(16c)'");
        }
    }
    return result;
}

// One claim under the other: a table of sentences is too wide for a terminal.
std::string as_text(const std::vector<judged_claim>& judged) {
    const table data = claims_table(judged);
    std::string text;
    for (const auto& row : data.rows()) {
        const std::string severity = row[8].is_empty() ? "" : " (" + row[8].text() + ")";
        const std::string printed =
            row[9].is_empty() || row[9].text() == row[1].text() ? "" : " [" + row[9].text() + "]";
        text += fmt::format("{}  {}{}: {}{}\n    {}\n    {}: {}\n", row[0].text(), row[1].text(), printed,
                            row[3].text(), severity, row[2].text(), row[5].text(), row[4].text());
        text += row[6].is_empty() ? "" : fmt::format("    correct statement: {}\n", row[6].text());
        text += fmt::format("    {}\n", row[7].text());
    }
    return text;
}

int run_claims(const claims_options& options) {
    options.output.check();
    const int jobs = jobs_of(options.jobs);
    const auto claims = chosen(options.names);
    const auto judged = judge(claims, jobs);
    options.output.write(claims_table(judged), as_text(judged));
    return 0;
}

}  // namespace

subcommand claims_command(CLI::App& program) {
    const auto options = std::make_shared<claims_options>();
    CLI::App* command = program.add_subcommand("claims", "test the statements of the paper: verdict and number");
    command->add_option("NAME", options->names,
                        "these claims only, or those that concern a label or a printed number (fig:subcrit, 'Figure "
                        "4', '(16c)', 'section V'; default: all)");
    options->output.add_to(*command);
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options] { return run_claims(*options); }};
}

}  // namespace libration
