// The named sets of work of `libration reproduce`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/named_order.hpp"

namespace libration {

/// What is reproduced: studies, examples of studies of any equation, and whether the claims are tested and the
/// reference values computed.
struct reproduce_set {
    std::vector<const study*> studies;
    bool claims = false;
    bool references = false;
    std::vector<const study_order*> examples = {};
};

/// The names of claims and reference values, in addition to those of the studies.
inline constexpr const char* claims_name = "claims";
inline constexpr const char* references_name = "reference";

/// The path of a part in a results directory: the file claims.csv, or a directory with its name.
std::string place_of_part(const std::string& part);

/// The file without which a part is not made: claims.csv, or the description NAME/NAME.json.
std::string description_of_part(const std::string& part);

/// A set by its name:
///   paper      the paper's studies, its claims and the reference values; studies that come later are not in it
///   problems   the studies of other problems, and those of any equation on their examples
///   proved     what has proofs: the studies that offer balls, and the reference values
///   all        everything
/// Throws input_error for another name, and for a set that holds nothing.
reproduce_set set_named(const std::string& name);

/// Those of --only, if given, instead of the set's, without those of --skip. Throws input_error for an unknown name and
/// if nothing remains.
reproduce_set chosen_of(reproduce_set set, const std::optional<std::string>& only,
                        const std::optional<std::string>& skip);

}  // namespace libration
