#include "option/option_words.hpp"

#include <algorithm>

namespace libration {

option_words::option_words(std::initializer_list<std::pair<std::string, std::string>> words) {
    for (const auto& [option, value] : words) {
        say(option, value);
    }
}

std::optional<std::string>& option_words::place_of(const std::string& option) {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const auto& each) { return each.first == option; });
    return found != all_.end() ? found->second : all_.emplace_back(option, std::nullopt).second;
}

void option_words::offer(CLI::App& command, const std::string& names, const std::string& type_name,
                         const std::string& help) {
    command.add_option(names, place_of(names.substr(0, names.find(','))), help)->type_name(type_name);
}

void option_words::offer(CLI::App& command, std::initializer_list<offered_option> options) {
    for (const auto& [names, type_name, help] : options) {
        offer(command, names, type_name, help);
    }
}

void option_words::say(const std::string& option, const std::string& words) { place_of(option) = words; }

const std::optional<std::string>& option_words::operator[](const std::string& option) const {
    static const std::optional<std::string> nothing;
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const auto& each) { return each.first == option; });
    return found != all_.end() ? found->second : nothing;
}

std::string option_words::text() const {
    std::string text;
    for (const auto& [option, words] : all_) {
        if (words) {
            text += " " + option + (words->starts_with("-") ? "=" : " ") + *words;
        }
    }
    return text;
}

}  // namespace libration
