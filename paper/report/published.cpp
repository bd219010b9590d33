#include "published.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "run/stream_content.hpp"
#include "sweep/named_order.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// The paper's figures in their order.
constexpr std::array<std::string_view, 10> paper_figures{
    "fig:surf",          "fig:series",          "fig:subcrit", "fig:librationfixed",
    "fig:rotationfixed", "fig:librationseries", "fig:error",   "fig:librationapproximant",
    "fig:perioderror",   "fig:period"};

// The place of a study's figure among them; behind them all where it has none.
std::size_t figure_place_of(const study& what) {
    std::size_t place = 0;
    while (place < paper_figures.size() && !what.label.starts_with(paper_figures.at(place))) {
        ++place;
    }
    return place;
}

published_study read_study(const fs::path& folder, const study& what) {
    const fs::path own = folder / what.name;
    const auto json = nlohmann::json::parse(text_of((own / (what.name + ".json")).string()));
    published_study result{&what, json.at("command"), json.at("made with").at("commit"), {}, {}};
    for (const auto& entry : json.at("tables")) {
        result.tables.push_back(what.name + "/" + entry.at("file").get<std::string>());
    }
    for (const auto& entry : fs::directory_iterator(own)) {
        if (entry.path().extension() == ".svg") {
            result.figures.push_back(what.name + "/" + entry.path().filename().string());
        }
    }
    std::sort(result.figures.begin(), result.figures.end());  // NAME.svg sorts before NAME_more.svg
    return result;
}

std::vector<published_claim> read_claims(const std::string& path) {
    const table data = from_csv(text_of(path));
    if (to_csv(table(claims_table({}).columns())) != to_csv(table(data.columns()))) {
        throw std::runtime_error(path + " has other columns than this program writes");
    }
    std::vector<published_claim> claims;
    claims.reserve(data.rows().size());
    for (const auto& row : data.rows()) {
        claims.push_back({row[0].text(), row[1].text(), row[2].text(), row[3].text(), row[4].text(), row[5].text(),
                          row[6].text(), row[7].text(), row[8].text(), row[9].text()});
    }
    return claims;
}

std::vector<published_reference> read_references(const std::string& path) {
    std::vector<published_reference> references;
    try {
        for (const auto& entry : nlohmann::json::parse(text_of(path))) {
            published_reference each{entry.at("title"), entry.at("command"), {}};
            for (const auto& file : entry.at("files")) {
                each.files.push_back("reference/" + file.get<std::string>());
            }
            references.push_back(std::move(each));
        }
    } catch (const nlohmann::json::exception& problem) {
        throw std::runtime_error(path + ": " + problem.what());
    }
    return references;
}

}  // namespace

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error(path + " cannot be read");
    }
    return content_of(file, path);
}

published read_published(const std::string& folder) {
    published result{folder, {}, {}, {}};
    std::vector<const study*> studies = studies_of_own_problems();
    for (const study_order& each : example_orders()) {
        studies.push_back(each.what);
    }
    for (const study* each : studies) {
        if (fs::exists(fs::path(folder) / each->name / (each->name + ".json"))) {
            try {
                result.studies.push_back(read_study(folder, *each));
            } catch (const nlohmann::json::exception& problem) {
                throw std::runtime_error(folder + "/" + each->name + ": " + problem.what());
            }
        }
    }
    std::stable_sort(result.studies.begin(), result.studies.end(),
                     [](const auto& a, const auto& b) { return figure_place_of(*a.what) < figure_place_of(*b.what); });
    const fs::path claims = fs::path(folder) / "claims.csv";
    if (fs::exists(claims)) {
        result.claims = read_claims(claims.string());
    }
    const fs::path references = fs::path(folder) / "reference" / "reference.json";
    if (fs::exists(references)) {
        result.references = read_references(references.string());
    }
    return result;
}

std::vector<published_claim> claims_by(const std::vector<published_claim>& claims, bool own) {
    std::vector<published_claim> result;
    std::copy_if(claims.begin(), claims.end(), std::back_inserter(result),
                 [own](const published_claim& each) { return is_own(each.label) == own; });
    return result;
}

std::vector<published_claim> claims_with(const std::vector<published_claim>& claims, verdict judged) {
    std::vector<published_claim> result;
    std::copy_if(claims.begin(), claims.end(), std::back_inserter(result),
                 [name = name_of(judged)](const published_claim& each) { return each.verdict == name; });
    return result;
}

std::vector<published_claim> claims_of_severity(const std::vector<published_claim>& claims,
                                                const std::string& severity) {
    std::vector<published_claim> result;
    std::ranges::copy_if(claims, std::back_inserter(result),
                         [&](const published_claim& each) { return each.severity == severity; });
    return result;
}

std::string place_of(const published_claim& each) {
    return each.printed.empty() || each.printed == each.label ? each.label : each.label + " (" + each.printed + ")";
}

}  // namespace libration
