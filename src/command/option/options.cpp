#include "option/options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include "libration/equation/renamed_unknowns.hpp"
#include "libration/number/grid.hpp"
#include "libration/scalar/decimal.hpp"
#include "option/output_place.hpp"
#include "text/input_error.hpp"
#include "text/latex.hpp"

namespace libration {

namespace {

constexpr const char* number_remedy = "write a number such as 1.71, 171/100 or 1e-30";
constexpr int largest_order = 100'000;

}  // namespace

exact number_of(const std::string& option, const std::string& value) {
    exact number = reading(option, value, number_remedy, [&] { return read_exact(value); });
    if (!number.is_number()) {
        throw input_error(option, value, "has a unit", number_remedy);
    }
    return number;
}

exact positive_number_of(const std::string& option, const std::string& value) {
    exact number = number_of(option, value);
    if (sign_of_exact(number) <= 0) {
        throw input_error(option, value, "is not positive", "write a positive number");
    }
    return number;
}

void add_digits(CLI::App& command, std::optional<std::string>& value) {
    command
        .add_option("--digits", value,
                    fmt::format("significant digits, each proved to within one unit in the last place (default: {})",
                                defaults::digits))
        ->type_name("D");
}

long digits_of(const std::optional<std::string>& value, long usual) {
    return value ? reading("--digits", *value, fmt::format("write a number from 1 to {}", most_digits),
                           [&] { return read_digits(*value); })
                 : usual;
}

int order_of(const std::string& option, const std::string& value) {
    return reading(option, value, "write the last power to keep, 0 or more",
                   [&] { return read_count(value, largest_order); });
}

namespace {

std::string names_of(arithmetics offered) {
    return offered == arithmetics::rounding ? "double, long-double, quad or mpfr:DIGITS"
                                            : "double, long-double, quad, mpfr:DIGITS or ball:DIGITS (proved)";
}

}  // namespace

void arithmetic_options::add_to(CLI::App& command, arithmetics offered) {
    offered_ = offered;
    command
        .add_option("--digits", digits_,
                    "significant digits to print, each correct to within one unit in the last place")
        ->type_name("D");
    command.add_option("--scalar", scalar_, "arithmetic: " + names_of(offered))->type_name("S");
}

arithmetic arithmetic_options::choose() const {
    const auto digits = digits_ ? std::optional(digits_of(digits_)) : std::nullopt;
    if (!scalar_) {
        const long wanted = digits.value_or(defaults::digits);
        return {{scalar_kind::arbitrary, wanted}, wanted};
    }
    const scalar_spec scalar =
        reading("--scalar", *scalar_, "write " + names_of(offered_), [&] { return read_scalar(*scalar_, offered_); });
    if (digits && *digits > scalar.digits) {
        throw input_error("--digits", *digits_, fmt::format("is more than the {} of {}", scalar.digits, scalar.name()),
                          fmt::format("ask for fewer or for --scalar mpfr:{}", *digits));
    }
    return {scalar, digits.value_or(scalar.digits)};
}

output_options::output_options(std::string usual, const std::vector<std::string>& more) : format_(std::move(usual)) {
    formats_.insert(formats_.end(), more.begin(), more.end());
}

std::string output_options::offered() const {
    std::string names = formats_.front();
    for (std::size_t i = 1; i < formats_.size(); ++i) {
        names += (i + 1 < formats_.size() ? ", " : " or ") + formats_[i];
    }
    return names;
}

void output_options::add_to(CLI::App& command, columns_option columns) {
    command.add_option("--format", format_, offered())->type_name("FORMAT")->capture_default_str();
    if (columns == columns_option::own && formats_.size() == output_options().formats_.size()) {
        command.add_option("--columns", columns_, "print only these columns, in this order: NAME,NAME,...")
            ->type_name("NAMES");
    }
    command.add_option("--out", out_, "write to this file instead of stdout")->type_name("FILE");
}

void output_options::check() const {
    if (std::find(formats_.begin(), formats_.end(), format_) == formats_.end()) {
        throw input_error("--format", format_, "is not a format", "write " + offered());
    }
    if (out_) {
        require_output_place("--out", *out_);
    }
}

table with_named_columns(const table& data, const std::string& names) {
    std::vector<std::size_t> places;
    std::string all;
    for (const column& each : data.columns()) {
        all += (all.empty() ? "" : ", ") + each.name;
    }
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        auto found = std::find_if(data.columns().begin(), data.columns().end(),
                                  [&](const column& each) { return each.name == name; });
        if (found == data.columns().end()) {
            found = std::find_if(data.columns().begin(), data.columns().end(),
                                 [&](const column& each) { return ode::name_before_renaming(each.name) == name; });
        }
        if (found == data.columns().end()) {
            throw input_error("--columns", name, "is not a column of this table", "choose from " + all);
        }
        places.push_back(static_cast<std::size_t>(found - data.columns().begin()));
    }
    if (places.empty()) {
        throw input_error("--columns", names, "names no column", "choose from " + all);
    }
    return data.with_columns(places);
}

std::string in_format(const std::string& format, const table& data) {
    return format == "csv"     ? to_csv(data)
           : format == "json"  ? to_json(data)
           : format == "latex" ? to_latex(data)
                               : to_text(data);
}

void output_options::write(const table& data, const std::optional<std::string>& text) const {
    write_content(columns_                    ? in_format(format_, with_named_columns(data, *columns_))
                  : text && format_ == "text" ? *text
                                              : in_format(format_, data));
}

void output_options::write_content(const std::string& content) const {
    if (!out_) {
        write_to_stdout(content);
        return;
    }
    try {
        write_whole_file(*out_, content);
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", *out_, fmt::format("cannot be written ({})", problem.what()),
                          "choose a file in a folder that you may write in");
    }
}

output_folder::output_folder(const std::string& option, std::string path) : path_(std::move(path)) {
    namespace fs = std::filesystem;
    if (path_.empty()) {
        throw input_error(option, path_, "is not a directory", "name one");
    }
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path at = fs::absolute(path_); !fs::exists(at, error) && at.has_relative_path(); at = at.parent_path()) {
        missing.push_back(at);
    }
    std::string reason;
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& at : missing) {
        if (fs::create_directory(at, error)) {
            made_.push_back(at.string());
        } else if (error) {
            reason = " (" + error.message() + ")";
            break;
        }
    }
    if (!reason.empty() || !fs::is_directory(path_, error) || ::access(path_.c_str(), W_OK) != 0) {
        take_away();
        throw input_error(option, path_, "cannot be written" + reason, "choose a folder that you may write in");
    }
}

output_folder::~output_folder() {
    if (!kept_) {
        take_away();
    }
}

void output_folder::take_away() {
    for (; !made_.empty(); made_.pop_back()) {
        std::error_code not_empty;
        std::filesystem::remove(made_.back(), not_empty);
    }
}

}  // namespace libration
