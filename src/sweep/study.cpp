#include "sweep/study.hpp"

#include "libration/scalar/error.hpp"

#include <stdexcept>

#include "run/grid.hpp"

namespace libration {

sweep_period_rule read_period_rule(std::string_view text) {
    constexpr int largest_order = 100'000;
    if (text == "agm") {
        return {{period_method::agm, 0}, std::string(text)};
    }
    const auto colon = text.find(':');
    const std::string_view method = text.substr(0, colon);
    if (colon == std::string_view::npos || (method != "series" && method != "resummed")) {
        throw error(error_kind::argument, "rule", "",
                    "has '" + std::string(text) + "', which is not agm, series:N or resummed:N");
    }
    const auto way = method == "series" ? period_method::series : period_method::resummed;
    return {{way, read_count(text.substr(colon + 1), largest_order)}, std::string(text)};
}

}  // namespace libration
