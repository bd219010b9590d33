// The program `libration`, as its own main and that of the ranks of MPI start it.
#pragma once

namespace libration {

/// Reads the command line and runs its subcommand: data to stdout, messages to stderr. Returns the exit code: 0 done, 1
/// a check failed, 2 bad usage or input.
int run_program(int argc, char** argv);

}  // namespace libration
