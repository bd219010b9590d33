// Systems with closed forms: single components, several independent ones, mixed, bent and scaled.
#pragma once

#include <string>
#include <vector>

#include "attack/component.hpp"

namespace libration::attack {

/// A system as it is typed, and the values of its columns.
struct solved_problem {
    std::string text;
    std::vector<std::string> columns;  ///< the unknowns, in order
    std::vector<function> values;      ///< of the time since the initial time, in units of `unit`
    std::vector<component> parts;      ///< the components from which it is made
    rational origin = 0;               ///< the initial time
    std::string unit = "";             ///< appended to times: "" or "e1000"; origin is 0 then
    double backward = 0;               ///< where its solution is analytic, as in component
    double forward = 0;
    std::vector<std::size_t> part_of;  ///< of each column that is one component alone (scaled or not)
    std::vector<std::size_t> origins() const { return part_of; }

    /// A time since the initial time as it is typed. `since` is a decimal if there is a unit.
    std::string typed_time(const rational& since) const;
};

/// A decimal with at most `digits` digits after the point as a fraction.
rational decimal_fraction(const integer& whole, long digits);

solved_problem alone(const component& u, const std::string& name = "y");
/// u, v in equations that do not influence each other.
solved_problem beside(const std::vector<component>& all);
/// X = a u + b v, Y = c u + d v with integers a .. d.
solved_problem mixed(const component& u, const component& v, choices& next);
/// X = u, Y = v + k u^2.
solved_problem bent(const component& u, const component& v, long k);
/// y = c u, c = 1e+-1000, 2^-349 and the like.
solved_problem scaled(const component& u, choices& next);
/// Times of 1e+-1000.
solved_problem stretched(const component& u, choices& next);

/// Any of these.
solved_problem any_problem(choices& next);

/// A time since the initial time, a decimal, at which the solution exists.
rational reached_time(const solved_problem& problem, choices& next);

}  // namespace libration::attack
