#include "equation/derivative_options.hpp"

#include <utility>

#include "libration/scalar/list_items.hpp"
#include "text/input_error.hpp"

namespace libration {

void derivative_options::add_to(CLI::App& command) {
    command
        .add_option("--derivatives", numbers_,
                    "with --problem: also the derivatives of every value by these initial values and parameters, each "
                    "digit proved: \"x(0), x'(0), r\"")
        ->type_name("LIST");
}

std::vector<std::string> derivative_options::numbers() const {
    std::vector<std::string> numbers;
    if (!numbers_) {
        return numbers;
    }
    for (const std::string_view each : list_items(*numbers_)) {
        std::string number(each);
        std::erase(number, ' ');
        if (number.empty()) {
            throw input_error("--derivatives", *numbers_, "has an empty item",
                              "write initial values and parameters of the problem, as \"x(0), r\"");
        }
        numbers.push_back(std::move(number));
    }
    return numbers;
}

}  // namespace libration
