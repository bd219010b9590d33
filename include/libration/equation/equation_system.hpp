// Differential equations as written: equations, initial values, parameters, and known facts to check a solution with.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// A position in a text; line 0 for objects built in C++.
struct place {
    int line = 0;
    int column = 0;
};

/// The text, truncated after 60 characters of UTF-8, for quotation in messages.
std::string beginning_of(const std::string& text);

/// Throws error: problem 'what' (truncated), at line 1, column 2 reason.
[[noreturn]] void refuse(const std::string& what, const place& at, const std::string& reason);

/// left = right.
struct equation {
    expression left;
    expression right;
    place at = {};
};

/// The initial value of an unknown, or of a derivative of it, at a point; both are constant and may contain parameters.
struct start {
    expression of;
    expression point;
    expression value;
    place at = {};
};

/// A named constant; a name for an expression in the variable and the unknowns; or a closed form of an unknown.
struct definition {
    std::string name;
    expression value;
    place at = {};
};

/// A parameter without a value, at its first occurrence.
struct open_parameter {
    std::string name;
    place at = {};
};

/// Every number of an interval, ends included, as the value of a parameter or an initial value.
struct number_set {
    std::string name;  ///< of the parameter; x'(0) for an initial value, which is then the parameter of this name
    expression lower;  ///< constant, as is the other end; both may contain parameters
    expression upper;
    place at = {};
};

/// The direction in which a function crosses 0 as t increases.
enum class crossing { any, up, down };

/// The value of an unknown or of a lower derivative after an event, in terms of the values before it.
struct reset {
    expression of;
    expression value;
    place at = {};
};

/// What happens whenever a function of the solution crosses 0 in a direction, or a condition begins to hold: resets, all
/// from the values before the event, or the end of the solution.
struct state_event {
    expression condition = {};  ///< left - right of `when left = right`
    crossing way = crossing::any;
    /// Instead of these, 1 where a condition on step functions holds, else 0, in their parameters alone: the event is
    /// where it changes from 0 to 1. So are `when x > 1 and y < 2` and `when mod(t, 12) < 1`.
    std::optional<expression> holds = {};
    std::vector<reset> resets = {};
    bool stop = false;
    std::string text = {};  ///< as written
    place at = {};
};

enum class step_kind { sign, floor };

/// sign(argument), with sign(0) = 0, or floor(argument/divisor) in the equations, in which a parameter of this name
/// represents it, and two further ones the indicators of a sign. The argument may contain earlier step functions.
struct step_function {
    std::string parameter = {};
    step_kind kind = step_kind::sign;
    expression argument = {};
    number divisor = number(rational(1));  ///< positive
    std::string text = {};                 ///< as written: abs(x), if(x > 0, a, b)
    place at = {};
};

/// The parameters that represent [argument > 0] and [argument >= 0], 1 if that holds and else 0, of the sign with this
/// parameter.
inline std::string name_of_positive(const std::string& parameter) { return parameter + " > 0"; }
inline std::string name_of_nonnegative(const std::string& parameter) { return parameter + " >= 0"; }
inline bool is_indicator(const std::string& parameter) {
    return parameter.ends_with(" > 0") || parameter.ends_with(" >= 0");
}
/// All parameters that represent a step function, where it has this value.
std::vector<definition> parameters_of(const step_function& step, const number& value);
/// The same parameters, each as an expression of its name: with them parameter_values leaves step functions unchanged.
std::map<std::string, expression> kept_steps(const std::vector<step_function>& steps);

/// An unknown or a lower derivative at an earlier time, x(t - delay), in the equations, in which a parameter of this
/// name represents it.
struct delayed_value {
    std::string parameter;
    expression of;
    expression delay;  ///< constant, may contain parameters
    place at = {};
};

/// An unknown at all times up to the initial point, x(t <= point) = value, in the variable and parameters. It gives the
/// initial values of the unknown and its lower derivatives too.
struct history {
    std::string unknown;
    expression point;
    expression value;
    place at = {};
};

/// Differential equations in any sequence and of any order, from text (parse.hpp) or C++:
///     const auto f = ode::unknown("f");
///     ode::equation_system blasius;
///     blasius.add(derivative(f, 3) + f * derivative(f, 2) / 2);
///     blasius.begin(f, 0).begin(derivative(f), 0).begin(derivative(f, 2), 1);
/// Nothing is checked here: explicit_system does that.
struct equation_system {
    std::string variable = "t";
    std::vector<equation> equations;
    std::vector<start> starts;
    std::vector<definition> parameters;
    std::vector<equation> invariants;  ///< constant along a solution: the left-hand side; the right-hand side is 0
    std::vector<definition> exact;     ///< the closed form of the unknown of this name
    std::vector<open_parameter> open;  ///< of a text: parameters that it leaves open, to be set before solving
    std::vector<number_set> sets;      ///< parameters and initial values that are every number of an interval
    std::vector<state_event> events;   ///< at which the solution jumps or ends
    std::vector<step_function> steps;  ///< the step functions of piecewise right-hand sides
    std::vector<delayed_value> delays;
    std::vector<history> histories;
    std::vector<definition> shown;  ///< further columns, where with_column() does not make unknowns of them

    /// left = right.
    equation_system& add(const expression& left, const expression& right = 0);
    /// of(point) = value.
    equation_system& begin(const expression& of, const expression& value, const expression& point = 0);
    /// of(t - delay) for the equations, of an unknown or a lower derivative.
    expression delayed(const expression& of, const expression& delay, const place& at = {});
    /// of(t) = value for t <= point, or another such value.
    equation_system& before(const expression& of, const expression& value, const expression& point = 0);
    /// Adds a parameter, or changes its value.
    equation_system& set(const std::string& name, const expression& value);
    /// The same with the exact number of a text: "0.1" is 1/10; also "sqrt(2)", "pi/3". Throws error as read_exact().
    template <class Text>
    requires std::is_convertible_v<Text, std::string_view> equation_system& set(const std::string& name,
                                                                                const Text& value) {
        return set_to_text(name, value);
    }
    /// of(point) = every number from lower to upper.
    equation_system& begin_between(const expression& of, const expression& lower, const expression& upper,
                                   const expression& point = 0);
    /// Adds a parameter that is every number from lower to upper, or changes its value.
    equation_system& set_between(const std::string& name, const expression& lower, const expression& upper);

    /// The unknowns in the order of their equations if each left-hand side is an unknown or a derivative of one; else in
    /// the order of their first occurrence, those of the left-hand side of each equation first.
    std::vector<std::string> unknowns() const;
    /// The parameter, or null.
    const definition* parameter_of(const std::string& name) const;
    /// The set of this name, or null.
    const number_set* set_of(const std::string& name) const;
    /// Whether the text leaves the value of this parameter open.
    bool is_open(const std::string& name) const;
    /// Whether it is a parameter with a number, a set or an open value.
    bool has_parameter(const std::string& name) const;
    /// The highest derivative of each unknown in the equations, by its name: one pass for all of them.
    std::map<std::string, int> highest_derivatives() const;
    /// The highest derivative of an unknown in the equations; 1 if it occurs without one, 0 if it does not occur.
    int order_of(const std::string& unknown) const;
    /// Whether an unknown occurs in the equations, but no derivative of it.
    bool is_algebraic(const std::string& unknown) const;
    /// Whether it has neither events nor step functions.
    bool is_smooth() const { return events.empty() && steps.empty(); }
    /// Whether it contains earlier values of its unknowns.
    bool has_delays() const { return !delays.empty() || !histories.empty(); }
    /// Whether it is a system of ordinary differential equations with one smooth right-hand side.
    bool is_ordinary() const { return is_smooth() && !has_delays(); }

private:
    equation_system& set_to_text(const std::string& name, std::string_view value);
};

/// The name of an initial value, x'(0), by which a set refers to it.
std::string name_of_start(const expression& of, const expression& point);

/// Throws error if a parameter or an initial value is a set instead of a number.
void require_numbers(const equation_system& system);

/// The values of the parameters of a system, each computed once; they may depend on each other at any depth.
class parameter_values {
public:
    /// The system must outlive this object. Parameters named in `open` are replaced by these expressions.
    explicit parameter_values(const equation_system& system, std::map<std::string, expression> open = {});

    /// The expression with every parameter replaced by its exact value. Throws error for a parameter without a value
    /// and for parameters that depend on each other cyclically.
    expression in(const expression& e);
    /// The same for an expression that is a number. Throws error for a parameter that depends on the variable or an
    /// unknown.
    number number_of(const expression& e);

private:
    struct known_definition {
        const definition* of;
        bool open = false;
    };
    struct opened_definition {
        const definition* of;
        std::vector<std::string> needs;
        std::size_t next = 0;
    };

    void find(const std::string& name);
    void open(const std::string& name);
    expression substituted(const expression& e) const;

    const equation_system& system_;
    std::map<std::string, known_definition> definitions_;
    std::map<std::string, expression> values_;
    std::vector<opened_definition> open_;
};

/// parameter_values::in() for a single expression.
expression with_values(const expression& e, const equation_system& system);
/// parameter_values::number_of() for a single expression.
number number_with_values(const expression& e, const equation_system& system);

/// An unknown or a lower derivative at a time, which is constant and may contain parameters.
struct value_at_time {
    expression of;
    expression time;
};

/// The equations differences[i] = 0 in parameters and in leaves, each of which represents a value at a time:
///     conditions_at_times periodic;
///     periodic.add(periodic.at(ode::unknown("y"), 0) - periodic.at(ode::unknown("y"), ode::parameter("T")));
class conditions_at_times {
public:
    /// The leaf that represents a value at a time; the same for the same value.
    expression at(const expression& of, const expression& time);
    /// difference = 0, in parameters and leaves of at().
    conditions_at_times& add(const expression& difference);

    const std::vector<expression>& differences() const { return differences_; }
    /// The values that occur, in the order of leaves().
    const std::vector<value_at_time>& values() const { return values_; }
    /// leaves()[k] represents values()[k].
    const std::vector<expression>& leaves() const { return leaves_; }

private:
    std::vector<expression> differences_;
    std::vector<value_at_time> values_;
    std::vector<expression> leaves_;
};

}  // namespace libration::ode
