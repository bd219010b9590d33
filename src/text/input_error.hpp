// Bad input as one line: the option, the value, what is wrong with it, and the remedy. Ends in exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration {

class input_error : public std::runtime_error {
public:
    /// "--energy abc is not a number: write 1.71, 171/100 or 1e-3".
    input_error(const std::string& option, const std::string& value, const std::string& reason,
                const std::string& remedy)
        : std::runtime_error(option + " '" + value + "' " + reason + ": " + remedy) {}
    /// For what no single option is wrong about.
    explicit input_error(const std::string& line) : std::runtime_error(line) {}
};

/// read(value), its std::invalid_argument, std::domain_error or libration::error turned into an input_error of the
/// option; what no precision decides is no bad input and stays a libration::error, which then names the option.
template <class Read>
auto reading(const std::string& option, const std::string& value, const std::string& remedy, const Read& read) {
    try {
        return read();
    } catch (const std::invalid_argument& problem) {
        throw input_error(option, value, problem.what(), remedy);
    } catch (const std::domain_error& problem) {
        throw input_error(option, value, problem.what(), remedy);
    } catch (const error& problem) {
        if (problem.kind() == error_kind::undecided) {
            throw error(error_kind::undecided, option, value, problem.reason());
        }
        throw input_error(option, value, problem.reason(), remedy);
    }
}

}  // namespace libration
