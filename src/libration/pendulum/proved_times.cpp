#include "libration/pendulum/proved_times.hpp"

#include <algorithm>
#include <iterator>

#include "libration/digits/proved_decimals.hpp"
#include "libration/pendulum/proved_motion.hpp"

namespace libration::pendulum {

std::vector<std::string> proved_times(const motion& m, const std::vector<exact>& times, long digits) {
    const auto proved = proved_decimals(digits, [&] {
        const ball period = proved_motion(m).effective_period() * quarters_per_period(m.regime());
        std::vector<ball> values;
        values.reserve(times.size());
        std::transform(times.begin(), times.end(), std::back_inserter(values), [&](const exact& time) {
            return period * from_rational<ball>(time.periods()) + from_exact<ball>(time.without_periods());
        });
        return values;
    });
    std::vector<std::string> decimals;
    decimals.reserve(proved.size());
    std::transform(proved.begin(), proved.end(), std::back_inserter(decimals),
                   [](const proved_decimal& each) { return each.text; });
    return decimals;
}

}  // namespace libration::pendulum
