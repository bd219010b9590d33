#include "libration/verification/double_decimals.hpp"

#include <algorithm>

#include "libration/number/written_number.hpp"
#include "libration/verification/compare_rules.hpp"

namespace libration {

namespace {

constexpr double largest_chance = 0.01;

}  // namespace

void double_decimals::add(const std::string& text) {
    if (is_not_finite(text) || !(all_ || exact_)) {
        return;
    }
    const written_number written = read_written(text);
    rational nearest;
    try {
        nearest = nearest_double(written.value);
    } catch (const error&) {  // beyond the largest double
        all_ = false;
        exact_ = false;
        return;
    }
    exact_ = exact_ && nearest == written.value;
    all_ = all_ && !is_hexadecimal(text) && abs(rational(nearest - written.value)) * 2 <= written.last_place;
    if (written.value != 0) {
        const rational share = written.last_place / unit_in_last_place(nearest);
        chance_ *= std::min(1.0, share.convert_to<double>());
    }
}

bool double_decimals::recognised() const { return all_ && chance_ < largest_chance; }

}  // namespace libration
