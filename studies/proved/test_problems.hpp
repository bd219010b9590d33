// The test problems for which reference values are published: problems of the catalogue, some with other parameters,
// and the last of their times.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "../shared/catalogue_system.hpp"
#include "../shared/data_table.hpp"

namespace libration::studies::proved {

/// The times are end k/8, k = 1 .. 8, after the initial time; for stiff problems end/factor^k, k = 10 .. 0.
inline constexpr int times_of_each = 8;
inline constexpr int times_of_stiff = 11;
/// More are not computed for these.
inline constexpr long most_stiff_digits = 30;

struct test_problem {
    std::string name;
    std::string end;
    std::string catalogue;             ///< its name there
    std::vector<std::string> changes;  ///< of parameters and initial values
    int seconds;                       ///< approximate, on one core
    int factor;                        ///< of a stiff problem, of which condition numbers are not computed; else 0

    ode::equation_system equations() const { return catalogue_system(catalogue, changes); }

    bool is_stiff() const { return factor > 0; }
    long digits_of(long asked) const { return is_stiff() ? std::min(asked, most_stiff_digits) : asked; }

    /// Those of the set; of a stiff problem so many, in ascending order.
    std::vector<ode::number> times(int stiff = times_of_stiff) const {
        const ode::number start = ode::explicit_system(equations()).point();
        const ode::number whole = ode::parse_constant(end).constant();
        std::vector<ode::number> all;
        for (int k = 1; !is_stiff() && k <= times_of_each; ++k) {
            all.push_back(start + whole * ode::number(rational(k, times_of_each)));
        }
        rational part = 1;
        for (int k = 0; is_stiff() && k < stiff; ++k) {
            all.insert(all.begin(), start + whole * ode::number(part));
            part /= factor;
        }
        return all;
    }
};

/// By name: test_problems.csv.
inline const std::vector<test_problem>& test_problems() {
    static const std::vector<test_problem> result = [] {
        std::vector<test_problem> all;
        for (const data_row& row : data_table("test_problems")) {
            all.push_back({row.at("name"), row.at("end"), row.at("catalogue"), parts_of_cell(row.at("changes")),
                           std::stoi(row.at("seconds")), std::stoi(row.at("factor"))});
        }
        return all;
    }();
    return result;
}

}  // namespace libration::studies::proved
