// What a peer that solves initial value problems reads from stdin, and writes to stdout, all numbers hexadecimal
// floats:
//
//   stdin    version                                   requests name and version of the library, nothing else
//   stdin    limit L                                   evaluations of the right-hand sides that a run may take
//            steps K, then K of: kind left right constant numerator denominator
//            states N, then N of: its step, the step of its slope, its start, its scale
//            times M t0, then t_1 .. t_M
//            runs R, then R of: method tolerance, relative and, times the scale of a state, absolute
//   stdout   for each run: ended|stopped|failed evaluations, then M N values, time by time, where it ended
//
// The steps are elementary operations whose operands are steps before them, as studies/proved/solver_peers.hpp writes
// them; peers/equation_code.py reads the same.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace peers {

// An elementary operation: its operands are the values of the steps `left` and `right`, and the time.
struct step {
    double (*apply)(const step& of, double left, double right, double t) = nullptr;  // nullptr: the value is given
    std::size_t left = 0;
    std::size_t right = 0;
    double constant = 0;
    double numerator = 1;
    double denominator = 1;
};
using operation = decltype(step::apply);

template <double (*f)(double)>
double function_of(const step& /*of*/, double left, double /*right*/, double /*t*/) {
    return f(left);
}

inline const std::map<std::string, operation>& operations() {
    static const std::map<std::string, operation> all{
        {"nothing", nullptr},
        {"state", nullptr},
        {"constant", [](const step& of, double, double, double) { return of.constant; }},
        {"variable", [](const step&, double, double, double t) { return t; }},
        {"sum", [](const step&, double a, double b, double) { return a + b; }},
        {"difference", [](const step&, double a, double b, double) { return a - b; }},
        {"scaled",
         [](const step& of, double a, double, double) { return a * of.constant * of.numerator / of.denominator; }},
        {"raised", [](const step& of, double a, double, double) { return a + of.constant; }},
        {"by_time", [](const step&, double a, double, double t) { return t * a; }},
        {"product", [](const step&, double a, double b, double) { return a * b; }},
        {"quotient", [](const step&, double a, double b, double) { return a / b; }},
        {"power", [](const step& of, double a, double, double) { return std::pow(a, of.constant); }},
        {"root_beside", [](const step&, double a, double, double) { return std::sqrt(1 - a * a); }},
        {"sqrt", function_of<std::sqrt>},
        {"exp", function_of<std::exp>},
        {"log", function_of<std::log>},
        {"sin", function_of<std::sin>},
        {"cos", function_of<std::cos>},
        {"tan", function_of<std::tan>},
        {"atan", function_of<std::atan>},
        {"asin", function_of<std::asin>},
        {"sinh", function_of<std::sinh>},
        {"cosh", function_of<std::cosh>},
        {"tanh", function_of<std::tanh>}};
    return all;
}

// y' = f(t, y) of an initial value problem.
class equations {
public:
    std::size_t size() const { return start.size(); }

    // f(t, y); false where the limit of evaluations is passed.
    bool slopes(double t, const double* y, double* out) {
        if (++evaluations > limit) {
            return false;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            values[state[i]] = y[i];
        }
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const step& s = steps[k];
            if (s.apply != nullptr) {
                values[k] = s.apply(s, values[s.left], values[s.right], t);
            }
        }
        for (std::size_t i = 0; i < size(); ++i) {
            out[i] = values[slope[i]];
        }
        return true;
    }

    // df/dy by rows, from differences, and df/dt.
    bool jacobian(double t, const double* y, double* by_state, double* by_time) {
        const double small = std::sqrt(2.220446049250313e-16);
        std::vector<double> at(y, y + size());
        std::vector<double> here(size());
        std::vector<double> there(size());
        if (!slopes(t, at.data(), here.data())) {
            return false;
        }
        for (std::size_t j = 0; j < size(); ++j) {
            const double h = small * (std::fabs(y[j]) > 1e-5 ? std::fabs(y[j]) : 1e-5);
            at[j] = y[j] + h;
            if (!slopes(t, at.data(), there.data())) {
                return false;
            }
            for (std::size_t i = 0; i < size(); ++i) {
                by_state[i * size() + j] = (there[i] - here[i]) / (at[j] - y[j]);
            }
            at[j] = y[j];
        }
        const double h = small * (std::fabs(t) > 1 ? std::fabs(t) : 1);
        if (!slopes(t + h, at.data(), there.data())) {
            return false;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            by_time[i] = (there[i] - here[i]) / h;
        }
        return true;
    }

    std::vector<step> steps;
    std::vector<std::size_t> state;
    std::vector<std::size_t> slope;
    std::vector<double> start;
    std::vector<double> scale;
    double begin = 0;
    std::vector<double> times;
    long limit = 0;
    long evaluations = 0;
    std::vector<double> values;
};

inline double read_number() {
    std::string word;
    std::cin >> word;
    return std::strtod(word.c_str(), nullptr);
}

inline std::size_t read_count(const char* head) {
    std::string word;
    std::size_t count = 0;
    std::cin >> word >> count;
    if (!std::cin || word != head) {
        std::fprintf(stderr, "expected '%s' and a number\n", head);
        std::exit(2);
    }
    return count;
}

inline equations read_equations() {
    equations result;
    std::string word;
    std::cin >> result.limit;  // its word was read
    result.steps.resize(read_count("steps"));
    for (step& each : result.steps) {
        std::cin >> word >> each.left >> each.right;
        each.constant = read_number();
        each.numerator = read_number();
        each.denominator = read_number();
        const auto known = operations().find(word);
        if (known == operations().end()) {
            std::fprintf(stderr, "does not know '%s'\n", word.c_str());
            std::exit(2);
        }
        each.apply = known->second;
    }
    result.values.resize(result.steps.size());
    const std::size_t states = read_count("states");
    for (std::size_t i = 0; i < states; ++i) {
        std::size_t at = 0;
        std::size_t slope = 0;
        std::cin >> at >> slope;
        result.state.push_back(at);
        result.slope.push_back(slope);
        result.start.push_back(read_number());
        result.scale.push_back(read_number());
    }
    result.times.resize(read_count("times"));
    result.begin = read_number();
    for (double& each : result.times) {
        each = read_number();
    }
    return result;
}

// Thrown by a solver that ends without an answer.
struct no_answer {};

// Reads the problem, and lets solve(equations, method, tolerance, values) run it for each requested method and
// tolerance: it appends the states at all times, or throws no_answer.
template <class Solve>
int answer(const std::string& version, Solve solve) {
    std::string word;
    std::cin >> word;
    if (word == "version") {
        std::printf("%s\n", version.c_str());
        return 0;
    }
    equations of = read_equations();
    const std::size_t runs = read_count("runs");
    for (std::size_t run = 0; run < runs; ++run) {
        std::string method;
        std::cin >> method;
        const double tolerance = read_number();
        std::vector<double> values;
        of.evaluations = 0;
        const char* outcome = "ended";
        try {
            solve(of, method, tolerance, values);
        } catch (const no_answer&) {
            outcome = of.evaluations > of.limit ? "stopped" : "failed";
        }
        std::printf("%s %ld\n", outcome, of.evaluations);
        for (std::size_t i = 0; *outcome == 'e' && i < values.size(); ++i) {
            std::printf("%a\n", values[i]);
        }
    }
    return 0;
}

}  // namespace peers
