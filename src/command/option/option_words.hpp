// The arguments of a command by option: parsed by the code that interprets them, and repeated in the provenance of a
// table.
#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace libration {

/// An option as it is added to a command.
struct offered_option {
    const char* names;
    const char* type_name;
    const char* help;
};

/// Arguments by option, in the order of the command line. An object whose address was passed to a parser must not be
/// moved.
class option_words {
public:
    option_words() = default;
    option_words(std::initializer_list<std::pair<std::string, std::string>> words);

    /// Adds an option such as "--times,--time" to a command; its words are then found under the first name.
    void offer(CLI::App& command, const std::string& names, const std::string& type_name, const std::string& help);
    /// The same for several.
    void offer(CLI::App& command, std::initializer_list<offered_option> options);
    void say(const std::string& option, const std::string& words);
    /// The argument of an option; std::nullopt if it was not given.
    const std::optional<std::string>& operator[](const std::string& option) const;
    /// " --gaps=-1e-3 --times 0,T/8".
    std::string text() const;

private:
    std::optional<std::string>& place_of(const std::string& option);

    std::deque<std::pair<std::string, std::optional<std::string>>> all_;
};

}  // namespace libration
