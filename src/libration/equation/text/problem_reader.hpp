// The statements of a problem as its equations, initial values, parameters and events.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "condition.hpp"
#include "event_statement.hpp"
#include "libration/equation/equation_system.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

/// The statements of one problem, read in two passes: names first.
class problem_reader {
public:
    explicit problem_reader(std::string_view text);
    /// Statements that change a system.
    problem_reader(std::string_view text, const equation_system& of);

    /// The names of unknowns that are columns of tables, with those that the system has instead.
    const std::map<std::string, std::string>& renamed() const { return renamed_; }

    /// The whole problem. Throws error like parse().
    equation_system read();
    const std::vector<statement>& statements() const { return all_; }

    /// left - right of an equation.
    expression difference(const statement& words) const;
    /// Reads an equation, an initial value, a history or a parameter into the result.
    void read_equality(const statement& words);
    equation_system& result() { return result_; }

    /// The parameters that occur only in their definition.
    std::vector<std::string> unused() const;

private:
    void rename_columns(const std::vector<statement>& all);
    expression formula(const statement& words, std::size_t first, std::size_t last) const;
    // Of an equation.
    expression side(const statement& words, std::size_t first, std::size_t last);
    expression constant(const statement& words, std::size_t first, std::size_t last, const std::string& what) const;
    void read_start(const statement& words, std::size_t equals);
    // Throws error for x = ... where another equation gives x' or a higher derivative, as where a program would assign x.
    void refuse_second_equation() const;
    // Whether the value from this token on is an interval.
    bool read_set(const statement& words, std::size_t begin, const std::string& name);
    // x(t <= 0) = 1 + t
    void read_history(const statement& words, std::size_t equals);
    // Of a definition.
    bool depends_on_solution(const statement& words) const;
    void read_parameter(const statement& words);
    void read_exact_solution(const statement& words);
    // Of `when`; a = b as a == b.
    condition condition_of(const event_statement& event);
    void read_event(const event_statement& words);

    std::vector<statement> all_;
    std::vector<event_statement> events_;
    known_names names_;
    equation_system result_;
    std::map<std::string, std::string> renamed_;
    std::map<std::string, const statement*> defined_;  // parameters
};

}  // namespace libration::ode
