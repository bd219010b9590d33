// Formulas of SBML (MathML) in the notation of libration.
#pragma once

#include <sbml/math/ASTNode.h>

#include <functional>
#include <stdexcept>
#include <string>

LIBSBML_CPP_NAMESPACE_USE

namespace libration::import {

/// What a model contains that a problem cannot express.
class unsupported : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// How tightly the outermost operation of a text binds.
enum class binding { sum, product, power, name };

struct formula {
    std::string text;
    binding binds = binding::name;

    /// In parentheses if it binds less tightly.
    std::string within(binding context) const { return binds < context ? "(" + text + ")" : text; }
};

/// Where an identifier occurs in a formula.
struct occurrence {
    /// By how much its value is delayed, as a text; empty if it is not.
    std::string delay = {};
    /// Whether it is part of such a delay, which must be constant.
    bool in_delay = false;
};

/// The text of an identifier: a name, a number or an expression.
using name_meaning = std::function<formula(const std::string& id, const occurrence& at)>;

/// The formula, where time is `time`, and everything delayed as `at` states. Throws unsupported for what it cannot
/// express.
formula formula_of(const ASTNode& node, const name_meaning& names, const std::string& time = "t",
                   const occurrence& at = {});

/// A relation between two numbers: left - right crosses 0 upwards where it becomes true.
struct relation {
    const ASTNode* left;
    const ASTNode* right;
    bool or_equal;
};

/// The relation of a trigger, with its sides exchanged for < and <=. Throws unsupported for any other condition.
relation relation_of(const ASTNode& condition);

/// The shortest decimal of a double, which is how the file gives it.
std::string decimal_of(double value);

}  // namespace libration::import
