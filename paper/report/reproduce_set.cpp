#include "reproduce_set.hpp"

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
                                                         "approximants",
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
    auto studies = studies_of_own_problems();
    std::erase_if(studies, [&](const study* each) { return !belongs(*each); });
    return studies;
}

std::vector<const study_order*> all_examples() {
    std::vector<const study_order*> all;
    for (const study_order& each : example_orders()) {
        all.push_back(&each);
    }
    return all;
}

const study_order* example_named(const std::string& name) {
    for (const study_order* each : all_examples()) {
        if (each->what->name == name) {
            return each;
        }
    }
    return nullptr;
}

bool is_empty(const reproduce_set& set) {
    return set.studies.empty() && set.examples.empty() && !set.claims && !set.references;
}

reproduce_set names_of(const char* option, const std::string& list) {
    reproduce_set result;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        if (name == claims_name) {
            result.claims = true;
        } else if (name == references_name) {
            result.references = true;
        } else if (const study_order* const example = example_named(name)) {
            result.examples.push_back(example);
        } else {
            result.studies.push_back(&study_named(option, name));
        }
    }
    if (is_empty(result)) {
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
        return {studies_of_own_problems(), true, true, all_examples()};
    }
    if (name != "problems") {
        throw input_error("set", name, "is not a set", "write paper, problems, proved or all");
    }
    return {studies_where([](const study& each) { return !is_of_paper(each); }), false, false, all_examples()};
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
    for (const study_order* each : left_out.examples) {
        std::erase(result.examples, each);
    }
    result.claims = result.claims && !left_out.claims;
    result.references = result.references && !left_out.references;
    if (is_empty(result)) {
        throw input_error("--skip", *skip, "leaves nothing to make", "name fewer");
    }
    return result;
}

}  // namespace libration
