// An integration of a certificate: one sequence of steps, which the checker repeats.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../../integration/collocation/polynomial_map.hpp"
#include "certificate.hpp"
#include "certificate_step.hpp"
#include "libration/integration/collocation/collocation_integrator.hpp"

namespace libration::ode {

/// Called with the time reached and the bits; an exception that it throws ends the work.
using certificate_watch = std::function<void(const ball& reached, long bits)>;

struct run_choice {
    long bits = 0;
    double slowest_fast = collocation_integrator::usual_slowest_fast;
    bool rounds = false;       ///< steps become those of a certificate
    bool keeps_tubes = false;  ///< by the suprema that a certificate has, also without rounding
    std::vector<start_interval> starts = {};
    std::optional<std::size_t> varied = {};  ///< of a form with derivatives by this start
};

class certified_run {
public:
    certified_run(const explicit_system& system, const polynomial_form& form, const run_choice& choice);

    /// Prepares the first step towards this time; false if none is proved.
    bool begin(const rational& farthest);
    /// Takes the prepared step, and prepares the next one; false if none is proved. Throws error of the kind argument and
    /// the subject "certificate" if there are more steps than the format contains, or would be at the present length.
    bool advance(const certificate_watch& watch);
    /// The state at every time of a ball, later than or at those before; std::nullopt if the proof ends before.
    std::optional<std::vector<ball>> at(const ball& time, const certificate_watch& watch);

    /// The prepared step, in a run that rounds or keeps tubes, and the exact time at which it begins.
    const solution_tube& tube() const { return *tube_; }
    const rational& begin_of_step() const { return begin_; }

    long bits() const { return integrator_.bits(); }
    long bits_of_bounds() const;
    /// The steps in the format of the certificate, and their number.
    const std::string& text() const { return text_; }
    long steps() const { return steps_; }

private:
    std::optional<tube_set> start_set() const;
    void add_starts(const explicit_system& system, const run_choice& choice);
    bool prepare();
    void count_step();
    ball first_length(const std::vector<ball>& state, const ball& rest) const;

    const polynomial_form& form_;
    bool begins_in_box_;
    collocation_integrator integrator_;
    polynomial_map map_;
    step_rounding rounding_;
    long bits_ = 0;
    ball time_;
    rational begin_;
    tube_set given_;
    std::optional<solution_tube> tube_;
    std::string text_;
    long steps_ = 0;
    rational farthest_;
    double start_ = 0;
    double counted_from_ = 0;    ///< the time of the last estimate of the length of steps
    double counted_length_ = 0;  ///< that estimate, 0 before the first one
    long taken_ = 0;
};

}  // namespace libration::ode
