// The command `libration` on the ranks of MPI: ./run --mpi -n K study NAME ...
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "program.hpp"
#include "sweep/ranks.hpp"

namespace {

// The other ranks read the same command line: errors in it are reported once.
void be_silent() {
    const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
}

int run_first(const libration::mpi_ranks& ranks, int argc, char** argv) {
    libration::executor() = [&ranks](const auto& of, const auto& work, const auto& events) {
        ranks.compute(of, work, events);
    };
    const int code = libration::run_program(argc, argv);
    ranks.release();
    return code;
}

int run_other(libration::mpi_ranks& ranks, int argc, char** argv) {
    be_silent();
    libration::cell_server() = [&ranks](const libration::study_cells& of) { ranks.serve(of); };
    libration::run_program(argc, argv);
    ranks.wait_for_release();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        libration::mpi_ranks ranks(&argc, &argv);
        if (argc < 2 || std::string_view(argv[1]) != "study") {
            if (ranks.is_first()) {
                fmt::print(stderr,
                           "libration: --mpi '{}' is not a study: write ./run --mpi -n K study NAME ..., and run "
                           "other commands without --mpi\n",
                           argc < 2 ? "" : argv[1]);
            }
            return 2;
        }
        return ranks.is_first() ? run_first(ranks, argc, argv) : run_other(ranks, argc, argv);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "libration: {}\n", problem.what());
        return 1;
    }
}
