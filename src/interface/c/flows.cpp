// Solutions in double precision: at many times from many starts, and as the polynomials of their steps.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "guarded.hpp"
#include "libration/integration/taylor/batch_march.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/integration/taylor/varied_problem.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/dispatch.hpp"

namespace libration::c {

namespace {

constexpr std::size_t most_steps = 1'000'000;

using state = ode::solution_state<double>;
using march = ode::taylor_march<double>;

void require_finite(double x, const char* name) {
    if (!std::isfinite(x)) {
        throw error(error_kind::argument, name, "", "is not a finite number");
    }
}

void require_finite(const double* numbers, std::size_t count, const char* name) {
    if (count > 0) {
        given(numbers, name);
    }
    std::for_each_n(numbers, count, [&](double x) { require_finite(x, name); });
}

state state_of(const ode::explicit_system& system, const double* values) {
    state result;
    for (const ode::unknown_function& each : system.unknowns()) {
        result.emplace_back(values, values + each.order);
        values += each.order;
    }
    return result;
}

bool is_finite(const state& values) {
    return std::ranges::all_of(values, [](const auto& of_unknown) {
        return std::ranges::all_of(of_unknown, [](double x) { return std::isfinite(x); });
    });
}

// From so many solutions on, those in lock step take less time than one after the other, with the same values.
constexpr std::size_t least_in_lock_step = 4;

// Whether the integration reaches a time, with finite values there.
bool reaches(march& of, double time, state& values) {
    try {
        values = of.advance_to(time);
        return is_finite(values);
    } catch (const error& problem) {
        if (!problem.is_about(error_subject::time)) {
            throw;
        }
        return false;
    }
}

// One solution at all times, in rows of `size` numbers.
void write_solution(march& of, double begin, const double* times, const std::vector<std::size_t>& order,
                    std::size_t size, double* rows) {
    std::fill_n(rows, order.size() * size, std::numeric_limits<double>::quiet_NaN());
    bool ended = false;
    bool forward = true;
    for (const std::size_t i : order) {
        if ((times[i] >= begin) != forward) {
            forward = false;
            ended = false;
        }
        state values;
        ended = ended || !reaches(of, times[i], values);
        if (ended) {
            continue;
        }
        double* to = rows + i * size;
        for (const auto& of_unknown : values) {
            to = std::ranges::copy(of_unknown, to).out;
        }
    }
}

// The solutions from these states, row by row.
void write_solutions(const ode::explicit_system& system, const ode::batch_request& of, std::size_t solutions,
                     const watcher& watched, double* values) {
    if (solutions >= least_in_lock_step) {
        ode::batch_march together(system);
        together.run(of, {values, solutions * of.times.size() * together.written()},
                     [&](std::size_t finished) { watched(finished, solutions); });
        return;
    }
    march alone(system);
    const std::size_t size = solutions == 0 ? 0 : of.states.size() / solutions;
    const auto order = ode::in_order_of_steps(of.begin, of.times);
    for (std::size_t i = 0; i < solutions; ++i) {
        alone.begin_at(of.begin, state_of(system, of.states.data() + i * size));
        write_solution(alone, of.begin, of.times.data(), order, size, values + i * of.times.size() * size);
        watched(i + 1, solutions);
    }
}

double origin_of(const ode::explicit_system& system) { return ode::constant_value<double>::of(system.point()); }

// The only solution from a singular initial point is that of the problem itself.
void require_regular(const ode::explicit_system& system, double begin) {
    require_finite(begin, "begin");
    if (system.singular() && begin == origin_of(system)) {
        throw error(error_kind::argument, "begin", to_decimal(begin, 6),
                    "is a singular initial point: begin at another time, with the state there");
    }
}

// Appends the polynomials of the current step.
void add_polynomials(const march& of, const ode::explicit_system& system, std::vector<double>& to) {
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        for (int j = 0; j < system.unknowns()[i].order; ++j) {
            const double* const first = of.coefficients(static_cast<int>(i), j);
            to.insert(to.end(), first, first + of.order() + 1);
        }
    }
}

// Whether there is a step on which the polynomials added last are finite.
bool advances(march& of, double end, bool& done) {
    try {
        done = !of.step_towards(end);
        return true;
    } catch (const error& problem) {
        if (!problem.is_about(error_subject::time)) {
            throw;
        }
        return false;
    }
}

// The solution of equations with events or delays, in double; nan at times that are not reached.
void write_states(const libration_problem& of, const double* times, std::size_t count, double* values) {
    std::vector<exact> at;
    std::transform(times, times + count, std::back_inserter(at), [](double time) { return exactly(rational(time)); });
    const answer found = solve(problem(of.equations))->states(at, request{.scalar = read_scalar("double")});
    for (std::size_t k = 0; k < count; ++k) {
        for (const std::string& name : of.names) {
            const bool reached = k < found.rows.size() && !found.rows[k].empty();
            *values++ =
                reached ? from_exact<double>(read_exact(found.at(k, name))) : std::numeric_limits<double>::quiet_NaN();
        }
    }
}

libration_steps steps_of(const libration_problem& problem, double begin, const double* start, double end) {
    march of(problem.system());
    of.begin_at(begin, state_of(problem.system(), start));
    libration_steps result{static_cast<std::size_t>(of.order()), {begin}, {}};
    for (bool done = begin == end; !done;) {
        if (result.times.size() > most_steps) {
            throw error(error_kind::undecided, error_subject::time, to_decimal(end, 6),
                        "is not reached in a million steps, as for stiff equations: the last of them is at " +
                            to_decimal(result.times.back(), 6));
        }
        const std::size_t before = result.coefficients.size();
        add_polynomials(of, problem.system(), result.coefficients);
        const bool finite = std::all_of(result.coefficients.begin() + static_cast<std::ptrdiff_t>(before),
                                        result.coefficients.end(), [](double x) { return std::isfinite(x); });
        if (!finite || !advances(of, end, done)) {
            result.coefficients.resize(before);
            break;
        }
        result.times.push_back(done ? end : of.centre());
    }
    return result;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_problem_flow(const libration_problem* problem, double begin, size_t solutions, const double* starts,
                           size_t count, const double* times, libration_watch watch, void* context, double* values) {
    return guarded([&] {
        const std::size_t size = given(problem, "problem").names.size();
        require_finite(times, count, "times");
        if (solutions * count > 0) {
            given(values, "values");
        }
        if (starts == nullptr && !problem->ordinary) {
            write_states(*problem, times, count, values);
            return;
        }
        if (starts == nullptr) {
            march of(problem->system());
            const double origin = origin_of(problem->system());
            write_solution(of, origin, times, ode::in_order_of_steps(origin, {times, count}), size, values);
            return;
        }
        require_regular(problem->system(), begin);
        require_finite(starts, solutions * size, "starts");
        write_solutions(problem->system(), {begin, {starts, solutions * size}, {times, count}}, solutions,
                        watcher(watch, context), values);
    });
}

int libration_problem_varied_flow(const libration_problem* problem, const char* names, const double* numbers,
                                  double begin, size_t solutions, const double* starts, size_t count,
                                  const double* times, libration_watch watch, void* context, double* values) {
    return guarded([&] {
        const std::size_t size = given(problem, "problem").names.size();
        const ode::varied_problem varied(problem->equations, items_of(text_of(names, "names"), "names"));
        require_finite(begin, "begin");
        require_finite(times, count, "times");
        require_finite(numbers, solutions * varied.names(), "numbers");
        require_finite(starts, starts == nullptr ? 0 : solutions * size, "starts");
        if (solutions * count > 0) {
            given(values, "values");
        }
        std::vector<double> states;
        for (std::size_t i = 0; i < solutions; ++i) {
            const std::span row(numbers + i * varied.names(), varied.names());
            if (starts == nullptr) {
                varied.append_state(row, states);
            } else {
                varied.append_state(row, {starts + i * size, size}, states);
            }
        }
        ode::batch_march together(varied.system(), varied.parameters());
        const watcher watched(watch, context);
        together.run({starts == nullptr ? origin_of(problem->system()) : begin, states, {times, count}},
                     {values, solutions * count * size}, [&](std::size_t finished) { watched(finished, solutions); });
    });
}

int libration_problem_start(const libration_problem* problem, double* time, double* values) {
    return guarded([&] {
        const ode::explicit_system& system = given(problem, "problem").system();
        given(time, "time");
        given(values, "values");
        *time = origin_of(system);
        for (const auto& of_unknown : system.starts()) {
            values = std::ranges::transform(of_unknown, values, &ode::constant_value<double>::of).out;
        }
    });
}

int libration_steps_new(const libration_problem* problem, double begin, const double* start, double end,
                        libration_steps** steps) {
    return made(steps, [&] {
        require_regular(given(problem, "problem").system(), begin);
        require_finite(end, "end");
        require_finite(start, problem->names.size(), "start");
        return steps_of(*problem, begin, start, end);
    });
}

size_t libration_steps_count(const libration_steps* steps) { return steps == nullptr ? 0 : steps->times.size() - 1; }

size_t libration_steps_order(const libration_steps* steps) { return steps == nullptr ? 0 : steps->order; }

const double* libration_steps_times(const libration_steps* steps) {
    return steps == nullptr ? nullptr : steps->times.data();
}

const double* libration_steps_coefficients(const libration_steps* steps) {
    return steps == nullptr ? nullptr : steps->coefficients.data();
}

void libration_steps_free(libration_steps* steps) { delete steps; }
