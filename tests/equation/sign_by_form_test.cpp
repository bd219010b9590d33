// Signs that the form of an expression shows, and those that it does not show.
#include "../../src/libration/equation/sign_by_form.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/equation/text/parse.hpp"

namespace equation_sign_by_form_test {

using namespace libration::ode;

namespace {

int sign_of_text(const std::string& text) {
    return sign_by_form(parse("x' = " + text + "; x(0) = 1").equations.front().right);
}

}  // namespace

TEST_CASE("signs that a form shows", "[equation]") {
    for (const std::string positive :
         {"3", "exp(-t/5)", "1 + x^2", "2 + sin(t)", "3 - sin(t) - 3/2*cos(x)", "1/x^2", "exp(t)/cosh(x)",
          "x^2 + exp(x)", "(2 + x^4)^(1/3)", "sqrt(1 + t^2)", "(-1 - x^2)*(-2)", "(3 + tanh(t))^(-3)"}) {
        INFO(positive);
        CHECK(sign_of_text(positive) == 1);
        CHECK(sign_of_text("-(" + positive + ")") == -1);
    }
}

// 0 somewhere, negative somewhere, or undecided by the form.
TEST_CASE("signs that a form does not show", "[equation]") {
    for (const std::string open :
         {"x", "x^2", "x^3", "sqrt(x)", "1 + sin(t)", "1 - cos(t)", "2 - sin(t) - cos(x)", "3/2 - sin(t) - cos(x)",
          "exp(x) - 1", "1 + x", "1 - x^2", "x^2*exp(t)", "exp(t)*sin(t)", "(1 + x)^(1/2)", "(1 - x^2)^3", "1/x",
          "1 + log(x)", "abs(x) - 1"}) {
        INFO(open);
        CHECK(sign_of_text(open) == 0);
        CHECK(sign_of_text("-(" + open + ")") == 0);
    }
}

}  // namespace equation_sign_by_form_test
