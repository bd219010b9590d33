// One row of a file under `libration verify`: which motion it means, what the truth is, and the verdict.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/pendulum/proved/condition.hpp"
#include "libration/scalar/ball/judgement.hpp"
#include "text/csv_records.hpp"

namespace libration {

/// A cell for each number of a motion, empty where there is none.
struct motion_cells {
    std::string theta0;
    std::string omega0;
    std::string gap;
    std::string energy;
    std::string direction;

    bool names_a_motion() const { return (!theta0.empty() && !omega0.empty()) || !gap.empty() || !energy.empty(); }
    /// Takes from another what is empty here.
    void complete_from(const motion_cells& other);
    bool is_empty() const { return theta0.empty() && omega0.empty() && gap.empty() && energy.empty(); }
    std::string text() const { return theta0 + ',' + omega0 + ',' + gap + ',' + energy + ',' + direction; }
};

/// Where the columns of a file are.
struct verify_columns {
    std::size_t count = 0;
    std::size_t time = 0;
    std::size_t theta = 0;
    std::optional<std::size_t> omega, theta0, omega0, gap, energy, direction;
    /// Where a table of ours says how a number was typed: what stands there is exact.
    std::optional<std::size_t> time_typed, theta0_typed, omega0_typed, gap_typed, energy_typed;

    bool names_a_motion() const { return (theta0 && omega0) || gap || energy; }
};

/// How values are judged: against an absolute tolerance, in units in the last place of a double of max(1, |value|), or,
/// with neither, in one unit of their last digit as written.
struct verify_rules {
    std::optional<rational> tolerance;
    std::optional<rational> ulps;
    bool inputs_are_doubles = false;
    motion_cells usual;  ///< what a row has not of a motion
    exact squared_frequency = exactly(1);
};

enum class row_verdict { ok, miss, malformed };

/// A row as it is written, and what the summary needs of it.
struct judged_row {
    long line;
    row_verdict verdict;
    std::string text;
    std::string reason;  ///< of what is malformed, or which value misses
    std::string error;
    std::optional<long> tenths_of_digits;  ///< nothing for an error of 0
    std::string condition;
    mpfr of_tolerance;  ///< error/tolerance, of the worse of theta and omega
};

/// What is asked of a row: the time, the values and the motion, read exactly.
struct asked_row {
    exact time;
    std::string theta;
    std::string omega;
    motion_cells motion;
};

/// Judges rows one after the other. Motions met lately are kept, so that rows of one motion share its work; what a row
/// becomes does not depend on the rows before. One object for each thread.
class row_judge {
public:
    row_judge(const verify_columns& columns, const verify_rules& rules) : columns_(columns), rules_(rules) {}
    judged_row operator()(const csv_record& record);

private:
    struct known_motion {
        std::string text;
        pendulum::typed_motion typed;
        pendulum::motion exactly;
        std::vector<std::pair<long, std::unique_ptr<pendulum::conditioned_motion>>> by_digits;
    };
    struct value_verdicts {
        judgement theta;
        std::optional<judgement> omega;
        std::string condition;
    };

    asked_row read(const std::vector<std::string>& cells) const;
    judged_row judged(const csv_record& record, const std::vector<std::string>& cells);
    known_motion& motion_for(const motion_cells& cells);
    static const pendulum::conditioned_motion& in_precision(known_motion& known, long digits);
    value_verdicts verdicts(const asked_row& row, known_motion& known);
    std::optional<value_verdicts> try_verdicts(const asked_row& row, known_motion& known, long digits,
                                               bool last_attempt) const;
    std::optional<judgement> judge_value(const std::string& text, const ball& truth, bool last_attempt) const;
    judged_row malformed(const csv_record& record, const std::vector<std::string>& cells,
                         const std::string& reason) const;

    const verify_columns& columns_;
    const verify_rules& rules_;
    std::vector<std::unique_ptr<known_motion>> known_;  // latest first
};

/// The columns that verify adds, in their order.
std::vector<std::string> added_columns(const verify_columns& columns);

}  // namespace libration
