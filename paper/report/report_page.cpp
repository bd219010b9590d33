// The report: everything that was computed and whether the paper holds, on one page for a reader who comes to it first.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "paper/claims/printed_numbers.hpp"
#include "report.hpp"
#include "run/provenance.hpp"
#include "text/html.hpp"
#include "text/measured_text.hpp"

namespace libration {

namespace {

constexpr const char* paper_title =
    "On the trajectory of the nonlinear pendulum: Exact analytic solutions via power series";

// The class of a verdict in the style.
std::string css_of(const std::string& judged) {
    return judged == name_of(verdict::holds) ? "holds" : judged == name_of(verdict::fails) ? "fails" : "corrected";
}

std::string opening(const published& results) {
    std::string text = fmt::format(
        "<header><div>\n<h1>The pendulum's power series, recomputed and checked</h1>\n"
        "<p>A pendulum obeys &theta;&Prime; + sin &theta; = 0. The paper <cite>{}</cite> (Reinberger, Holland, Barlow, "
        "Weinstein) gives its motion as a power series in time about the highest point of the swing, a resummation of "
        "that series that converges faster, and a resummed series for the period. This page was written by the program "
        "<b>libration</b>, which recomputed every figure of the paper with 40 or more digits and tested every "
        "checkable "
        "statement independently.</p>\n",
        paper_title);
    text += "<nav>";
    if (!results.claims.empty()) {
        text +=
            "<a href=\"#verdict\">Does the paper hold?</a><a href=\"#corrections\">What does not hold as printed</a>"
            "<a href=\"#confirmed\">What holds</a>";
    }
    if (!claims_by(results.claims, true).empty()) {
        text += "<a href=\"#beyond\">Beyond the paper</a>";
    }
    return text + R"(<a href="#words">Words and symbols</a><a href="#figures">Figures</a>)" +
           (results.references.empty() ? "" : R"(<a href="#references">Reference values</a>)") +
           "<a href=\"#provenance\">How it was made</a></nav>\n</div></header>\n";
}

std::string verdict_part(const published& results) {
    const auto of_the_paper = claims_by(results.claims, false);
    const auto count = [&](verdict v) { return claims_with(of_the_paper, v).size(); };
    std::string text = fmt::format(
        "<h2 id=\"verdict\">Does the paper hold?</h2>\n"
        "<ul class=\"tally\"><li class=\"holds\"><b>{}</b>statements hold</li>"
        "<li class=\"corrected\"><b>{}</b>hold with a correction</li><li class=\"fails\"><b>{}</b>fail</li></ul>\n",
        count(verdict::holds), count(verdict::corrected), count(verdict::fails));
    const auto of_severity = [&](const char* severity) { return claims_of_severity(of_the_paper, severity).size(); };
    text += fmt::format(
        "<p>Of those that do not hold as printed, {} are <em>formulas</em> with which a program gives wrong numbers, "
        "{} "
        "<em>statements</em> about the mathematics that are not so in this generality, and {} are <em>wording</em>: "
        "captions, labels, missing words.</p>\n",
        of_severity("formula"), of_severity("statement"), of_severity("wording"));
    text +=
        "<p>Each statement was measured when this page was made: each verdict follows from the number beside it. "
        "<em>Holds with correction</em> means that the idea is right and the printed formula or wording needs the "
        "change "
        "that stands beside it; <em>fails</em> means that it is not so, with the smallest counterexample found.</p>\n"
        "<p>In short: the series about the top does reach the bottom at every energy, the resummation is exact and "
        "nearly always better, and the resummed period is far better near the separatrix. A program written from the "
        "page needs "
        "these changes first: the sign of <a href=\"#claim-omegab_libration\">&omega;* of a libration</a>, the angle "
        "<a href=\"#claim-resummation_counterclockwise\">&theta;* = 2&pi;</a> that counterclockwise rotation arrives "
        "at "
        "(also in <a href=\"#claim-b_constants\">b<sub>0</sub></a> and in the appendix's "
        "<a href=\"#claim-appendix_alpha_beta\">&alpha; and &beta;</a>), and the exponent in the appendix's "
        "<a href=\"#claim-appendix_sigma\">&sigma;<sub>N</sub></a>.</p>\n"
        "<p>What the paper promises beyond that is not so in general: that the resummation is better "
        "<a href=\"#claim-better_at_every_truncation\">at every truncation and energy</a> and "
        "<a href=\"#claim-abstract_uniform_acceleration\">at every time</a>, that series about the bottom "
        "<a href=\"#claim-bottom_radius_of_libration\">never reach T* below E = 2</a>, that the error "
        "<a href=\"#claim-error_grows_towards_separatrix\">grows steadily</a> towards E = 2.</p>\n";
    return text;
}

std::string claim_card(const published_claim& each) {
    const std::string css = css_of(each.verdict);
    std::string text = fmt::format(
        "<article id=\"claim-{}\" class=\"{}\">\n<p class=\"meta\"><span class=\"chip {}\">{}</span> &middot; {} "
        "&middot; {}</p>\n<p>{}</p>\n",
        html_text(each.name), css, css, each.verdict + (each.severity.empty() ? "" : ": " + each.severity),
        html_text(place_of(each)), html_text(each.name), html_prose(each.statement));
    if (!each.correction.empty()) {
        text += "<p><b>Instead:</b> " + html_prose(each.correction) + "</p>\n";
    }
    return text + fmt::format("<p class=\"meta\">Measured: {}: <b>{}</b>. Shown by <code>{}</code></p>\n</article>\n",
                              html_prose(each.measured), html_mathematics(each.number), html_text(each.command));
}

std::string cards(const std::vector<published_claim>& claims, std::initializer_list<verdict> judged) {
    std::string text = "<div class=\"cards\">\n";
    for (const verdict each_verdict : judged) {
        for (const published_claim& each : claims_with(claims, each_verdict)) {
            text += claim_card(each);
        }
    }
    return text + "</div>\n";
}

// What this program claims itself.
std::string own_part(const published& results) {
    const auto own = claims_by(results.claims, true);
    return own.empty() ? ""
                       : "<h2 id=\"beyond\">Beyond the paper</h2>\n<p>What this program claims itself, measured in the "
                         "same way.</p>\n" +
                             cards(own, {verdict::fails, verdict::corrected, verdict::holds});
}

std::string claims_part(const published& results) {
    const auto of_the_paper = claims_by(results.claims, false);
    return "<h2 id=\"corrections\">What does not hold as printed</h2>\n"
           "<p>The same with derivations, to be sent to the authors: <a href=\"errata.md\">errata.md</a>. Each card "
           "says the "
           "verdict, where the statement stands (a label of the paper's LaTeX source) and the name of the claim: "
           "<code>./run claims NAME</code> measures it again.</p>\n" +
           cards(of_the_paper, {verdict::fails, verdict::corrected}) + "<h2 id=\"confirmed\">What holds</h2>\n" +
           cards(of_the_paper, {verdict::holds}) + own_part(results) +
           "<p class=\"files\">All claims as <a href=\"claims.csv\">claims.csv</a>, "
           "<a href=\"claims.tex\">claims.tex</a>.</p>\n";
}

std::string links(const published_study& each) {
    std::string text;
    for (const std::string& csv : each.tables) {
        const std::string stem = csv.substr(0, csv.rfind('.'));
        text += fmt::format(R"(<a href="{0}">{1}</a> (<a href="{2}.tex">LaTeX</a>), )", html_text(csv),
                            html_text(csv.substr(csv.find('/') + 1)), html_text(stem));
    }
    return text + fmt::format("<a href=\"{0}/{0}.json\">{0}.json</a>", each.what->name);
}

// The published tables by the stem of their CSV.
table_source tables_of(const published& results) {
    return [&results](const std::string& stem) -> std::optional<table> {
        for (const published_study& each : results.studies) {
            for (const std::string& csv : each.tables) {
                if (std::filesystem::path(csv).stem() == stem) {
                    return from_csv(text_of((std::filesystem::path(results.folder) / csv).string()));
                }
            }
        }
        return std::nullopt;
    };
}

// The figures within the page, as URIs: the smaller ones, as many as keep the page below 3 MB. The others are loaded
// from the folder.
std::map<std::string, std::string> images_within(const published& results) {
    constexpr std::size_t most_bytes = 2'500'000;
    std::vector<std::pair<std::string, std::string>> all;
    for (const published_study& each : results.studies) {
        for (const std::string& svg : each.figures) {
            all.emplace_back(svg, svg_uri(text_of((std::filesystem::path(results.folder) / svg).string())));
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    std::map<std::string, std::string> within;
    std::size_t bytes = 0;
    for (auto& [svg, uri] : all) {
        bytes += uri.size();
        if (bytes > most_bytes) {
            break;
        }
        within.emplace(svg, std::move(uri));
    }
    return within;
}

std::string study_part(const published& results, const published_study& each,
                       const std::map<std::string, std::string>& images) {
    const study& what = *each.what;
    const std::string figure = what.label.empty() ? "not in the paper" : "the paper's " + printed_place(what.label);
    std::string text =
        fmt::format("<section class=\"study\" id=\"{}\">\n<h3>{}</h3>\n<p class=\"question\">{}</p>\n<p>{}</p>\n",
                    what.name, html_mathematics(what.title), html_mathematics(what.question),
                    html_prose(measured_text(what.reading, tables_of(results))));
    for (const std::string& svg : each.figures) {
        const auto within = images.find(svg);
        text += fmt::format(
            "<figure><a href=\"{0}\"><img alt=\"{1}\" src=\"{2}\"></a><figcaption class=\"files soft\">for print: "
            "<a href=\"{3}.pdf\">PDF</a>, <a href=\"{3}.png\">PNG with 300 dpi</a></figcaption></figure>\n",
            html_text(svg), html_text(what.title + ": figure " + svg.substr(svg.find('/') + 1)),
            within != images.end() ? within->second : html_text(svg), html_text(svg.substr(0, svg.rfind('.'))));
    }
    return text + fmt::format("<p class=\"files soft\">{}. Tables: {}. Made by <code>./run {}</code></p>\n</section>\n",
                              html_text(figure), links(each),
                              html_text(each.command.substr(each.command.find(' ') + 1)));
}

// The figures by title: the paper's first, in its order.
std::string contents(const published& results) {
    std::string text = "<ol>\n";
    for (const published_study& each : results.studies) {
        const std::string& label = each.what->label;
        text += fmt::format(
            "<li><a href=\"#{}\">{}</a>{}</li>\n", each.what->name, html_text(each.what->title),
            label.empty() ? "" : " <span class=\"soft\">the paper's " + html_text(printed_place(label)) + "</span>");
    }
    return text + "</ol>\n";
}

std::string references_part(const published& results) {
    std::string text =
        "<h2 id=\"references\">Reference values</h2>\n"
        "<p>Values for papers and test suites: 50 digits, each proved to one unit in the last place, with the "
        "condition number beside them, which says how much of an error in the input appears in the value. "
        "<a href=\"reference/reference.json\">reference.json</a> says what made them and what the columns are.</p>\n"
        "<div class=\"scroll\"><table>\n";
    for (const published_reference& each : results.references) {
        std::string files;
        for (const std::string& file : each.files) {
            files +=
                fmt::format(R"(<a href="{0}">{1}</a> )", html_text(file), html_text(file.substr(file.find('/') + 1)));
        }
        text += fmt::format("<tr><td>{}<br><code>./run {}</code></td><td>{}</td></tr>\n", html_text(each.title),
                            html_text(each.command.substr(each.command.find(' ') + 1)), files);
    }
    return text + "</table></div>\n";
}

constexpr const char* words_part =
    "<h2 id=\"words\">Words and symbols</h2>\n<div class=\"scroll\"><table>\n"
    "<tr><th>E</th><td>energy over m g l: below 2 the pendulum swings (libration), above it rotates, at 2 it "
    "approaches the top forever (separatrix). The gap is 2 &minus; E.</td></tr>\n"
    "<tr><th>t, T</th><td>time in units of &radic;(l/g), and the period</td></tr>\n"
    "<tr><th>T*</th><td>time from the top of the trajectory to the bottom: T/4 of a libration, T/2 of a "
    "rotation</td></tr>\n"
    "<tr><th>R</th><td>radius of convergence: distance from the expansion point to the nearest singularity in complex "
    "time</td></tr>\n"
    "<tr><th>N</th><td>order: the last power of a series, the last index of the resummation</td></tr>\n"
    "<tr><th>error norm</th><td>the largest |approximation &minus; &theta;| on [0, T*], in radians, at its true "
    "maximum</td></tr>\n"
    "<tr><th>two-method</th><td>two independent routes agree to every printed digit</td></tr>\n"
    "<tr><th>heuristic</th><td>measured, not confirmed by a second route</td></tr>\n"
    "</table></div>\n";

std::string provenance_part(const published& results) {
    std::string text =
        "<h2 id=\"provenance\">How it was made</h2>\n<p>By <code>./run reproduce</code>. The tables depend on the "
        "parameters "
        "alone, not on the day, the number of threads or (in MPFR arithmetic) the machine; figures are drawn from the "
        "tables.</p>\n<div class=\"scroll\"><table>\n";
    for (const auto& [name, version] : provenance()) {
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", html_text(name), html_text(version));
    }
    std::set<std::string> commits;
    for (const published_study& each : results.studies) {
        commits.insert(each.commit);
    }
    return text + fmt::format("<tr><th>tables made at</th><td>{}</td></tr>\n</table></div>\n",
                              html_text(fmt::format("{}", fmt::join(commits, ", "))));
}

}  // namespace

std::string report_page(const published& results) {
    std::string body = opening(results) + "<main>\n";
    if (!results.claims.empty()) {
        body += verdict_part(results);
    }
    body += words_part;
    body += "<h2 id=\"figures\">Figures</h2>\n" + contents(results);
    const auto images = images_within(results);
    for (const published_study& each : results.studies) {
        body += study_part(results, each, images);
    }
    if (!results.claims.empty()) {
        body += claims_part(results);
    }
    if (!results.references.empty()) {
        body += references_part(results);
    }
    body += provenance_part(results);
    body +=
        "</main>\n<footer>Figures open alone when they are clicked. Written by <code>libration "
        "reproduce</code>.</footer>\n";
    return html_page("Libration: the pendulum's power series, recomputed and checked", body);
}

}  // namespace libration
