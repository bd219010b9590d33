#include "libration/function/function_kind.hpp"

#include "libration/function/list.hpp"

namespace libration {

std::string_view name_of(function_kind f) {
    return function::with_function(f, [](auto of) { return std::string_view(of.name); });
}

bool has_order(function_kind f) {
    return function::with_function(f, [](auto of) { return function::ordered<decltype(of)>; });
}

std::optional<function_kind> function_named(std::string_view name) {
    for (std::size_t i = 0; i < function_kinds; ++i) {
        const auto f = static_cast<function_kind>(i);
        const std::string_view alias = function::with_function(f, [](auto of) -> std::string_view {
            if constexpr (requires { of.alias; }) {
                return of.alias;
            } else {
                return of.name;
            }
        });
        if (name == name_of(f) || name == alias) {
            return f;
        }
    }
    return std::nullopt;
}

std::string function_names() {
    std::string all;
    for (std::size_t i = 0; i < function_kinds; ++i) {
        all += (all.empty() ? "" : " ") + std::string(name_of(static_cast<function_kind>(i)));
    }
    return all;
}

}  // namespace libration
