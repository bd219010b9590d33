// Measures one claim of the table by its name.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "paper/claims/claim.hpp"
#include "text/table.hpp"

namespace libration {

/// The published table of claims.
inline std::string published_claims() {
    std::ifstream file(LIBRATION_SOURCE_DIR "/results/claims.csv", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The finding of the claim `name`, measured with 50 digits; its row of the table has to be the published one. Throws
/// std::invalid_argument if there is none.
inline finding measured(const std::string& name) {
    auto claims = all_claims();
    std::erase_if(claims, [&](const claim& each) { return each.name != name; });
    if (claims.size() != 1) {
        throw std::invalid_argument("there is no claim " + name);
    }
    const auto judged = judge(claims, 1);
    const std::string rows = to_csv(claims_table(judged));
    CHECK_THAT(published_claims(), Catch::Contains(rows.substr(rows.find('\n'))));
    return judged.front().found;
}

}  // namespace libration
