#include "report/reproduce_set.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

// What `reproduce` by itself makes, also when there are more studies: its time and its pages stay those of the paper.
constexpr std::array<std::string_view, 23> paper_studies{"all_time",
                                                         "audit_boost",
                                                         "audit_gsl",
                                                         "cost",
                                                         "divergence",
                                                         "domb_sykes",
                                                         "error_norm",
                                                         "expansion_point",
                                                         "libration_series",
                                                         "near_separatrix_resummed",
                                                         "near_separatrix_series",
                                                         "period_effect",
                                                         "period_error",
                                                         "precision_floor",
                                                         "radius_map",
                                                         "radius_tournament",
                                                         "resummations",
                                                         "root_test",
                                                         "rotation_series",
                                                         "singularities",
                                                         "surface",
                                                         "terms",
                                                         "uniform"};

bool is_of_paper(const study& each) {
    return std::find(paper_studies.begin(), paper_studies.end(), each.name) != paper_studies.end();
}

template <class Belongs>
std::vector<const study*> studies_where(const Belongs& belongs) {
    auto studies = all_studies();
    std::erase_if(studies, [&](const study* each) { return !belongs(*each); });
    return studies;
}

reproduce_set names_of(const char* option, const std::string& list) {
    reproduce_set result;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        if (name == claims_name) {
            result.claims = true;
        } else if (name == references_name) {
            result.references = true;
        } else {
            result.studies.push_back(&study_named(option, name));
        }
    }
    if (result.studies.empty() && !result.claims && !result.references) {
        throw input_error(option, list, "names no study", "write names with commas between them");
    }
    return result;
}

}  // namespace

std::string place_of_part(const std::string& part) { return part == claims_name ? "claims.csv" : part; }

std::string description_of_part(const std::string& part) {
    return part == claims_name ? place_of_part(part) : part + "/" + part + ".json";
}

reproduce_set set_named(const std::string& name) {
    if (name == "paper") {
        return {studies_where(is_of_paper), true, true};
    }
    if (name == "proved") {
        return {studies_where([](const study& each) { return each.offers == arithmetics::proved_too; }), false, true};
    }
    if (name == "all") {
        return {all_studies(), true, true};
    }
    if (name != "problems") {
        throw input_error("set", name, "is no set", "write paper, problems, proved or all");
    }
    reproduce_set result{studies_where([](const study& each) { return !is_of_paper(each); }), false, false};
    if (result.studies.empty()) {
        throw input_error("set", name, "holds no study in this version", "write paper, proved or all");
    }
    return result;
}

reproduce_set chosen_of(reproduce_set set, const std::optional<std::string>& only,
                        const std::optional<std::string>& skip) {
    reproduce_set result = only ? names_of("--only", *only) : std::move(set);
    if (!skip) {
        return result;
    }
    const reproduce_set left_out = names_of("--skip", *skip);
    for (const study* each : left_out.studies) {
        std::erase(result.studies, each);
    }
    result.claims = result.claims && !left_out.claims;
    result.references = result.references && !left_out.references;
    if (result.studies.empty() && !result.claims && !result.references) {
        throw input_error("--skip", *skip, "leaves nothing to make", "name fewer");
    }
    return result;
}

}  // namespace libration
