// Where the files are that the program needs: in the tree that it was built from, or where it was installed.
#pragma once

#include <string>

namespace libration {

/// Whether the running program is the one in its build folder, whose files are those of the source tree. An installed
/// one never looks there.
bool runs_from_build_folder();

/// A path relative to the folder of the running program.
std::string path_from_program(const std::string& relative);

/// A program that is started by this one, by its name: next to it in the build directory, or where it was installed.
std::string peer_program(const std::string& name);

}  // namespace libration
