// Invalid input as a one-line message: the option, the value, the reason and the fix. The exit code is 2.
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
        : std::runtime_error(option + " '" + value + "' " + reason + ": " + remedy), value_(value), remedy_(remedy) {}
    /// For what no single option is wrong about.
    explicit input_error(const std::string& line) : std::runtime_error(line) {}

    /// What was typed, and what to write in its place; empty where no single option is wrong.
    const std::string& value() const { return value_; }
    const std::string& remedy() const { return remedy_; }

    /// The line with a hint before the remedy: "--method 'sereis' is not a method (did you mean series?): write ...".
    std::string line_with(const std::string& hint) const {
        std::string line = what();
        if (!remedy_.empty()) {
            line.insert(line.size() - remedy_.size() - 2, hint);
        }
        return line;
    }

private:
    std::string value_;
    std::string remedy_;
};

/// read(value), with the library's error converted to an input_error of the option, which is the user's name of the
/// quantity. An error that a sign cannot be decided at any precision is not invalid input, and is passed on.
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
