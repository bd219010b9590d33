#include "libration/problem/law_answer.hpp"

namespace libration {

answer coefficients_of_law(const proved_law& law, const std::vector<long>& orders, long digits, bool* complete) {
    answer result{.names = {"n", "value", "by"}, .rows = {}, .rigour = "proved"};
    for (const long n : orders) {
        const auto [value, by, all] = law.coefficient(n, digits);
        if (complete != nullptr && !all) {
            *complete = false;
        }
        result.rows.push_back({whole_value(n),
                               value.decimal ? answer_value{value.decimal->text, value.decimal->uncertainty}
                                             : answer_value{"", value.bound},
                               text_value(by)});
    }
    return result;
}

law_report law_of(const ode::explicit_system& system, const law_question& asked, const std::vector<long>& orders,
                  const request& how) {
    const long digits = how.printed_digits();
    const proved_law law(system, asked, how);
    law_report report{.singularities = law.singularities(digits), .coefficients = {}};
    report.coefficients = coefficients_of_law(law, orders, digits, &report.complete);
    return report;
}

}  // namespace libration
