// The integrator of a problem: --integrator, --trace, and the lines that state what was used.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/integration/integrator.hpp"

namespace libration {

/// --integrator automatic|taylor|collocation.
class integrator_options {
public:
    void add_to(CLI::App& command);
    /// automatic without the option. Throws input_error for any other word.
    ode::integrator_choice choice() const;
    /// Whether the equations are to be integrated even if a closed form is known.
    bool integrates() const { return choice() != ode::integrator_choice::automatic; }
    /// A line on stderr for each use of collocation, or that no step of it was proved, or found in rounded arithmetic,
    /// although it is chosen.
    void state(const std::vector<ode::collocation_use>& used, bool proved = true) const;

private:
    std::optional<std::string> integrator_;
};

/// The file of --trace: one line of CSV per step, written next to it and renamed at the end, also if an exception ends
/// the integration, or --timeout or a signal ends the process within a step.
class step_trace {
public:
    /// Throws input_error if the file cannot be written.
    explicit step_trace(const std::string& path);
    ~step_trace();
    step_trace(const step_trace&) = delete;
    step_trace& operator=(const step_trace&) = delete;

    void add(const ode::step_report& step);
    /// Renames the file. Throws input_error.
    void finish();

private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

}  // namespace libration
