// Integrations by other libraries, and the tolerances with which they attain an error.
#pragma once

#include <boost/numeric/odeint.hpp>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "../peers/slopes.hpp"
#include "equation_peers.hpp"
#include "libration/number/exact.hpp"
#include "libration/scalar/mpfr.hpp"
#include "run/child_program.hpp"

// A number of Boost.Multiprecision has a member value_type, which odeint takes for that of the state.
template <>
struct boost::numeric::odeint::norm_result_type<std::vector<libration::mpfr>, void> {
    using type = libration::mpfr;
};

namespace libration::bench {

/// The value of a decimal in T.
template <class T>
T value_of(const std::string& decimal) {
    return from_exact<T>(read_exact(decimal));
}

/// The largest 10^-k or 2^-k, first <= k <= last, with which the error is at most the requested one.
template <class Error>
int least_tolerance(int first, int last, const mpfr& asked, const Error& error) {
    for (int k = first; k < last; ++k) {
        if (error(k) <= asked) {
            return k;
        }
    }
    return last;
}

/// The right-hand side of a problem of equation_peers.hpp.
template <class T>
peers::slope_function<T> slope_of(const std::string& problem) {
    return problem == "lorenz"     ? peers::lorenz<T>
           : problem == "kepler"   ? peers::kepler<T>
           : problem == "pendulum" ? peers::pendulum<T>
                                   : peers::four_body<T>;
}

/// The state at the end from a start.
template <class T>
std::vector<T> by_odeint(const initial_value_problem& of, std::vector<T> x, const T& tolerance) {
    namespace odeint = boost::numeric::odeint;
    using state = std::vector<T>;
    using plain = odeint::runge_kutta_fehlberg78<state, T, state, T>;
    static const plain stepper;  // static: GCC warns about the state that copies copy
    const auto controlled = odeint::make_controlled(tolerance, tolerance, stepper);
    const auto slopes = [slope = slope_of<T>(of.name)](const state& at, state& out, const T& /*t*/) {
        slope(at.data(), out.data());
    };
    odeint::integrate_adaptive(controlled, slopes, x, T(0), value_of<T>(of.end), value_of<T>("0.001"));
    return x;
}

/// The time measured by a separate program, and its values.
template <class T>
struct peer_answer {
    double nanoseconds = 0;
    std::vector<T> values;
};

template <class T>
peer_answer<T> ask_peer(const char* program, const std::string& input, std::size_t count) {
    std::istringstream answer(output_of_program(program, input));
    peer_answer<T> result;
    answer >> result.nanoseconds;
    std::string word;
    for (std::size_t i = 0; i < count && answer >> word; ++i) {
        if constexpr (std::is_same_v<T, double>) {
            result.values.push_back(std::strtod(word.c_str(), nullptr));
        } else {
            result.values.push_back(value_of<T>(word));
        }
    }
    return result;
}

}  // namespace libration::bench
