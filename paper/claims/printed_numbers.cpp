#include "printed_numbers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace libration {

namespace {

// In the order of the source, as REVTeX counts: sections, then figures, then equations.
constexpr std::array<std::pair<std::string_view, std::string_view>, 68> printed_numbers{{
    {"sec:intro", "section I"},
    {"sec:background", "section II"},
    {"sec:series", "section III"},
    {"sec:reccurence", "section III A"},
    {"sec:sing", "section III B"},
    {"sec:convergence", "section III C"},
    {"sec:approximant", "section IV"},
    {"sec:period", "section V"},
    {"sec:conclusions", "section VI"},
    {"sec:A1", "appendix A"},
    {"fig:problem_setup", "figure 1"},
    {"fig:surf", "figure 2"},
    {"fig:series", "figure 3"},
    {"fig:subcrit", "figure 4"},
    {"fig:supercrit", "figure 5"},
    {"fig:librationfixed", "figure 6"},
    {"fig:rotationfixed", "figure 7"},
    {"fig:librationseries", "figure 8"},
    {"fig:error", "figure 9"},
    {"fig:librationapproximant", "figure 10"},
    {"fig:perioderror", "figure 11"},
    {"fig:period", "figure 12"},
    {"pendeq", "unnumbered equation before (1a)"},
    {"pendeqnd", "(1)"},
    {"pendalone", "(1a)"},
    {"ics", "(1b)"},
    {"energynd", "(2)"},
    {"T", "(3)"},
    {"K", "(4)"},
    {"Tstar", "(5)"},
    {"critical", "(6a)"},
    {"subcritical", "(6b)"},
    {"supercritical", "(6c)"},
    {"pendcoeffs", "(7)"},
    {"sineseries", "(8)"},
    {"eseries", "(9)"},
    {"deseries", "(11)"},
    {"eCauchy", "(12)"},
    {"eCoeffs", "(13)"},
    {"cosseries", "(14)"},
    {"components", "(15)"},
    {"pendseries", "(16)"},
    {"sum", "(16a)"},
    {"seriesrec", "(16b)"},
    {"cosseriesrec", "(16c)"},
    {"sinseriesrec", "(16d)"},
    {"libratingpoles", "(17)"},
    {"Kp", "(18)"},
    {"librationROC", "(19)"},
    {"rotatingpoles", "(20)"},
    {"rotationROCgood", "(21)"},
    {"seriesfixed", "(22)"},
    {"newseries", "(23)"},
    {"Ttilde", "(23a)"},
    {"symmetry", "(23b)"},
    {"fullresummation", "(24)"},
    {"resummation", "(24a)"},
    {"omegab", "(24b)"},
    {"beforeproduc", "unnumbered equation before (24c)"},
    {"b", "(24c)"},
    {"approxcoeffs", "(24d)"},
    {"Kold", "(25)"},
    {"K2", "(26)"},
    {"zero", "(27)"},
    {"Knew", "(28)"},
    {"efficient", "(A1)"},
    {"truncation", "(A1a)"},
    {"truncation2", "(A1b)"},
}};

std::string printed_number(std::string_view label) {
    for (const auto& [name, number] : printed_numbers) {
        if (name == label) {
            return std::string(number);
        }
    }
    return {};
}

// The parts of a label between commas and semicolons, each with what separates it from the one before.
struct label_part {
    std::string before, text;
};

std::vector<label_part> parts_of(const std::string& label) {
    std::vector<label_part> parts{{}};
    for (const char c : label) {
        const bool separates = c == ',' || c == ';' || (c == ' ' && parts.back().text.empty());
        if (separates && !parts.back().text.empty()) {
            parts.emplace_back();
        }
        (separates ? parts.back().before : parts.back().text) += c;
    }
    return parts;
}

// Lower case, with the short words for figure, section and equation written out; the number alone of an equation.
std::string normal_form(std::string asked) {
    std::ranges::transform(asked, asked.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::array<std::pair<std::string_view, std::string_view>, 8> words{{{"fig. ", "figure "},
                                                                              {"fig ", "figure "},
                                                                              {"sec. ", "section "},
                                                                              {"sec ", "section "},
                                                                              {"eq. ", ""},
                                                                              {"eq ", ""},
                                                                              {"equation ", ""},
                                                                              {"section a", "appendix a"}}};
    for (const auto& [shorter, longer] : words) {
        if (asked.starts_with(shorter)) {
            asked = std::string(longer) + asked.substr(shorter.size());
        }
    }
    if (asked.starts_with('(') && asked.ends_with(')')) {
        asked = asked.substr(1, asked.size() - 2);
    }
    return asked;
}

// Whether what is left of a number behind `asked` names a part of it: (16)c, section III B.
bool is_part(const std::string& number, const std::string& asked) {
    if (!number.starts_with(asked)) {
        return false;
    }
    const std::string rest = number.substr(asked.size());
    return rest.empty() ||
           (rest.size() == 1 && std::isalpha(static_cast<unsigned char>(rest[0])) != 0 &&
            std::isdigit(static_cast<unsigned char>(asked.back())) != 0) ||
           (rest.starts_with(' ') && asked.starts_with("section"));
}

}  // namespace

std::string printed_place(const std::string& label) {
    std::string place;
    for (const label_part& each : parts_of(label)) {
        const std::string number = printed_number(each.text);
        place += each.before + (number.empty() ? each.text : number);
    }
    return place;
}

bool concerns(const std::string& label, const std::string& asked) {
    const std::string wanted = normal_form(asked);
    const auto parts = parts_of(label);
    // Of the words that are not labels, only the abstract is a place.
    return !wanted.empty() && std::ranges::any_of(parts, [&](const label_part& each) {
        const std::string number = printed_number(each.text);
        return number.empty() ? each.text == wanted && wanted == "abstract"
                              : each.text == asked || is_part(normal_form(number), wanted);
    });
}

}  // namespace libration
