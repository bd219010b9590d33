// Initial value problems that other libraries solve too, as text; as functions they are in peers/slopes.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace libration::bench {

/// A problem with the state x1, x1', x2, x2', ... of its unknowns in this order.
struct initial_value_problem {
    std::string name;  ///< the name used by the peers
    std::string equations;
    std::vector<std::string> unknowns;
    int order;  ///< of all of them
    std::vector<std::string> start;
    std::string end;

    /// The equations with their initial values, as text.
    std::string text() const {
        std::string all = equations;
        for (std::size_t i = 0; i < start.size(); ++i) {
            const auto q = static_cast<std::size_t>(order);
            all += "; " + unknowns[i / q] + std::string(i % q, '\'') + "(0) = " + start[i];
        }
        return all;
    }
};

/// Bodies 1 to 4 of mass 1 in a plane: x_i'' = sum (x_j - x_i)/r_ij^3, each distance written once.
inline std::string four_body_equations() {
    const auto cube = [](int i, int j) {
        const std::string a = std::to_string(i);
        const std::string b = std::to_string(j);
        return "((x" + b + " - x" + a + ")^2 + (y" + b + " - y" + a + ")^2)^(3/2)";
    };
    std::string all;
    for (int i = 1; i <= 4; ++i) {
        for (const std::string axis : {"x", "y"}) {
            all += (all.empty() ? "" : "; ") + axis + std::to_string(i) + "'' = 0";
            for (int j = 1; j <= 4; ++j) {
                if (j != i) {
                    const int low = i < j ? i : j;
                    const int high = i < j ? j : i;
                    all += (i < j ? " + (" : " - (") + axis + std::to_string(high) + " - " + axis +
                           std::to_string(low) + ")/" + cube(low, high);
                }
            }
        }
    }
    return all;
}

inline std::vector<initial_value_problem> problems_with_peers() {
    return {
        {"lorenz", "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z", {"x", "y", "z"}, 1, {"1", "0", "0"}, "2"},
        {"kepler",
         "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)",
         {"x", "y"},
         2,
         {"0.4", "0", "0", "2"},
         "10"},
        {"pendulum", "x'' = -sin(x)", {"x"}, 2, {"2.5", "-0.3"}, "20"},
        {"four_body",
         four_body_equations(),
         {"x1", "y1", "x2", "y2", "x3", "y3", "x4", "y4"},
         2,
         {"1", "0", "0", "0.9", "0", "-1", "1.1", "0", "-0.9", "0", "0", "-0.8", "0", "1.1", "-1", "0"},
         "3"}};
}

}  // namespace libration::bench
