// The options that subcommands share: digits and scalar, output.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/scalar/dispatch.hpp"
#include "option/defaults.hpp"
#include "text/table.hpp"

namespace libration {

/// A number of an option; throws input_error.
exact number_of(const std::string& option, const std::string& value);

/// A number of an option above 0; throws input_error.
exact positive_number_of(const std::string& option, const std::string& value);

/// Digits of the columns of errors.
inline constexpr long error_digits = 6;

/// The arithmetic of a command and the digits it prints.
struct arithmetic {
    scalar_spec scalar;
    long digits;
};

/// --digits D and --scalar S: without S, mpfr of the digits asked; without both, mpfr of defaults::digits.
class arithmetic_options {
public:
    void add_to(CLI::App& command, arithmetics offered = arithmetics::rounding);
    arithmetic choose() const;
    /// What was given for --scalar.
    const std::optional<std::string>& scalar() const { return scalar_; }

private:
    std::optional<std::string> digits_, scalar_;
    arithmetics offered_ = arithmetics::rounding;
};

/// --format text|csv|json|latex, --columns NAMES and --out FILE.
class output_options {
public:
    output_options() = default;
    /// With more formats than these, which the command writes itself, all columns, and another usual one.
    output_options(std::string usual, const std::vector<std::string>& more);

    /// Without --columns, for commands in which it has another meaning.
    enum class columns_option { own, not_here };
    void add_to(CLI::App& command, columns_option columns = columns_option::own);
    /// The columns of --columns, of a command that reads that option itself.
    void choose_columns(std::string names) { columns_ = std::move(names); }
    /// Throws input_error for a format that is none and a file that cannot be written.
    void check() const;
    const std::string& format() const { return format_; }
    const std::optional<std::string>& file() const { return out_; }
    /// The same without --out.
    output_options on_stdout() const {
        output_options same = *this;
        same.out_.reset();
        return same;
    }
    /// Writes the table to stdout or the file. `text` is what the text format shows instead of the aligned table.
    void write(const table& data, const std::optional<std::string>& text = std::nullopt) const;
    /// Writes what is already in its format.
    void write_content(const std::string& content) const;

private:
    std::string offered() const;

    std::vector<std::string> formats_{"text", "csv", "json", "latex"};
    std::string format_ = defaults::format;
    std::optional<std::string> columns_, out_;
};

/// The columns of a table that the words of --columns name, a,b,c, in that order. Throws input_error of --columns for a
/// name that it does not have.
table with_named_columns(const table& data, const std::string& names);

/// A table in one of the formats that every command has.
std::string in_format(const std::string& format, const table& data);

/// Adds --digits D to a command without a choice of arithmetic, all of whose digits are proved.
void add_digits(CLI::App& command, std::optional<std::string>& value);

/// The --digits D of a command without a choice of arithmetic.
long digits_of(const std::optional<std::string>& value, long usual = defaults::digits);

/// The --order N of a method.
int order_of(const std::string& option, const std::string& value);

/// A folder that a command is about to fill, made with its parents where they are missing. Unless keep() is called,
/// what was made and is still empty is taken away again, so that a failed command leaves nothing behind.
class output_folder {
public:
    /// Throws input_error when the folder cannot be made or written.
    output_folder(const std::string& option, std::string path);
    output_folder(const output_folder&) = delete;
    output_folder& operator=(const output_folder&) = delete;
    ~output_folder();

    void keep() { kept_ = true; }
    const std::string& path() const { return path_; }

private:
    void take_away();

    std::string path_;
    std::vector<std::string> made_;  // innermost last
    bool kept_ = false;
};

}  // namespace libration
