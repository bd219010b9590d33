// The limit of work for a row of a table: a proof that would not reach its time is abandoned, so that the other rows
// are compared.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "libration/integration/proved_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// A row needs more work than its limit; of the kind undecided.
struct work_limit : error {
    using error::error;
};

/// The steps of the proofs for one row at a time, times n^2 max(1, bits/64)^2 for n unknowns. Not a duration: the same
/// file has the same verdicts on every machine.
class row_work {
public:
    /// About a minute.
    static constexpr double most = 2e7;

    explicit row_work(std::size_t unknowns) : per_step_(static_cast<double>(unknowns * unknowns)) {}

    /// The next row, at a time that is before the start of the problem for direction < 0; `text` is for messages.
    /// Throws work_limit if a row nearer to the start was abandoned.
    void begin(const number& time, const std::string& text, int direction);
    /// Called after some steps of a proof, and before the first. Throws work_limit if the row has cost more than
    /// `most`, and if more than proved_march::most_steps steps of the length of the last ones are needed, unless these
    /// grow: 512 of them are less than twice as long as the 512 before.
    void add(const proved_march& march);

private:
    [[noreturn]] void give_up(const proved_march& march, const std::string& reason);
    bool is_out_of_reach(const proved_march& march);

    double per_step_;
    double cost_ = 0;
    number time_;
    std::string text_;
    bool forward_ = true;
    std::array<std::optional<number>, 2> given_up_;  // the nearest, before and behind the start
    long steps_ = 0;                                 // of the proof
    long marked_steps_ = 0;                          // where the length of steps was measured last
    std::optional<mpfr> marked_, mean_;
};

}  // namespace libration::ode
