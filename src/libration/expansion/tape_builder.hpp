// Compiles expressions to the steps of a tape.
#pragma once

#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "../equation/start_values.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/expansion/tape.hpp"

namespace libration::ode {

class tape_builder {
public:
    /// About any point if `at_start` is null.
    tape_builder(const explicit_system& of, start_values* at_start);

    /// The finished tape: the right-hand sides, or the scaled ones of a singular initial point, and the observed
    /// expressions.
    tape build(const std::vector<expression>& watched);

private:
    int step_of(const expression& e);
    operand_pair operands(const expression& e) const;
    bool is_delay(const expression& e) const;
    int made(const expression& e);
    int sum_of(const expression& e);
    int product_of(const expression& e);
    int power_of(const expression& e);
    int whole_power(int base, const integer& n);
    int function_of(const expression& e);
    template <class F>
    int own_series(const expression& e);
    template <class F>
    int primitive_of(const expression& e);
    int delayed_by(int of, const rational& exponent);
    int scaled_by(int of, const number& factor);
    int product(int a, int b);
    int quotient(int a, int b);
    int root_of(int a, const expression& argument);
    int slope_of(int a);
    int constant(const number& value);
    int constant_index(const number& value);
    int state(const expression& e);
    int companions(int of, int count);
    /// The existing step equal to this one, or a new one.
    int shared(tape_step step);
    void set_lag(tape_step& step) const;
    std::optional<number> centre_of(function_kind f, const rational& order, const expression& argument);

    const explicit_system& system_;
    std::map<std::string, std::size_t> places_;
    start_values* at_start_;
    tape result_;
    node_values<int, same_expression> done_;
    std::map<std::tuple<int, int, int, int, int, int, int, int>, int> known_;
};

/// Finds the largest stride of the nonzero coefficients about an initial point, and sets the residues.
class tape_symmetry {
public:
    tape_symmetry(const tape& of) : tape_(of) {}

    /// Computes the residues of the steps and of the unknowns modulo the stride; false if they contradict each other.
    bool holds(int stride);
    const std::vector<int>& steps() const { return steps_; }
    const std::vector<int>& unknowns() const { return unknowns_; }

private:
    int residue_of(const tape_step& step, int stride) const;

    const tape& tape_;
    std::vector<int> steps_, unknowns_;
};

}  // namespace libration::ode
