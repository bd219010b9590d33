#include "table/elliptic_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "libration/number/written_number.hpp"
#include "problem/motion_cells.hpp"
#include "table/elliptic_request.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

constexpr std::array<const char*, 6> modulus_columns{"k", "m", "m1", "alpha", "alpha_deg", "q"};
constexpr std::array<const char*, 7> argument_columns{"u", "u_re", "u_im", "phi", "x", "z", "n"};

}  // namespace

std::vector<known_column> elliptic_columns::known() {
    std::vector<known_column> columns;
    columns.reserve(argument_columns.size() + modulus_columns.size());
    for (const char* const name : argument_columns) {
        columns.push_back({name});
    }
    for (const char* const name : {"k", "m", "m1", "q"}) {
        columns.push_back({name});
    }
    columns.push_back({"alpha", {"alpha", "α", "modularangle"}});
    columns.push_back({"alpha_deg",
                       {"alphadeg", "alpha(deg)", "alpha[deg]", "alpha(degrees)", "alpha[degrees]", "α(deg)", "α[deg]",
                        "alpha(°)", "alpha[°]", "α(°)", "α[°]", "modularangle(deg)", "modularangle[deg]"}});
    return columns;
}

bool elliptic_columns::has_modulus(const column_names& names) {
    return std::any_of(modulus_columns.begin(), modulus_columns.end(),
                       [&](const char* name) { return names.find(name).has_value(); });
}

elliptic_columns::elliptic_columns(const column_names& names, const named_function& function)
    : names_(&names), function_(&function) {
    find_modulus();
    find_argument();
    characteristic_ = function.has_characteristic ? names.find("n") : std::nullopt;
    if (!function.argument.empty() && !argument_ && !function.may_be_complete) {
        throw input_error(fmt::format("{} has no column '{}', the argument of {}: its columns are {}: {}", names.file(),
                                      function.argument, function.name, names.listed(), mapping_remedy));
    }
    if (function.has_characteristic && !characteristic_) {
        throw input_error(fmt::format("{} has no column 'n', the characteristic of {}: its columns are {}: {}",
                                      names.file(), function.name, names.listed(), mapping_remedy));
    }
}

void elliptic_columns::find_modulus() {
    for (const std::string name : modulus_columns) {
        const auto at = names_->find(name);
        if (at && (name == "q") != function_->of_nome) {
            continue;
        }
        if (at && !modulus_.empty()) {
            throw input_error(fmt::format("{} has both '{}' and '{}': leave one out by --columns {}=-", names_->file(),
                                          modulus_, name, names_->own(*at)));
        }
        modulus_ = at ? name : modulus_;
        modulus_at_ = at.value_or(modulus_at_);
    }
    if (modulus_.empty()) {
        throw input_error(fmt::format("{} has no modulus: its columns are {}: {}, as {}", names_->file(),
                                      names_->listed(), mapping_remedy,
                                      function_->of_nome ? "'q'" : "'k', 'm', 'm1' or 'alpha'"));
    }
}

void elliptic_columns::find_argument() {
    if (function_->argument.empty()) {
        return;
    }
    argument_ = names_->find(function_->argument);
    if (!takes_complex(*function_)) {
        return;
    }
    const auto real = names_->find("u_re");
    imaginary_ = names_->find("u_im");
    if (real.has_value() != imaginary_.has_value()) {
        throw input_error(fmt::format("{} has '{}' alone of u_re and u_im: its columns are {}: {}", names_->file(),
                                      names_->own(real ? *real : *imaginary_), names_->listed(), mapping_remedy));
    }
    if (real && argument_) {
        throw input_error(fmt::format("{} has both '{}' and '{}': leave one out by --columns {}=-", names_->file(),
                                      names_->own(*argument_), names_->own(*real), names_->own(*argument_)));
    }
    argument_ = real ? real : argument_;
}

complex_argument elliptic_columns::argument_in(const std::vector<std::string>& cells, bool as_double) const {
    if (imaginary_) {
        complex_argument at{number_in(cells, *argument_, as_double), number_in(cells, *imaginary_, as_double)};
        at.real.text = complex_argument_text(at.real.text, at.imaginary->text);
        return at;
    }
    const std::string typed(trimmed(cells[*argument_]));
    if (!is_complex_text(typed)) {
        return {number_in(cells, *argument_, as_double), std::nullopt};
    }
    return reading_cell({typed, names_->own(*argument_)}, [&](const std::string& text) {
        if (!takes_complex(*function_)) {
            throw error(error_kind::argument, std::string(function_->argument), text,
                        fmt::format("is complex, which {} does not take", function_->name));
        }
        auto [real, imaginary] = read_complex(text);
        real = as_double ? nearest_double(real) : real;
        real.text = text;
        return complex_argument{std::move(real), as_double ? nearest_double(*imaginary) : *std::move(imaginary)};
    });
}

exact elliptic_columns::number_in(const std::vector<std::string>& cells, std::size_t at, bool as_double) const {
    return reading_cell({trimmed(cells[at]), names_->own(at)}, [&](const std::string& text) {
        if (text.empty()) {
            throw error(error_kind::argument, error_subject::number, text, "is empty");
        }
        const exact number = read_typed(text);
        return as_double ? nearest_double(number) : number;
    });
}

// The number of alpha_deg is one of degrees.
exact elliptic_columns::modulus_in(const std::vector<std::string>& cells, bool as_double) const {
    exact typed = number_in(cells, modulus_at_, as_double);
    const bool angle = modulus_ == "alpha" && typed.is_angle();
    const bool degrees = modulus_ == "alpha_deg";
    if (degrees ? !typed.is_fraction() : !typed.is_number() && !angle) {
        throw error(error_kind::argument, names_->own(modulus_at_), typed.text,
                    degrees ? "is not a number of degrees" : "has a unit");
    }
    typed.measure = degrees ? unit::degree : typed.measure;
    return typed;
}

elliptic_point elliptic_columns::read(const std::vector<std::string>& cells, bool as_doubles) const {
    const exact typed = modulus_in(cells, as_doubles);
    const auto parameter = reading_cell({typed.text, names_->own(modulus_at_)},
                                        [&](const std::string&) { return parameter_of(modulus_, typed); });
    elliptic_point at{std::nullopt, parameter, std::nullopt};
    if (argument_) {
        auto [real, imaginary] = argument_in(cells, as_doubles);
        at.argument = std::move(real);
        at.imaginary = std::move(imaginary);
        reading_cell({at.argument->text, names_->own(*argument_)}, [&](const std::string&) {
            require_argument(std::string(function_->argument), *at.argument);
            return at.imaginary ? require_argument("u", *at.imaginary) : void(), 0;
        });
    }
    if (characteristic_) {
        at.characteristic = number_in(cells, *characteristic_, as_doubles);
    }
    return at;
}

}  // namespace libration
