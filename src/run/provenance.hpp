// What made a result: version, commit, compiler and libraries.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace libration {

/// (name, version) of the program and of what it stands on, with the thread safety of MPFR.
std::vector<std::pair<std::string, std::string>> provenance();

/// The same as the lines of --version.
std::string version_text();

/// Version and commit of the program: what cells depend on besides their study. Where sources
/// are not committed, a hash of what was changed stands beside it.
std::string program_identity();

}  // namespace libration
