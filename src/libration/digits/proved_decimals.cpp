#include "libration/digits/proved_decimals.hpp"

#include <optional>
#include <string>

#include "libration/scalar/proved_digits.hpp"

namespace libration {

std::vector<proved_decimal> proved_decimals(long digits, const std::function<std::vector<ball>()>& compute,
                                            const std::function<std::vector<bool>()>& vanishing) {
    const growing_digits runs = proving(digits);
    std::optional<std::vector<bool>> zero;
    const auto attempt = [&](const precision_run& run) -> std::optional<std::vector<proved_decimal>> {
        const std::vector<ball> values = compute();
        std::vector<proved_decimal> printed;
        printed.reserve(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!zero && vanishing && run.more > runs.first && contains_zero(values[i])) {
                zero = vanishing();
            }
            const bool vanishes = zero && i < zero->size() && (*zero)[i];
            auto decimal = vanishes ? proved_decimal{"0", "0"} : to_proved_decimal(values[i], digits);
            if (!decimal || !has_a_digit(*decimal)) {
                return std::nullopt;
            }
            printed.push_back(*std::move(decimal));
        }
        return printed;
    };
    return with_growing_precision(runs, "the proof of " + std::to_string(digits) + " digits", attempt);
}

proved_decimal proved_value(long digits, const std::function<ball()>& compute) {
    return proved_decimals(digits, [&] { return std::vector<ball>{compute()}; }).front();
}

}  // namespace libration
