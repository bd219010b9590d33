// How much it matters that a statement does not hold as printed.
#pragma once

#include <optional>
#include <string>

namespace libration {

/// The kind of what has to be corrected. A claim that fails or needs a correction has one.
enum class severity {
    formula,    ///< a program written from the printed formula gives wrong numbers
    statement,  ///< a statement about the mathematics that is not so, or not in this generality
    wording     ///< a caption, a label or a missing word; what is meant is correct
};

/// formula | statement | wording.
std::string name_of(severity s);

/// The severity of a claim that does not hold as printed; nothing for the others.
std::optional<severity> severity_of(const std::string& claim);

}  // namespace libration
