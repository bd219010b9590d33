// Formulas of SBML (MathML) in the notation of libration.
#pragma once

#include <sbml/math/ASTNode.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

LIBSBML_CPP_NAMESPACE_USE

namespace libration::import {

/// What a model contains that a problem cannot express.
class unsupported : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a model does not contain although a problem needs it, with the remedy.
class incomplete : public std::runtime_error {
public:
    incomplete(const std::string& what, std::string remedy) : std::runtime_error(what), remedy_(std::move(remedy)) {}
    const std::string& remedy() const { return remedy_; }

private:
    std::string remedy_;
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

/// A condition, with `and`, `or` and `not`, as in if(...) and `when`. Throws unsupported for any other one.
std::string condition_of(const ASTNode& node, const name_meaning& names, const std::string& time = "t");

/// The shortest decimal of a double, which is how the file gives it.
std::string decimal_of(double value);

}  // namespace libration::import
