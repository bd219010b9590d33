// libration cite: BibTeX for the program and for the paper whose solutions it computes.
#include <fmt/format.h>

#include <string>

#include "option/subcommand.hpp"
#include "text/table.hpp"
#include "version.hpp"

namespace libration {

namespace {

constexpr const char* paper_entry = R"(@misc{pendulum_series,
  author        = {Reinberger, W. Cade and Holland, Morgan S. and Barlow, Nathaniel S. and Weinstein, Steven J.},
  title         = {On the trajectory of the nonlinear pendulum: {E}xact analytic solutions via power series},
  year          = {2021},
  eprint        = {2108.09395},
  archiveprefix = {arXiv},
  url           = {https://arxiv.org/abs/2108.09395}
}
)";

// The year of the commit; the program has no web address.
std::string program_entry() {
    const std::string year(build::year);
    return fmt::format(
        "@software{{libration,\n"
        "  author  = {{{{The Libration authors}}}},\n"
        "  title   = {{Libration: power-series solutions of ordinary differential equations to arbitrary precision, "
        "with rigorous error bounds}},\n"
        "{}"
        "  version = {{{}}},\n"
        "  note    = {{Commit {}}}\n"
        "}}\n",
        year.empty() ? "" : "  year    = {" + year + "},\n", build::version, build::commit);
}

int cite() {
    write_to_stdout(program_entry() + "\n" + paper_entry);
    return 0;
}

}  // namespace

subcommand cite_command(CLI::App& program) {
    return {program.add_subcommand("cite", "print BibTeX for the program and for the paper"), cite};
}

}  // namespace libration
