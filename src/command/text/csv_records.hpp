// A file of cells as a stream of records: one at a time, in constant memory, with the line on which each starts.
#pragma once

#include <deque>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace libration {

/// A record exactly as written in the file, without its line end.
struct csv_record {
    long line;
    std::string text;
};

/// The separator of the cells of a record: one of these characters, or any number of blanks.
enum class separator : char { comma = ',', semicolon = ';', tabulator = '\t', blanks = ' ' };

/// That of a line: semicolons where there are as many as commas, commas, tabulators, else blanks.
separator separator_of(const std::string& line);

/// Splits a stream into records: lines, joined where a quoted cell holds a line end. A quote that nothing closes within
/// 64 KiB spoils its own line only. Blank lines are left out, line ends are LF or CRLF, a byte-order mark is dropped.
class csv_records {
public:
    /// `title` is what messages call the stream.
    explicit csv_records(std::istream& in, std::string title = "input") : in_(in), title_(std::move(title)) {}
    /// Throws input_error for a line of more than longest_line characters.
    std::optional<csv_record> next();
    static constexpr std::size_t longest_line = std::size_t{1} << 24;
    /// From the next record on; commas before.
    void separate_by(separator between) { between_ = between; }

private:
    bool take_line(std::string& line);

    bool read_line(std::string& line);

    std::istream& in_;
    std::string title_;
    std::deque<std::string> pending_;  // lines that were read ahead
    separator between_ = separator::comma;
    long line_ = 0;
};

/// The cells of a record, and whether the quote of the last one is closed. Quotes count at the start of a cell and are
/// doubled within.
struct split_record {
    std::vector<std::string> cells;
    bool closed;
};
split_record split_cells(const std::string& record, separator between);

/// The cells; std::nullopt if a quote is not closed.
std::optional<std::vector<std::string>> cells_of(const std::string& record, separator between = separator::comma);

/// A cell as it is written, quoted where CSV needs it.
std::string written_cell(const std::string& cell);

/// A text without the blanks around it.
std::string trimmed(const std::string& text);

}  // namespace libration
