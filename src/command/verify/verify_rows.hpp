// One row of a file under `verify`: its values compared with the truth, and what becomes of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/verification/compare_rules.hpp"
#include "text/column_file.hpp"
#include "text/column_names.hpp"
#include "verify/row_question.hpp"
#include "verify/row_writer.hpp"

namespace libration {

/// undecided: the row can be read, and what it is compared with is not proved within the limits.
enum class row_verdict { ok, miss, malformed, undecided };

/// A row as it is written, and what the summary needs of it.
struct compared_row {
    long line = 0;
    row_verdict verdict = row_verdict::malformed;
    std::string text;
    std::string reason;  ///< of what is malformed or undecided, or which value misses
    std::string column;  ///< of the value that is worst
    std::string error;
    std::optional<long> least_tenths;  ///< correct digits of the value that is worst; nothing for an error of 0
    std::string condition;
    bool proved = true;           ///< what the row is compared with
    mpfr of_tolerance = mpfr(0);  ///< error/tolerance of the value that is worst
    std::optional<row_numbers> numbers;
};

/// Whether a value is worse than another one: fewer correct digits or, with as many, a larger part of its tolerance.
bool is_worse(const std::optional<long>& tenths, const mpfr& of_tolerance, const std::optional<long>& other_tenths,
              const mpfr& other_of_tolerance);

/// Compares rows one after the other. One object for each thread.
class row_comparer {
public:
    /// `of_doubles`: whether each compared column holds doubles (double_columns).
    row_comparer(std::unique_ptr<question_reader> reader, const compare_rules& rules, const column_names& names,
                 const row_writer& writer, const std::vector<bool>& of_doubles)
        : reader_(std::move(reader)), rules_(rules), names_(names), writer_(writer), of_doubles_(of_doubles) {}
    compared_row operator()(const csv_record& record);

private:
    compared_values compared(const std::vector<std::string>& cells);
    compared_row row_of(const csv_record& record, const std::vector<std::string>& cells,
                        const compared_values& here) const;
    compared_row without_values(row_verdict verdict, const csv_record& record, std::vector<std::string> cells,
                                const std::string& reason) const;
    const std::string& own_name(std::size_t i) const { return names_.own(reader_->columns()[i].at); }

    std::unique_ptr<question_reader> reader_;
    const compare_rules& rules_;
    const column_names& names_;
    const row_writer& writer_;
    const std::vector<bool>& of_doubles_;
};

/// The columns that verify adds, in their order: those of the first value, the verdict and the condition, and those of
/// every further value with its name before.
std::vector<std::string> added_columns(const std::vector<compared_column>& compared);

}  // namespace libration
