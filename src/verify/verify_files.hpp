// The files of `libration verify`: where the rows come from and where they go.
#pragma once

#include <cstdio>
#include <fstream>
#include <optional>
#include <string>

#include "text/csv_records.hpp"

namespace libration {

/// A CSV file, or stdin for "-", as records.
class row_source {
public:
    /// Throws input_error where the file cannot be read.
    explicit row_source(const std::string& path);
    csv_records& records() { return records_; }

private:
    std::ifstream file_;
    csv_records records_;
};

/// stdout, or a file that is written beside and renamed when it is whole. What exists and is no regular file (a pipe, a
/// device) is written to as it is.
class row_target {
public:
    /// Throws input_error where the file cannot be written, as everything here.
    explicit row_target(const std::optional<std::string>& path);
    row_target(const row_target&) = delete;
    row_target& operator=(const row_target&) = delete;
    /// Unless it was finished, what was written beside is taken away.
    ~row_target();

    void write(const std::string& text);
    void finish();

private:
    [[noreturn]] void fail() const;
    void remove_part() const;

    std::string path_;
    std::string written_;
    std::FILE* file_ = stdout;
};

}  // namespace libration
