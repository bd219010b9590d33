// The program `libration`, called by its main and by that of the MPI ranks.
#pragma once

namespace libration {

/// Parses the command line and runs its subcommand: data to stdout, messages to stderr. Returns the exit code: 0
/// success, 1 a check failed, 2 invalid usage or input.
int run_program(int argc, char** argv);

/// From then on a failure of GMP or FLINT, and failed allocations where no exception is caught, end the process with
/// a message and the exit code 1. run_program() calls it.
void prepare_for_failures();

}  // namespace libration
