// libration cite: BibTeX for the program and for the paper whose solutions it computes.
#include <fmt/format.h>

#include "option/subcommand.hpp"
#include "text/table.hpp"
#include "version.hpp"

namespace libration {

namespace {

// The year of the paper is not in its source, so the entry has none.
constexpr const char* paper_entry = R"(@unpublished{pendulum_series,
  author = {Reinberger, W. Cade and Holland, Morgan S. and Barlow, Nathaniel S. and Weinstein, Steven J.},
  title  = {On the trajectory of the nonlinear pendulum: {E}xact analytic solutions via power series},
  note   = {Preprint}
}
)";

int cite() {
    write_to_stdout(
        fmt::format("@software{{libration,\n"
                    "  author  = {{{{The Libration authors}}}},\n"
                    "  title   = {{Libration: arbitrary-precision power-series solutions of the nonlinear "
                    "pendulum}},\n"
                    "  version = {{{}}},\n"
                    "  note    = {{Commit {}}}\n"
                    "}}\n\n{}",
                    build::version, build::commit, paper_entry));
    return 0;
}

}  // namespace

subcommand cite_command(CLI::App& program) {
    return {program.add_subcommand("cite", "print BibTeX for the program and for the paper"), cite};
}

}  // namespace libration
