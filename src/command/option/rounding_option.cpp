#include "option/rounding_option.hpp"

#include "libration/number/grid.hpp"
#include "text/input_error.hpp"

namespace libration {

void rounding_option::add_to(CLI::App& command, const std::string& otherwise) {
    command.add_flag("--exact", exact, "take the decimals of --coefficients as exact numbers");
    command
        .add_option(
            "--rounded", rounded,
            "take the decimals of --coefficients as rounded to D significant digits (default: " + otherwise + ")")
        ->type_name("D");
}

std::optional<long> rounding_option::digits() const {
    if (exact) {
        return 0;
    }
    return !rounded
               ? std::nullopt
               : std::optional<long>(reading("--rounded", *rounded, "write the number of correct digits, 1 to 1000",
                                             [&] { return read_count(*rounded, 1000); }));
}

}  // namespace libration
