// A file of points at which a command computes: every row is read before anything is computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/error.hpp"
#include "text/column_names.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

/// The rows of a file with the names of its columns.
class point_file {
public:
    struct row {
        long line;
        std::vector<std::string> cells;
    };

    /// `option` is what named the file, `mapping` is --columns. Throws input_error for a file that cannot be read, that
    /// has no row, and for a row that has another number of cells than the first line.
    point_file(const std::string& option, const std::string& path, const std::optional<std::string>& mapping,
               std::vector<known_column> known);

    const column_names& names() const { return *names_; }
    const std::vector<row>& rows() const { return rows_; }
    /// read(cells) of a row; an error becomes an input_error that names file and line.
    template <class Read>
    auto reading(const row& at, const Read& read) const {
        try {
            return read(at.cells);
        } catch (const error& problem) {
            fail(at.line, message_of(problem), problem.kind());
        }
    }

private:
    [[noreturn]] void fail(long line, const std::string& reason, error_kind kind) const;

    std::optional<column_names> names_;
    std::vector<row> rows_;
};

}  // namespace libration
