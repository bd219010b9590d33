// The programs that the study `solvers` runs, and their input: peers/equation_code.hpp.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/expansion/tape.hpp"
#include "run/child_program.hpp"
#include "run/program_files.hpp"

namespace libration::studies::proved {

/// A library that solves initial value problems, in a separate program.
struct solver_peer {
    std::string name;     ///< in --solvers
    std::string program;  ///< peers/
    std::string package;  ///< Debian package that it requires
    std::vector<std::string> methods;
    std::vector<std::string> implicit_methods;  ///< those for stiff problems
    long most_evaluations = 200'000;            ///< of the right-hand side, in one run
};

inline const std::vector<solver_peer>& solver_peers() {
    static const std::vector<solver_peer> all{
        {"odeint", "libration-odeint-solvers", "libboost1.81-dev", {"dopri5", "rkf78", "bulirsch-stoer"}, {}},
        {"gsl", "libration-gsl-solvers", "libgsl-dev", {"rkf45", "rk8pd", "msadams", "msbdf"}, {"msbdf"}},
        {"sundials", "libration-sundials-solvers", "libsundials-dev", {"cvode-adams", "cvode-bdf"}, {"cvode-bdf"}},
        {"scipy",
         "scipy_solvers.py",
         "python3-scipy",
         {"RK45", "DOP853", "LSODA", "Radau", "BDF"},
         {"LSODA", "Radau", "BDF"}},
        {"mpmath", "mpmath_solvers.py", "python3-mpmath", {"odefun"}, {}, 20'000}};
    return all;
}

/// Its library and version; std::nullopt if it is not installed, or was not when this program was built.
inline std::optional<std::string> version_of(const solver_peer& peer) {
    try {
        std::string answer = output_of_program(peer_program(peer.program), "version\n");
        answer.resize(answer.find_last_not_of('\n') + 1);
        return answer;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

/// The input of a solver in double for y' = f(t, y): elementary operations, initial values and times, each number
/// rounded to the nearest double, and the scale of each unknown, by which its absolute tolerance is multiplied.
class solver_input {
public:
    solver_input(const ode::explicit_system& of, const std::vector<ode::number>& times, std::vector<double> scales = {})
        : tape_(ode::tape::about_points(of)) {
        text_ = fmt::format("steps {}\n", tape_.steps().size());
        for (std::size_t k = 0; k < tape_.steps().size(); ++k) {
            add_step(k);
        }
        text_ += fmt::format("states {}\n", tape_.states().size());
        scales.resize(tape_.states().size(), 1);
        for (std::size_t i = 0; i < scales.size(); ++i) {
            const ode::tape_state& state = tape_.states()[i];
            const auto unknown = static_cast<std::size_t>(state.unknown);
            const bool highest = state.derivative + 1 == tape_.orders()[unknown];
            text_ +=
                fmt::format("{} {} {:a} {:a}\n", state.step, highest ? tape_.outputs()[unknown] : next_of(state).step,
                            rounded(tape_.starts()[unknown][static_cast<std::size_t>(state.derivative)]), scales[i]);
        }
        text_ += fmt::format("times {} {:a}\n", times.size(), rounded(tape_.point()));
        for (const ode::number& time : times) {
            text_ += fmt::format("{:a}\n", rounded(time));
        }
    }

    std::size_t states() const { return tape_.states().size(); }
    const std::string& text() const { return text_; }

private:
    static double rounded(const ode::number& x) { return ode::constant_value<double>::of(x); }

    const ode::tape_state& next_of(const ode::tape_state& state) const {
        for (const ode::tape_state& other : tape_.states()) {
            if (other.unknown == state.unknown && other.derivative == state.derivative + 1) {
                return other;
            }
        }
        throw std::logic_error("the tape has no such derivative");
    }

    // The step's name, or for the second of a pair that of its companion.
    std::string word_of(std::size_t k) const {
        using enum ode::operation;
        switch (tape_.steps()[k].kind) {
            case constant: return "constant";
            case variable: return "variable";
            case state: return "state";
            case sum: return "sum";
            case difference: return "difference";
            case scaled: return "scaled";
            case raised: return "raised";
            case by_variable: return "by_time";
            case product:
            case square: return "product";
            case quotient: return "quotient";
            case square_root: return "sqrt";
            case power: return "power";
            case function: return std::string(name_of(tape_.steps()[k].function));
            case companion: return word_beside(tape_.steps()[k - 1]);
            case primitive:
            case delayed:
            case slope: break;  // needed by series only
        }
        return "nothing";
    }

    static const char* word_beside(const ode::tape_step& step) {
        const auto is = [&](function_kind f) { return step.kind == ode::operation::function && step.function == f; };
        return is(function_kind::sin)    ? "cos"
               : is(function_kind::sinh) ? "cosh"
               : is(function_kind::asin) ? "root_beside"
                                         : "nothing";
    }

    void add_step(std::size_t k) {
        const std::string word = word_of(k);
        const bool beside = tape_.steps()[k].kind == ode::operation::companion;
        const ode::tape_step& step = tape_.steps()[beside && word != "nothing" ? k - 1 : k];
        const int right = step.kind == ode::operation::square ? step.left : step.right;
        const double constant =
            step.constant < 0 ? 1 : rounded(tape_.constants()[static_cast<std::size_t>(step.constant)]);
        text_ += fmt::format("{} {} {} {:a} {:a} {:a}\n", word, std::max(step.left, 0), std::max(right, 0), constant,
                             static_cast<double>(step.numerator), static_cast<double>(step.denominator));
    }

    ode::tape tape_;
    std::string text_;
};

/// A method of a peer at a tolerance, relative and absolute.
struct solver_run {
    std::string method;
    std::string tolerance;
};

/// The result of a run.
struct solver_answer {
    std::string outcome;         ///< ended, stopped at the limit, failed
    long evaluations = 0;        ///< of the right-hand side
    std::vector<double> values;  ///< of all unknowns and their lower derivatives, time by time
};

/// Throws std::runtime_error if the program does not return them.
inline std::vector<solver_answer> answers_of(const solver_peer& peer, const solver_input& problem, std::size_t times,
                                             const std::vector<solver_run>& runs) {
    std::string question = fmt::format("limit {}\n{}runs {}\n", peer.most_evaluations, problem.text(), runs.size());
    for (const solver_run& each : runs) {
        question += fmt::format("{} {:a}\n", each.method, std::strtod(each.tolerance.c_str(), nullptr));
    }
    std::istringstream said(output_of_program(peer_program(peer.program), question));
    std::vector<solver_answer> answers(runs.size());
    for (solver_answer& each : answers) {
        said >> each.outcome >> each.evaluations;
        for (std::size_t i = 0; each.outcome == "ended" && i < times * problem.states(); ++i) {
            std::string word;
            said >> word;
            each.values.push_back(std::strtod(word.c_str(), nullptr));
        }
    }
    if (!said) {
        throw std::runtime_error(peer.program + " did not return all results");
    }
    return answers;
}

}  // namespace libration::studies::proved
