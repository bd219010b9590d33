#include <algorithm>
#include <iterator>

#include "delay_solution.hpp"
#include "hybrid_solution.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/axis.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/problem/radius_answer.hpp"
#include "libration/problem/solution.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/list_items.hpp"
#include "taylor_solution.hpp"

namespace libration {

const std::string& answer::at(std::size_t row, const std::string& name) const {
    const auto column = std::ranges::find(names, name);
    if (column == names.end()) {
        throw error(error_kind::argument, "quantity", name, "is not a column of this answer");
    }
    const auto place = static_cast<std::size_t>(column - names.begin());
    const bool beyond = row >= rows.size();
    const auto without_number = [](const answer_value& value) {
        return value.text.empty() && value.kind != value_kind::text;
    };
    if (missing && (beyond || rows[row].empty() || without_number(rows[row][place]))) {
        throw error(*missing);
    }
    if (beyond) {
        throw error(error_kind::argument, "row", std::to_string(row), "is beyond the last row of the answer");
    }
    return rows[row][place].text;
}

std::string derivative_name(const std::string& quantity, const std::string& variable, const std::string& number) {
    return "d" + quantity + "(" + variable + ")/d" + number;
}

std::vector<std::string> solution::times_in_decimals(const std::vector<exact>& times, long digits) const {
    std::vector<std::string> decimals;
    std::ranges::transform(times, std::back_inserter(decimals),
                           [&](const exact& time) { return decimal_of(time, digits); });
    return decimals;
}

answer solution::states(const std::string& times, const request& how) const {
    std::vector<exact> list;
    for (const std::string_view each : list_items(times)) {
        std::string item(each);
        std::erase(item, ' ');
        list.push_back(given_time("time", item));
    }
    return states(list, how);
}

answer solution::events(const std::string& condition_text, long count, const request& how) const {
    return events(ode::event_request{.g = condition(condition_text), .count = count}, how, {});
}

answer solution::series(long order, const std::string& about, const request& how) const {
    return series({.order = order, .about = about}, how);
}

answer solution::radius(const series_request& of, const request& how) const {
    if (how.scalar.kind == scalar_kind::proved) {
        return proved_radius(of, how);
    }
    const long digits = how.printed_digits() + convergence::radius_guard_digits;
    return radius_answer(coefficient_lists(of, how.scalar), exact_radius(of.about, digits), how,
                         [&](const complex_number<mpfr>& place) { return is_single_valued(of, place, how); });
}

answer solution::radius(const std::string& about, const request& how) const {
    return radius({.order = usual_order_of_radius, .about = about}, how);
}

proved_law solution::law(const law_question& /*asked*/, const request& /*how*/) const {
    throw error(error_kind::undecided, error_subject::problem, "",
                "is piecewise or has delays, and no law of its coefficients is proved");
}

std::unique_ptr<solution> solve(const problem& given, const settings& by) {
    if (!given.equations().is_smooth()) {
        return std::make_unique<hybrid_solution>(given.equations());
    }
    if (given.equations().has_delays()) {
        return std::make_unique<delay_solution>(given.equations());
    }
    if (!by.general) {
        for (const known_facts& facts : all_known_facts()) {
            if (auto known = facts.closed_form ? facts.closed_form(given.equations()) : nullptr) {
                return known;
            }
        }
    }
    return std::make_unique<taylor_solution>(given.equations());
}

}  // namespace libration
