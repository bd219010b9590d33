#include "differentiated_numbers.hpp"

#include <algorithm>

#include "libration/ode/parse.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_unknown_number(const std::string& name) {
    refuse_derivative(name, "is neither a parameter nor an initial value of the problem: choose one that is");
}

// x'(0) as the name x' of the value that starts there.
std::string name_of_start_at(const equation_system& given, const number& point, const std::string& typed) {
    try {
        const start read = parse_value_at_time(given, typed);
        if ((read.point.constant() - point).sign() == 0) {
            return primed(read.of.name(), read.of.derivative());
        }
    } catch (const error&) {
        refuse_unknown_number(typed);
    }
    refuse_unknown_number(typed);
}

}  // namespace

void refuse_derivative(const std::string& name, const std::string& reason) {
    throw error(error_kind::argument, "derivatives", name, reason);
}

differentiated_numbers::differentiated_numbers(const equation_system& given, const std::vector<std::string>& state,
                                               const number& point, const std::vector<std::string>& numbers) {
    for (auto each = numbers.begin(); each != numbers.end(); ++each) {
        if (std::find(numbers.begin(), each, *each) != each) {
            refuse_derivative(*each, "is given twice: give it once");
        }
        if (each->find('(') == std::string::npos) {
            columns.push_back({false, parameters.size()});
            parameters.push_back(*each);
            continue;
        }
        const auto found = std::ranges::find(state, name_of_start_at(given, point, *each));
        if (found == state.end()) {
            refuse_unknown_number(*each);
        }
        columns.push_back({true, static_cast<std::size_t>(found - state.begin())});
    }
}

}  // namespace libration::ode
