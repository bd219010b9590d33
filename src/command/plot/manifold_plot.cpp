#include "plot/manifold_plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "text/input_error.hpp"
#include "text/table.hpp"

namespace libration {

namespace {

constexpr int drawn_digits = 9;
constexpr int most_arrows = 8;               // on a branch
constexpr double distance_of_arrows = 0.35;  // in units of the larger side of the figure

cell drawn_cell(double x) { return number_cell(fmt::format("{:.{}g}", x, drawn_digits)); }

std::size_t place_of_axis(const ode::equilibrium_manifolds& of, const std::string& name) {
    const auto found = std::ranges::find(of.names, name);
    if (found == of.names.end()) {
        throw input_error("--plot", name, "is not an unknown or a lower derivative",
                          fmt::format("write two of {}", fmt::join(of.names, ", ")));
    }
    return static_cast<std::size_t>(found - of.names.begin());
}

}  // namespace

figure_content manifold_plot(const ode::equilibrium_manifolds& of, const std::string& x, const std::string& y,
                             const std::string& problem) {
    const std::size_t i = place_of_axis(of, x);
    const std::size_t j = place_of_axis(of, y);
    double x_low = of.equilibrium[i], x_high = x_low, y_low = of.equilibrium[j], y_high = y_low;
    for (const auto& branch : of.branches) {
        for (const auto& state : branch.states) {
            x_low = std::min(x_low, state[i]);
            x_high = std::max(x_high, state[i]);
            y_low = std::min(y_low, state[j]);
            y_high = std::max(y_high, state[j]);
        }
    }
    const double width = std::max(x_high - x_low, 1e-300);
    const double height = std::max(y_high - y_low, 1e-300);
    table curves({{"manifold", ""}, {"x", ""}, {"y", ""}});
    table arrows({{"manifold", ""}, {"x", ""}, {"y", ""}, {"dx", ""}, {"dy", ""}});
    for (const auto& branch : of.branches) {
        const std::string name = branch.stable ? "stable" : "unstable";
        double since = distance_of_arrows / 2;
        int drawn = 0;
        for (std::size_t k = 0; k < branch.states.size(); ++k) {
            const auto& state = branch.states[k];
            curves.add_row({name, drawn_cell(state[i]), drawn_cell(state[j])});
            if (k == 0) {
                continue;
            }
            const auto& before = branch.states[k - 1];
            const double dx = state[i] - before[i];
            const double dy = state[j] - before[j];
            since += std::hypot(dx / width, dy / height);
            if (since > distance_of_arrows && drawn < most_arrows) {
                arrows.add_row({name, drawn_cell(before[i]), drawn_cell(before[j]), drawn_cell(dx), drawn_cell(dy)});
                since = 0;
                ++drawn;
            }
        }
        if (!branch.states.empty()) {  // a gap
            curves.add_row({name, drawn_cell(branch.states.back()[i]), cell()});
        }
    }
    table point(std::vector<column>{{"x", ""}, {"y", ""}});
    point.add_row({drawn_cell(of.equilibrium[i]), drawn_cell(of.equilibrium[j])});
    std::string below;
    const auto add = [&](const char* name, std::size_t dimension) {
        if (dimension > 1) {
            below += fmt::format("{}some solutions on the {} manifold, of dimension {}", below.empty() ? "" : "; ",
                                 name, dimension);
        }
    };
    add("stable", of.stable_dimension);
    add("unstable", of.unstable_dimension);
    if (of.names.size() > 2) {
        below += below.empty() ? "projection" : "; projection";
    }
    return {"manifold_plot",
            {{"curves.csv", to_csv(curves)}, {"arrows.csv", to_csv(arrows)}, {"equilibrium.csv", to_csv(point)}},
            {{"problem", heading_in_figure(problem)},
             {"x_name", name_in_figure(x)},
             {"y_label", name_in_figure(y)},
             {"below", below}}};
}

}  // namespace libration
