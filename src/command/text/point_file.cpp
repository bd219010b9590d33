#include "text/point_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "text/column_file.hpp"

namespace libration {

namespace {

constexpr std::size_t most_rows = 10'000'000;

}  // namespace

point_file::point_file(const std::string& option, const std::string& path, const std::optional<std::string>& mapping,
                       std::vector<known_column> known) {
    input_stream source(option, path);
    column_file records(source);
    names_.emplace(source.name(), records.names(), records.count(), mapping, std::move(known));
    while (const auto record = records.next()) {
        auto cells = records.cells(*record);
        if (!cells) {
            fail(record->line, "a quote is not closed", error_kind::argument);
        }
        if (cells->size() != names_->count()) {
            fail(record->line, fmt::format("the row has {} cells, the header has {}", cells->size(), names_->count()),
                 error_kind::argument);
        }
        if (rows_.size() == most_rows) {
            throw input_error(fmt::format("{} has more than {} rows: give fewer", source.title(), most_rows));
        }
        rows_.push_back({record->line, *std::move(cells)});
    }
    if (rows_.empty()) {
        throw input_error(fmt::format("{} has no row: write one below its names", names_->file()));
    }
}

void point_file::fail(long line, const std::string& reason, error_kind kind) const {
    const std::string where = fmt::format("{}:{}", without_controls(names_->file(), longest_quotation), line);
    if (kind == error_kind::undecided) {
        throw error(kind, where + ":", "", reason);
    }
    throw input_error(where + ": " + reason + ": write this row again or leave it out");
}

}  // namespace libration
