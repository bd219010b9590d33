#include "plot/solution_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/decimal.hpp"
#include "problem/problem_trajectory.hpp"
#include "text/members.hpp"

namespace libration {

namespace {

// A row solution,quantity,x,y for each value of these quantities; the first place is that of x.
void add_points(table& points, std::size_t solution, const table& states, const std::vector<std::size_t>& places) {
    for (std::size_t q = 1; q < places.size(); ++q) {
        for (const auto& row : states.rows()) {
            points.add_row({static_cast<long>(solution), static_cast<long>(q), row[places.front()], row[places[q]]});
        }
    }
}

table no_points() { return table({{"solution", ""}, {"quantity", ""}, {"x", ""}, {"y", ""}}); }

}  // namespace

figure_content solution_plot(const std::vector<drawn_solution>& family, const plot_axes& axes,
                             const std::optional<drawn_marks>& marks, const std::string& problem) {
    table points = no_points();
    table marked = no_points();
    std::vector<std::string> solutions;
    for (std::size_t i = 0; i < family.size(); ++i) {
        add_points(points, i + 1, family[i].states, axes.places_in(family[i].states));
        solutions.push_back(family[i].name);
    }
    if (marks) {
        add_points(marked, 1, marks->states, axes.places_in(marks->states));
    }
    const table& first = family.front().states;
    const auto places = axes.places_in(first);
    const bool over_time = first.columns()[places.front()].name == "time";
    std::vector<std::string> quantities;
    for (const std::size_t place : places) {
        const std::string& name = first.columns()[place].name;
        quantities.push_back(name == "time" ? "time t" : name_in_figure(name));
    }
    const std::string x_name = quantities.front();
    quantities.erase(quantities.begin());
    return {"solution_plot",
            {{"points.csv", to_csv(points)}, {"marks.csv", to_csv(marked)}},
            {{"problem", heading_in_figure(problem)},
             {"x_name", x_name},
             {"quantities", words_for_script(quantities)},
             {"solutions", words_for_script(solutions)},
             {"marks_name", marks ? marks->name : ""},
             {"over_time", over_time ? "1" : "0"}}};
}

namespace {

std::string name_of_member(const family_member& of) {
    std::string text;
    for (const auto& [name, value] : of.values) {
        text += (text.empty() ? "" : ", ") + name_in_figure(name) + " = " + text_in_figure(value);
    }
    return text;
}

}  // namespace

figure_content family_plot(const std::vector<family_member>& family, const std::vector<partial_table>& parts,
                           const plot_axes& axes, const std::string& problem) {
    const bool named = parts.size() == family.size();
    std::vector<drawn_solution> drawn;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        drawn.push_back({named ? name_of_member(family[i]) : fmt::format("motion {}", i + 1), parts[i].rows});
    }
    return solution_plot(drawn, axes, std::nullopt, problem);
}

figure_content event_plot(const problem_options& problem, const table& events, const std::string& condition,
                          const plot_axes& axes) {
    constexpr int steps = 400;
    const precision_scope scope(figure_digits);
    const auto names = members_of(events.columns(), &column::name);
    const auto time = static_cast<std::size_t>(std::ranges::find(names, "time") - names.begin());
    const mpfr first = ode::constant_value<mpfr>::of(problem.choose_first_branch().point());
    const std::string& at = events.rows().back()[time].text();
    const mpfr last(at.empty() ? "0" : at);  // only a time that is not distinguished from 0 has no decimal
    std::vector<exact> times;
    for (int i = 0; i <= steps; ++i) {
        times.push_back(read_exact(to_decimal(mpfr(first + (last - first) * i / steps), figure_digits)));
    }
    const auto curve = problem_trajectory(*problem.general_solution(), times,
                                          {{scalar_kind::arbitrary, figure_digits}, figure_digits});
    return solution_plot({{"", curve.rows}}, axes, drawn_marks{text_in_figure(condition), events}, problem.heading());
}

}  // namespace libration
