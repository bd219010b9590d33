#include "formula.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace libration::import {

LIBSBML_CPP_NAMESPACE_USE

namespace {

class writer {
public:
    writer(const name_meaning& names, const std::string& time, occurrence at)
        : names_(names), time_(time), at_(std::move(at)) {}

    formula of(const ASTNode& e) const {
        switch (static_cast<int>(e.getType())) {
            case AST_INTEGER: return number(std::to_string(e.getInteger()), e.getInteger() < 0);
            case AST_REAL: return number(decimal_of(e.getReal()), e.getReal() < 0);
            case AST_REAL_E:
                return number(decimal_of(e.getMantissa()) + "e" + std::to_string(e.getExponent()), e.getMantissa() < 0);
            case AST_RATIONAL: return {fmt::format("{}/{}", e.getNumerator(), e.getDenominator()), binding::product};
            case AST_NAME: return names_(e.getName(), at_);
            case AST_NAME_TIME: return time();
            case AST_FUNCTION_DELAY: return delayed(e);
            case AST_NAME_AVOGADRO: return number("6.02214179e23", false);
            case AST_CONSTANT_PI: return {"pi"};
            case AST_CONSTANT_E: return {"exp(1)"};
            case AST_PLUS: return joined(e, " + ", binding::sum, "0");
            case AST_TIMES: return joined(e, "*", binding::product, "1");
            case AST_MINUS: return difference(e);
            case AST_DIVIDE:
                return {child(e, 0).within(binding::product) + "/" + child(e, 1).within(binding::power),
                        binding::product};
            case AST_POWER:
            case AST_FUNCTION_POWER: return power(child(e, 0), child(e, 1));
            case AST_FUNCTION_ROOT: return root(e);
            case AST_FUNCTION_LOG: return logarithm(e);
            case AST_FUNCTION_PIECEWISE: return piecewise(e, 0);
            default: return function(e);
        }
    }

private:
    static formula number(const std::string& text, bool negative) {
        return {text, negative ? binding::sum : binding::name};
    }

    static const ASTNode& operand(const ASTNode& e, unsigned int i) {
        const ASTNode* const found = e.getChild(i);
        if (found == nullptr) {
            throw unsupported("a formula without an operand");
        }
        return *found;
    }

    formula child(const ASTNode& e, unsigned int i) const { return of(operand(e, i)); }

    formula time() const {
        if (at_.in_delay) {
            throw unsupported("a delay that varies");
        }
        return at_.delay.empty() ? formula{time_} : formula{time_ + " - " + at_.delay, binding::sum};
    }

    // A delay within a delay is the sum of both.
    formula delayed(const ASTNode& e) const {
        const formula by = writer(names_, time_, {.in_delay = true}).of(operand(e, 1));
        const std::string sum = at_.delay.empty() ? by.within(binding::product)
                                                  : "(" + at_.delay + " + " + by.within(binding::product) + ")";
        return writer(names_, time_, {.delay = sum}).of(operand(e, 0));
    }

    formula joined(const ASTNode& e, const std::string& sign, binding binds, const std::string& none) const {
        if (e.getNumChildren() < 2) {
            return e.getNumChildren() == 0 ? formula{none} : child(e, 0);
        }
        std::string text = child(e, 0).within(binds);
        for (unsigned int i = 1; i < e.getNumChildren(); ++i) {
            const formula next = child(e, i);
            // a + (b + c) and a + (-b) keep their parentheses.
            text += sign + next.within(binds == binding::sum ? binding::product : binding::power);
        }
        return {text, binds};
    }

    formula difference(const ASTNode& e) const {
        if (e.getNumChildren() == 1) {
            return {"-" + child(e, 0).within(binding::product), binding::sum};
        }
        return {child(e, 0).within(binding::sum) + " - " + child(e, 1).within(binding::product), binding::sum};
    }

    static formula power(const formula& base, const formula& exponent) {
        return {base.within(binding::name) + "^" + exponent.within(binding::name), binding::power};
    }

    formula root(const ASTNode& e) const {
        const formula degree = e.getNumChildren() == 1 ? formula{"2"} : child(e, 0);
        const formula argument = child(e, e.getNumChildren() - 1);
        return degree.text == "2" ? formula{"sqrt(" + argument.text + ")"}
                                  : power(argument, {"1/" + degree.within(binding::name), binding::product});
    }

    formula logarithm(const ASTNode& e) const {
        const formula base = e.getNumChildren() == 1 ? formula{"10"} : child(e, 0);
        const std::string argument = "log(" + child(e, e.getNumChildren() - 1).text + ")";
        return {argument + "/log(" + base.text + ")", binding::product};
    }

    // value, condition, value, condition, ..., otherwise.
    formula piecewise(const ASTNode& e, unsigned int first) const {
        if (first + 1 == e.getNumChildren()) {
            return child(e, first);
        }
        if (first >= e.getNumChildren()) {
            return {"0"};  // a comment of the problem states it
        }
        return {fmt::format("if({}, {}, {})", condition(operand(e, first + 1)).text, child(e, first).text,
                            piecewise(e, first + 2).text)};
    }

public:
    // Comparisons bind like names, so that `not` has parentheses around them.
    formula condition(const ASTNode& e) const {
        switch (static_cast<int>(e.getType())) {
            case AST_LOGICAL_AND: return combined(e, " and ", "true");
            case AST_LOGICAL_OR: return combined(e, " or ", "false");
            case AST_LOGICAL_XOR: return exclusive(e);
            case AST_LOGICAL_NOT: return {"not (" + condition(operand(e, 0)).text + ")", binding::product};
            case AST_CONSTANT_TRUE: return {"true"};
            case AST_CONSTANT_FALSE: return {"false"};
            case AST_RELATIONAL_GT: return compared(e, " > ");
            case AST_RELATIONAL_GEQ: return compared(e, " >= ");
            case AST_RELATIONAL_LT: return compared(e, " < ");
            case AST_RELATIONAL_LEQ: return compared(e, " <= ");
            case AST_RELATIONAL_EQ: return compared(e, " == ");
            case AST_RELATIONAL_NEQ: return compared(e, " != ");
            default: break;
        }
        throw unsupported("a condition other than comparisons of numbers combined by and, or, xor and not");
    }

private:
    formula combined(const ASTNode& e, const std::string& word, const std::string& none) const {
        if (e.getNumChildren() < 2) {
            return e.getNumChildren() == 0 ? formula{none} : condition(operand(e, 0));
        }
        std::string text;
        for (unsigned int i = 0; i < e.getNumChildren(); ++i) {
            text += (i == 0 ? "" : word) + condition(operand(e, i)).within(binding::product);
        }
        return {text, binding::sum};
    }

    // An odd number of the operands holds.
    formula exclusive(const ASTNode& e) const {
        formula all{"false"};
        for (unsigned int i = 0; i < e.getNumChildren(); ++i) {
            const std::string next = condition(operand(e, i)).text;
            all = i == 0 ? formula{next, binding::sum}
                         : formula{fmt::format("(({0}) and not ({1})) or (({1}) and not ({0}))", all.text, next),
                                   binding::sum};
        }
        return all;
    }

    // a < b, and a < b < c.
    formula compared(const ASTNode& e, const std::string& sign) const {
        if (e.getNumChildren() < 2) {
            throw unsupported("a comparison without two sides");
        }
        std::string text = child(e, 0).text;
        for (unsigned int i = 1; i < e.getNumChildren(); ++i) {
            text += sign + child(e, i).text;
        }
        return {text};
    }

    formula function(const ASTNode& e) const {
        static const std::map<int, std::string> names{
            {AST_FUNCTION_EXP, "exp"},       {AST_FUNCTION_LN, "log"},        {AST_FUNCTION_SIN, "sin"},
            {AST_FUNCTION_COS, "cos"},       {AST_FUNCTION_TAN, "tan"},       {AST_FUNCTION_ARCSIN, "asin"},
            {AST_FUNCTION_ARCCOS, "acos"},   {AST_FUNCTION_ARCTAN, "atan"},   {AST_FUNCTION_SINH, "sinh"},
            {AST_FUNCTION_COSH, "cosh"},     {AST_FUNCTION_TANH, "tanh"},     {AST_FUNCTION_ARCSINH, "asinh"},
            {AST_FUNCTION_ARCCOSH, "acosh"}, {AST_FUNCTION_ARCTANH, "atanh"}, {AST_FUNCTION_ABS, "abs"},
            {AST_FUNCTION_CEILING, "ceil"},  {AST_FUNCTION_ARCSEC, "asec"},   {AST_FUNCTION_ARCCSC, "acsc"},
            {AST_FUNCTION_ARCCOTH, "acoth"}, {AST_FUNCTION_ARCSECH, "asech"}, {AST_FUNCTION_ARCCSCH, "acsch"},
            {AST_FUNCTION_REM, "fmod"},      {AST_FUNCTION_FLOOR, "floor"},   {AST_FUNCTION_MIN, "min"},
            {AST_FUNCTION_MAX, "max"}};
        static const std::map<int, std::string> reciprocals{{AST_FUNCTION_SEC, "cos"},   {AST_FUNCTION_CSC, "sin"},
                                                            {AST_FUNCTION_COT, "tan"},   {AST_FUNCTION_SECH, "cosh"},
                                                            {AST_FUNCTION_CSCH, "sinh"}, {AST_FUNCTION_COTH, "tanh"}};
        if (const auto found = names.find(e.getType()); found != names.end()) {
            return call(found->second, e, 0);
        }
        if (const auto found = reciprocals.find(e.getType()); found != reciprocals.end()) {
            return {"1/" + call(found->second, e, 0).text, binding::product};
        }
        throw unsupported(fmt::format("the function {}", e.getName() != nullptr ? e.getName() : "of a formula"));
    }

    // f(a), f(a, b), and f(a, f(b, c)).
    formula call(const std::string& name, const ASTNode& e, unsigned int first) const {
        std::string text = name + "(" + child(e, first).text;
        if (first + 2 < e.getNumChildren()) {
            text += ", " + call(name, e, first + 1).text;
        } else if (first + 1 < e.getNumChildren()) {
            text += ", " + child(e, first + 1).text;
        }
        return {text + ")"};
    }

    const name_meaning& names_;
    const std::string& time_;
    occurrence at_;
};

}  // namespace

formula formula_of(const ASTNode& node, const name_meaning& names, const std::string& time, const occurrence& at) {
    return writer(names, time, at).of(node);
}

std::string condition_of(const ASTNode& node, const name_meaning& names, const std::string& time) {
    return writer(names, time, {}).condition(node).text;
}

std::string decimal_of(double value) {
    if (!std::isfinite(value)) {
        throw unsupported("a number that is not finite");
    }
    return fmt::format("{}", value);
}

}  // namespace libration::import
