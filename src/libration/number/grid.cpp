#include "libration/number/grid.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "libration/scalar/decimal.hpp"
#include "libration/scalar/enclose.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/list_items.hpp"
#include "libration/scalar/whole_number.hpp"

namespace libration {

namespace {

// An item's complaint names the item, unless it is the whole text.
[[noreturn]] void refuse(std::string_view item, std::string_view whole, const std::string& reason) {
    if (item == whole) {
        throw error(error_kind::argument, "list", "", reason);
    }
    throw error(error_kind::argument, "list", "",
                item.empty() ? "has an empty item" : "has the item '" + std::string(item) + "', which " + reason);
}

// A multiple of a unit as text that read_exact takes: 3/4 of T is 3T/4. Zero has no unit, as where it is typed.
exact in_unit(const rational& coefficient, unit measure) {
    if (coefficient == 0) {
        return {coefficient, unit::one, "0"};
    }
    exact result{coefficient, measure, ""};
    const std::string_view name = measure == unit::pi       ? "pi"
                                  : measure == unit::degree ? "deg"
                                  : measure == unit::period ? "T"
                                                            : "";
    const auto decimal = to_finite_decimal(coefficient);
    if (decimal) {
        result.text = *decimal + std::string(name);
    } else {
        const rational positive = abs(coefficient);
        result.text = (coefficient < 0 ? "-" : "") + numerator(positive).str() + std::string(name) + "/" +
                      denominator(positive).str();
    }
    return result;
}

// A range one end of which is a formula: its values are formulas of the ends.
std::vector<exact> formula_range(const exact& first, const exact& last, long count) {
    std::vector<exact> values;
    for (long i = 0; i < count; ++i) {
        const rational part = count == 1 ? rational(0) : rational(i, count - 1);
        const exact between = part == 0 ? first : part == 1 ? last : first + exactly(part) * (last - first);
        const bool is_end = part == 0 || part == 1;
        values.push_back(is_end || between.measure == unit::expression ? between
                                                                       : in_unit(between.coefficient, between.measure));
    }
    return values;
}

std::vector<exact> even_range(const exact& first, const exact& last, long count) {
    if (first.measure == unit::expression || last.measure == unit::expression) {
        return formula_range(first, last, count);
    }
    const unit measure = first.is_zero() ? last.measure : first.measure;
    if (!last.is_zero() && !first.is_zero() && first.measure != last.measure) {
        throw error(error_kind::argument, "list", "", "mixes units");
    }
    std::vector<exact> values;
    for (long i = 0; i < count; ++i) {
        const rational part = count == 1 ? rational(0) : rational(i, count - 1);
        values.push_back(in_unit(rational(first.coefficient + (last.coefficient - first.coefficient) * part), measure));
    }
    return values;
}

// The last less the first over the first, exactly.
exact relative_width(const exact& first, const exact& last) { return last / first - exactly(1); }

std::vector<exact> log_range(const exact& first, const exact& last, long count) {
    if (!first.is_number() || !last.is_number() || sign_of_exact(first) * sign_of_exact(last) <= 0) {
        throw error(error_kind::argument, "list", "",
                    "has ends that are not nonzero numbers of one sign, as a logarithmic range needs");
    }
    const precision_scope rough(20);
    const mpfr relative_step = abs(from_exact<mpfr>(relative_width(first, last))) / count;
    const long step_digits = std::max(0L, decimal_digits(-binary_exponent(relative_step))) + 3;
    const long digits = std::max(6L, relative_step == 0 ? 0L : step_digits);
    const precision_scope scope(digits + 50);
    const mpfr a = from_exact<mpfr>(first);
    const mpfr b = from_exact<mpfr>(last);
    std::vector<exact> values;
    for (long i = 0; i < count; ++i) {
        if (i == 0 || i == count - 1) {
            values.push_back(i == 0 ? first : last);
            continue;
        }
        const mpfr between = a * exp(log(b / a) * i / (count - 1));
        values.push_back(read_exact(*to_finite_decimal(read_exact(to_decimal(between, digits)).coefficient)));
    }
    return values;
}

std::vector<exact> read_range(const std::vector<std::string_view>& parts) {
    if (parts.size() != 3) {
        throw error(error_kind::argument, "list", "", "is not a range FIRST:LAST:COUNT");
    }
    const bool logarithmic = parts[2].ends_with("log");
    const std::string_view digits = parts[2].substr(0, parts[2].size() - (logarithmic ? 3 : 0));
    long count = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (problem != std::errc() || end != digits.data() + digits.size() || count < 1 || count > most_grid_values) {
        throw error(error_kind::argument, "list", "",
                    "has the count '" + std::string(parts[2]) + "', which is not between 1 and " +
                        std::to_string(most_grid_values));
    }
    const exact first = read_exact(parts[0]);
    const exact last = read_exact(parts[1]);
    return logarithmic ? log_range(first, last, count) : even_range(first, last, count);
}

}  // namespace

std::vector<exact> read_grid(std::string_view text) {
    std::vector<exact> values;
    for (const std::string_view item : list_items(text)) {
        try {
            const auto parts = list_items(item, ':');
            if (parts.size() == 1) {
                values.push_back(read_exact(item));
                continue;
            }
            const auto range = read_range(parts);
            values.insert(values.end(), range.begin(), range.end());
        } catch (const error& problem) {
            if (problem.kind() == error_kind::undecided) {
                throw;
            }
            refuse(item, text, problem.reason());
        }
    }
    if (values.size() > static_cast<std::size_t>(most_grid_values)) {
        throw error(error_kind::argument, "list", "", "has more than " + std::to_string(most_grid_values) + " values");
    }
    return values;
}

int read_count(std::string_view text, int largest) {
    return static_cast<int>(read_whole_number(text, largest, "list"));
}

}  // namespace libration
