#include "claim.hpp"

#include <iterator>
#include <stdexcept>
#include <utility>

#include "printed_numbers.hpp"
#include "run/parallel.hpp"
#include "severity.hpp"
#include "text/table.hpp"

namespace libration {

std::string name_of(verdict v) {
    switch (v) {
        case verdict::holds: return "holds";
        case verdict::corrected: return "holds with correction";
        case verdict::fails: break;
    }
    return "fails";
}

std::vector<claim> all_claims() {
    std::vector<claim> all;
    for (const auto& part : {claims_of_background, claims_of_exact_period, claims_of_closed_solutions, claims_of_series,
                             claims_of_singularities, claims_of_singularities_of_rotation, claims_of_extension,
                             claims_of_resummation, claims_of_resummation_errors, claims_of_period,
                             claims_of_conclusions, claims_of_scenarios, claims_of_appendix, claims_of_libration}) {
        auto more = part();
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return all;
}

bool is_own(const std::string& label) { return label.starts_with("libration:"); }

std::vector<judged_claim> judge(const std::vector<claim>& claims, int jobs) {
    constexpr long claim_digits = 50;
    progress shown("claims", claims.size());
    auto findings = parallel_map(claims.size(), jobs, shown, [&](std::size_t i) {
        const precision_scope scope(claim_digits);
        try {
            return claims[i].measure();
        } catch (const std::exception& problem) {
            throw std::runtime_error("claim " + claims[i].name + ": " + problem.what());
        }
    });
    std::vector<judged_claim> judged;
    judged.reserve(claims.size());
    for (std::size_t i = 0; i < claims.size(); ++i) {
        judged.push_back({&claims[i], std::move(findings[i])});
    }
    return judged;
}

namespace {

std::string severity_cell(const judged_claim& judged) {
    const auto found = severity_of(judged.of->name);
    return judged.found.verdict == verdict::holds || !found ? "" : name_of(*found);
}

}  // namespace

table claims_table(const std::vector<judged_claim>& judged) {
    table result({{"claim", "name, also of the test"},
                  {"label", "where it stands in the paper's source"},
                  {"statement", "in our words"},
                  {"verdict", "holds | holds with correction | fails"},
                  {"number", "the measured number, to 3 digits"},
                  {"measured", "what the number is"},
                  {"correction", "what is true instead"},
                  {"command", "shows it"},
                  {"severity", "of what does not hold as printed: formula | statement | wording"},
                  {"printed", "the label as the paper prints it: number of equation, figure or section"}});
    constexpr long shown_digits = 3;
    for (const judged_claim& each : judged) {
        const claim& c = *each.of;
        result.add_row({c.name, c.label, c.statement, name_of(each.found.verdict),
                        decimal_cell(each.found.number, shown_digits), c.number, c.correction, c.command,
                        severity_cell(each), is_own(c.label) ? "" : printed_place(c.label)});
    }
    return result;
}

}  // namespace libration
