// What a peer that solves initial value problems is told on stdin, and answers on stdout, all numbers hexadecimal
// floats:
//
//   stdin    version                                   asks for name and version of the library, nothing else
//   stdin    limit L                                   evaluations of the right sides that a run may take
//            steps K, then K of: kind left right constant numerator denominator
//            states N, then N of: its step, the step of its slope, its start
//            times M t0, then t_1 .. t_M
//            runs R, then R of: method tolerance
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

enum class kind {
    nothing,
    constant,
    variable,
    state,
    sum,
    difference,
    scaled,
    raised,
    by_time,
    product,
    quotient,
    sqrt,
    power,
    exp,
    log,
    sin,
    cos,
    tan,
    atan,
    asin,
    root_beside,
    sinh,
    cosh,
    tanh
};

struct step {
    kind what = kind::nothing;
    std::size_t left = 0;
    std::size_t right = 0;
    double constant = 0;
    double numerator = 1;
    double denominator = 1;
};

inline const std::map<std::string, kind>& kinds_of_steps() {
    static const std::map<std::string, kind> all{
        {"nothing", kind::nothing}, {"constant", kind::constant}, {"variable", kind::variable},
        {"state", kind::state},     {"sum", kind::sum},           {"difference", kind::difference},
        {"scaled", kind::scaled},   {"raised", kind::raised},     {"by_time", kind::by_time},
        {"product", kind::product}, {"quotient", kind::quotient}, {"sqrt", kind::sqrt},
        {"power", kind::power},     {"exp", kind::exp},           {"log", kind::log},
        {"sin", kind::sin},         {"cos", kind::cos},           {"tan", kind::tan},
        {"atan", kind::atan},       {"asin", kind::asin},         {"root_beside", kind::root_beside},
        {"sinh", kind::sinh},       {"cosh", kind::cosh},         {"tanh", kind::tanh}};
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
            evaluate(k, t);
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
    double begin = 0;
    std::vector<double> times;
    long limit = 0;
    long evaluations = 0;
    std::vector<double> values;

private:
    void evaluate(std::size_t k, double t) {
        const step& s = steps[k];
        const double a = values[s.left];
        const double b = values[s.right];
        double& result = values[k];
        switch (s.what) {
            case kind::constant: result = s.constant; break;
            case kind::variable: result = t; break;
            case kind::sum: result = a + b; break;
            case kind::difference: result = a - b; break;
            case kind::scaled: result = a * s.constant * s.numerator / s.denominator; break;
            case kind::raised: result = a + s.constant; break;
            case kind::by_time: result = t * a; break;
            case kind::product: result = a * b; break;
            case kind::quotient: result = a / b; break;
            case kind::sqrt: result = std::sqrt(a); break;
            case kind::power: result = std::pow(a, s.constant); break;
            case kind::exp: result = std::exp(a); break;
            case kind::log: result = std::log(a); break;
            case kind::sin: result = std::sin(a); break;
            case kind::cos: result = std::cos(a); break;
            case kind::tan: result = std::tan(a); break;
            case kind::atan: result = std::atan(a); break;
            case kind::asin: result = std::asin(a); break;
            case kind::root_beside: result = std::sqrt(1 - a * a); break;
            case kind::sinh: result = std::sinh(a); break;
            case kind::cosh: result = std::cosh(a); break;
            case kind::tanh: result = std::tanh(a); break;
            default: break;
        }
    }
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
        const auto known = kinds_of_steps().find(word);
        if (known == kinds_of_steps().end()) {
            std::fprintf(stderr, "does not know '%s'\n", word.c_str());
            std::exit(2);
        }
        each.what = known->second;
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

// Reads the problem, and lets solve(equations, method, tolerance, values) run it for each method and tolerance that is
// asked: it appends the states at all times, or throws no_answer.
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
