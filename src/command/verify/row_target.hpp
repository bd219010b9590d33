// Where the rows of `libration verify` go.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

namespace libration {

/// stdout, or a file that is written to a temporary name and renamed when complete. An existing target that is not a
/// regular file (a pipe, a device) is written to directly.
class row_target {
public:
    /// Throws input_error where the file cannot be written, as everything here.
    explicit row_target(const std::optional<std::string>& path);
    row_target(const row_target&) = delete;
    row_target& operator=(const row_target&) = delete;
    /// Removes the temporary file unless it was finished.
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
