// Numbers that the literature prints about problems with asymptotic approximants, exactly as printed.
#pragma once

#include <string>
#include <vector>

namespace libration::studies {

/// A printed number: its problem, the changes of the problem's text, and the name of the quantity in far_behaviour.
struct published_number {
    std::string problem;
    std::vector<std::string> changes;
    std::string free;  ///< the unknown parameter, if it is not the initial value
    std::string quantity;
    int known = 0;  ///< coefficients that the approximant uses to predict it; 0: of the solution itself
    std::string printed;
    std::string source;
};

inline std::vector<published_number> published_numbers(const std::string& problem) {
    const std::string wall = "Belden et al. 2020, figure 2";
    const std::string table = "Barlow et al. 2017, table of the Sakiadis approximants";
    const std::vector<published_number> all{
        {"blasius", {}, "", "f''(0) for f'(inf) = 1", 0, "0.33205733621519629893718006201058", "OEIS A256522"},
        {"falkner_skan", {"b = 1/2"}, "", "s", 0, "0.927680039836653", wall},
        {"falkner_skan", {"b = 0", "s = 0.47"}, "", "s", 0, "0.469599988361", wall},
        {"falkner_skan", {"b = -0.12", "s = 0.282"}, "", "s", 0, "0.28176052424", wall},
        {"falkner_skan", {"b = -0.1988", "s = 0"}, "b", "b", 0, "-0.198837735", wall},
        {"falkner_skan", {"b = -0.12", "s = -0.143"}, "", "s", 0, "-0.1429351943576", wall},
        {"falkner_skan", {"b = -0.02", "s = -0.0652"}, "", "s", 0, "-0.065168585542904", wall},
        {"falkner_skan", {"b = 1", "s = 1.2326"}, "", "s", 0, "1.232587656820289", "public codes"},
        {"falkner_skan", {"b = 1", "s = 1.2326"}, "", "s", 0, "1.23258765682022", "public codes"},
        {"sakiadis", {}, "", "f''(0)", 0, "-0.443748313368861", "Barlow et al. 2017"},
        {"sakiadis", {}, "", "f(inf)", 0, "1.616125446804603", "Barlow et al. 2017"},
        {"sakiadis", {}, "", "f''(0)", 5, "-0.464241808775", table},
        {"sakiadis", {}, "", "f(inf)", 5, "1.57791591603", table},
        {"sakiadis", {}, "", "G", 5, "-1.9379232426", table},
        {"sakiadis", {}, "", "f''(0)", 7, "-0.445957694266", table},
        {"sakiadis", {}, "", "f(inf)", 7, "1.61001774844", table},
        {"sakiadis", {}, "", "G", 7, "-2.0928590899", table},
        {"sakiadis", {}, "", "f''(0)", 9, "-0.443970941603", table},
        {"flierl_petviashvili", {}, "", "w0", 0, "2.391956403224", "computed elsewhere"},
        {"sir", {}, "", "S(inf)", 0, "76.0563587702", "computed elsewhere"},
        {"rayleigh", {}, "", "collapse", 0, "0.9146813565", "Rayleigh 1917, by Gamma functions"},
    };
    std::vector<published_number> of_problem;
    for (const published_number& each : all) {
        if (each.problem == problem) {
            of_problem.push_back(each);
        }
    }
    return of_problem;
}

}  // namespace libration::studies
