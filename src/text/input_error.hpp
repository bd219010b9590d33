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

/// read(value), the library's error turned into an input_error of the option, which is the name that the user knows the
/// quantity by. What no precision decides is nothing that was typed wrong, and passes.
template <class Read>
auto reading(const std::string& option, const std::string& value, const std::string& remedy, const Read& read) {
    try {
        return read();
    } catch (const error& problem) {
        if (problem.kind() == error_kind::undecided) {
            throw error(error_kind::undecided, option, value,
                        "leaves open " + problem.subject() + ", which " + problem.reason());
        }
        throw input_error(option, value, problem.reason(), remedy);
    }
}

}  // namespace libration
