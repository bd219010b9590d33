// From a folder of new results to the published one.
#pragma once

#include <string>
#include <vector>

namespace libration {

/// Replaces these parts (studies, claims, reference) of the published folder by those made, each whole, and writes its
/// pages anew; what else is there stays. Throws input_error where the published folder cannot be written.
void publish(const std::string& made, const std::string& published, const std::vector<std::string>& parts);

}  // namespace libration
