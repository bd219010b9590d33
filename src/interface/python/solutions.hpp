// One solution for several questions, in Python.
#pragma once

#include "calls.hpp"

namespace libration::python {

inline void define_solutions(py::module_& m) {
    py::class_<solution_object> solution(m, "Solution");
    solution.def(py::init([](const problem_object& of) {
        return solution_object{
            made<owned::solution>([&](auto** to) { return libration_solution_new(of.handle.get(), to); })};
    }));
    solution.def("states", [](const solution_object& of, const std::string& times, long digits, int rigour) {
        return known_table([&](auto** to) {
            return libration_solution_states(of.handle.get(), times.c_str(), digits, rigour, watch_signals, nullptr,
                                             to);
        });
    });
    solution.def("events", [](const solution_object& of, const std::string& condition, const std::string& settings,
                              long count, long digits) {
        return known_table([&](auto** to) {
            return libration_solution_events(of.handle.get(), condition.c_str(), settings.c_str(), count, digits,
                                             watch_signals, nullptr, to);
        });
    });
    solution.def(
        "coefficients", [](const solution_object& of, const std::optional<std::string>& point,
                           const std::optional<std::string>& corners, long first, long last, long digits, int rigour) {
            return table([&](auto** to) {
                return libration_solution_coefficients(of.handle.get(), optional_text(point), optional_text(corners),
                                                       first, last, digits, rigour, to);
            });
        });
    solution.def("certificate",
                 [](const solution_object& of, const std::string& times, long digits, const std::string& path) {
                     return table([&](auto** to) {
                         return libration_solution_certificate(of.handle.get(), times.c_str(), digits, path.c_str(),
                                                               watch_signals, nullptr, to);
                     });
                 });
    solution.def("event_certificate", [](const solution_object& of, const std::string& condition, long count,
                                         long digits, const std::string& path) {
        return table([&](auto** to) {
            return libration_solution_event_certificate(of.handle.get(), condition.c_str(), count, digits, path.c_str(),
                                                        watch_signals, nullptr, to);
        });
    });
    solution.def("steps", [](const solution_object& of) {
        const py::gil_scoped_release released;
        return libration_solution_steps(of.handle.get());
    });
}

}  // namespace libration::python
