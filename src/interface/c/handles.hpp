// The objects behind the handles of the C interface.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/known/pendulum_solution.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/printed_number.hpp"

// The shared library exports what this header declares; everything else is hidden.
#pragma GCC visibility push(default)
#include "libration.h"
#pragma GCC visibility pop

struct libration_number {
    std::string decimal;
    std::string uncertainty;
    int rigour = LIBRATION_HEURISTIC;
};

/// Rows of cells; words are numbers without rigour.
struct libration_table {
    struct cell {
        libration_number number;
        bool is_number = false;
    };

    std::vector<std::string> names;
    std::vector<cell> cells;

    void add(libration_number number) { cells.push_back({std::move(number), true}); }
    void add(std::string words) { cells.push_back({{std::move(words), "", LIBRATION_HEURISTIC}, false}); }
};

struct libration_motion {
    libration::pendulum::given_motion given;
    libration::pendulum::motion of;
};

struct libration_problem {
    libration::ode::equation_system equations;
    std::vector<std::string> names;  ///< of the unknowns and their lower derivatives
    /// Of equations without events, step functions, delays and intervals.
    std::optional<libration::ode::explicit_system> ordinary = {};

    /// Throws error of the subject "problem" for other equations.
    const libration::ode::explicit_system& system() const;
};

struct libration_solution {
    libration_problem of;
    std::unique_ptr<libration::solution> kept = {};  ///< null before the first question, and after a failure
    std::unique_ptr<std::mutex> guard = std::make_unique<std::mutex>();
};

struct libration_law {
    std::unique_ptr<libration::proved_law> of;  ///< null after a failure
    std::unique_ptr<std::mutex> guard = std::make_unique<std::mutex>();
    double rho = 0;
    long first = 0, stride = 0, residue = 0;
};

struct libration_steps {
    std::size_t order = 0;
    std::vector<double> times;
    std::vector<double> coefficients;
};

struct libration_sampler {
    std::unique_ptr<libration::double_sampler> of;
};

namespace libration::c {

/// A decimal that is correct to one unit in the last digit; 0 and inf are exact.
libration_number rounded_number(const std::string& decimal);
/// Throws std::logic_error if no digit is proved.
libration_number proved_number(const proved_decimal& number);
/// An integer.
inline libration_number count_number(long n) { return {std::to_string(n), "0", LIBRATION_PROVED}; }
/// Typed text, unchanged.
inline libration_number typed_number(const std::string& text) { return {text, "0", LIBRATION_PROVED}; }

}  // namespace libration::c
