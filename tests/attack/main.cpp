// libration-attack motions [VALUES [SEED [THREADS]]]     random motions of the pendulum and elliptic functions
// libration-attack print [VALUES]                        values of motions as CSV, for by_integers.py
// libration-attack statements [QUESTIONS [SEED [THREADS [KIND]]]]  statements about problems with closed forms
// libration-attack statement INDEX [SEED]                one of these questions, and its statements
// Exits with status 1 if a proved statement is false; 2 for wrong usage.
#include <fmt/core.h>

#include <cstdlib>
#include <string>

#include "attack/motions.hpp"
#include "attack/statements.hpp"

int main(int count, char** words) {
    using namespace libration::attack;
    const auto number = [&](int i, long otherwise) { return count > i ? std::atol(words[i]) : otherwise; };
    const auto seed = [&](int i) { return static_cast<unsigned long>(number(i, 1)); };
    const std::string what = count > 1 ? words[1] : "";
    if (what == "motions") {
        return attack_motions(number(2, 1'000'000), seed(3), number(4, 0));
    }
    if (what == "print") {
        return print_motions(number(2, 1000));
    }
    if (what == "statements") {
        return attack_statements(number(2, 2000), seed(3), number(4, 0), count > 5 ? words[5] : "");
    }
    if (what == "statement" && count > 2) {
        return attack_statement(number(2, 0), seed(3));
    }
    fmt::print(stderr, "libration-attack motions | print | statements | statement INDEX, see tests/attack/main.cpp\n");
    return 2;
}
