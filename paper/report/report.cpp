#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "paper/claims/printed_numbers.hpp"
#include "sweep/study_files.hpp"
#include "text/latex.hpp"

namespace libration {

namespace {

// A cell of a Markdown table, with special characters escaped.
std::string markdown_cell(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '|' || c == '*' || c == '<' ? std::string("\\") + c : std::string(1, c == '\n' ? ' ' : c);
    }
    return out;
}

// The rows of claims as a Markdown table.
std::string claims_rows(const std::vector<published_claim>& claims) {
    std::string text =
        "| claim | label (in print) | statement | verdict | measured | command |\n| --- | --- | --- | --- | --- | --- "
        "|\n";
    for (const published_claim& each : claims) {
        const std::string truth = each.correction.empty() ? "" : " **Instead:** " + markdown_cell(each.correction);
        const std::string severity = each.severity.empty() ? "" : " (" + each.severity + ")";
        text += fmt::format("| {} | {} | {}{} | {}{} | {}: {} | `{}` |\n", markdown_cell(each.name),
                            markdown_cell(place_of(each)), markdown_cell(each.statement), truth, each.verdict, severity,
                            markdown_cell(each.measured), each.number, markdown_cell(each.command));
    }
    return text + "\n";
}

std::string claims_part(const std::vector<published_claim>& all) {
    const auto claims = claims_by(all, false);
    const auto own = claims_by(all, true);
    std::string text = fmt::format(
        "## Does the paper hold?\n\n"
        "{} statements of the paper were judged: {} hold, {} hold with a correction, {} fail. Of those that do not\n"
        "hold as printed, {} are formulas with which a program gives wrong numbers, {} statements about the\n"
        "mathematics, {} wording. `./run claims NAME` measures one again, `./run claims fig:subcrit` or `./run claims\n"
        "\"Figure 4\"` those that concern a label or a printed number, `./run test -R 'claim NAME'` runs its test, "
        "and\n"
        "[errata.md](errata.md) explains what does not hold. The label is that of the paper's LaTeX source, followed "
        "by\n"
        "the printed number. Tables: [claims.csv](claims.csv), [claims.tex](claims.tex).\n\n",
        claims.size(), claims_with(claims, verdict::holds).size(), claims_with(claims, verdict::corrected).size(),
        claims_with(claims, verdict::fails).size(), claims_of_severity(claims, "formula").size(),
        claims_of_severity(claims, "statement").size(), claims_of_severity(claims, "wording").size());
    text += claims_rows(claims);
    if (own.empty()) {
        return text;
    }
    return text + "## Beyond the paper\n\nWhat this program claims itself, judged in the same way.\n\n" +
           claims_rows(own);
}

std::string studies_part(const std::vector<published_study>& studies) {
    std::string text =
        "## Studies\n\n"
        "Each folder holds the tables of one study (CSV: one header line, one observation a row; the same for LaTeX), "
        "NAME.json\n"
        "with the command, the columns and their units and what it was made with, and the figures drawn from the "
        "CSV.\n\n"
        "| study | figure | question | command |\n| --- | --- | --- | --- |\n";
    for (const published_study& each : studies) {
        text +=
            fmt::format("| [{0}]({0}) | {1} | {2} | `./run {3}` |\n", each.what->name, printed_place(each.what->label),
                        each.what->question, each.command.substr(each.command.find(' ') + 1));
    }
    return text;
}

std::string references_part(const std::vector<published_reference>& references) {
    std::string text =
        "\n## Reference values\n\n"
        "Values with 50 digits, each proved to one unit in the last place, and how well conditioned they are: for "
        "papers "
        "and\n"
        "test suites. CSV, C++ header, Boost.Math's .ipp, and text for NumPy; "
        "[reference.json](reference/reference.json) says what\n"
        "made them and what the columns are.\n\n"
        "| table | files | command |\n| --- | --- | --- |\n";
    for (const published_reference& each : references) {
        std::string files;
        for (const std::string& file : each.files) {
            files += fmt::format("{}[{}]({})", files.empty() ? "" : " ", file.substr(file.find('/') + 1), file);
        }
        text += fmt::format("| {} | {} | `./run {}` |\n", markdown_cell(each.title), files,
                            each.command.substr(each.command.find(' ') + 1));
    }
    return text;
}

// Certificates are made by check/certify.py, in a folder that this program does not write.
std::string certified_part(const std::string& folder) {
    if (!std::filesystem::exists(std::filesystem::path(folder) / "certified" / "README.md")) {
        return "";
    }
    return "\n## Certificates\n\n"
           "Values of the test problems, each with a file from which a program in integers proves it again:\n"
           "[certified](certified/README.md), checked by `./run check`.\n";
}

const published_claim& claim_named(const std::vector<published_claim>& claims, const std::string& name) {
    const auto found = std::ranges::find(claims, name, &published_claim::name);
    if (found == claims.end()) {
        throw std::runtime_error("the errata name the claim " + name + ", which does not exist");
    }
    return *found;
}

// The replacement of a placeholder of the errata: the number of the claim, or the printed number of a label.
std::string filled_in(const published& results, const std::string& placeholder) {
    const std::string printed = "printed ";
    if (!placeholder.starts_with(printed)) {
        return claim_named(results.claims, placeholder).number;
    }
    const std::string label = placeholder.substr(printed.size());
    const std::string place = printed_place(label);
    if (place == label) {
        throw std::runtime_error("the errata name the label " + label + ", which the paper does not have");
    }
    return place;
}

// The claims table for LaTeX: what fits the width of a page.
std::string claims_latex(const std::vector<published_claim>& claims) {
    table data({{"place", "in print"}, {"statement", ""}, {"verdict", ""}, {"severity", ""}, {"measured", ""}});
    for (const published_claim& each : claims) {
        data.add_row({each.printed.empty() ? each.label : each.printed, each.statement, each.verdict, each.severity,
                      read_cell(each.number)});
    }
    return to_latex(data, {"The statements of the paper, and this program's own behind them, judged.", "claims"});
}

}  // namespace

std::string results_readme(const published& results) {
    return "# Results\n\nMade by `./run reproduce`; do not edit. [index.html](index.html) is the same with the "
           "figures, as "
           "one page.\n\n" +
           (results.claims.empty() ? "" : claims_part(results.claims)) + studies_part(results.studies) +
           (results.references.empty() ? "" : references_part(results.references)) + certified_part(results.folder);
}

std::string errata_page(const published& results, const std::string& outline) {
    std::string page;
    std::size_t at = 0;
    for (std::size_t open = outline.find("{{"); open != std::string::npos; open = outline.find("{{", at)) {
        const std::size_t close = outline.find("}}", open);
        if (close == std::string::npos) {
            throw std::runtime_error("the errata open {{ without }}");
        }
        page += outline.substr(at, open - at);
        page += filled_in(results, outline.substr(open + 2, close - open - 2));
        at = close + 2;
    }
    page += outline.substr(at);
    for (const published_claim& each : results.claims) {
        if (each.verdict != name_of(verdict::holds) && outline.find(each.name) == std::string::npos) {
            throw std::runtime_error("the errata do not mention the claim " + each.name + ", which does not hold");
        }
    }
    return page;
}

void write_report(const std::string& folder) {
    const published results = read_published(folder);
    const auto in_folder = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
    write_into(in_folder("README.md"), results_readme(results));
    write_into(in_folder("index.html"), report_page(results));
    if (!results.claims.empty()) {
        write_into(in_folder("claims.tex"), claims_latex(results.claims));
        write_into(in_folder("errata.md"),
                   errata_page(results, text_of((std::filesystem::path(studies_folder()) / "errata.md.in").string())));
    }
}

}  // namespace libration
