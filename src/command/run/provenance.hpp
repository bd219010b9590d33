// What made a result: version, commit, compiler and libraries.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace libration {

/// (name, version) of the program and of the libraries that it uses, with the thread safety of MPFR.
std::vector<std::pair<std::string, std::string>> provenance();

/// The same as the lines of --version.
std::string version_text();

/// Version and commit of the program, on which cells depend in addition to their study. If sources
/// are not committed, a hash of the changes is appended.
std::string program_identity();

}  // namespace libration
