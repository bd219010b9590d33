// Calls of the C interface from Python: handles, results as Python objects, errors as exceptions, without the
// interpreter's lock.
#pragma once

#include <libration.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../owned_handles.hpp"

namespace libration::python {

namespace py = pybind11;

// Handles owned by Python objects.
struct motion_object {
    owned::motion handle;
};
struct problem_object {
    owned::problem handle;
};
struct solution_object {
    owned::solution handle;
};
struct law_object {
    owned::law handle;
};
struct sampler_object {
    owned::sampler handle;
};

// decimal, uncertainty, rigour: the parts of a Ball.
using number_parts = std::tuple<std::string, std::string, int>;
// Names, and cells row by row: a text, or the parts of a number.
using table_parts = std::pair<std::vector<std::string>, py::list>;

// The error of a failed call as an exception of libration.errors, with the results that are known nevertheless; a
// signal that cancelled the call is raised as its own exception.
[[noreturn]] inline void raise(int code, const py::object& partial = py::none()) {
    if (code == LIBRATION_CANCELLED && PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    if (code == LIBRATION_NO_MEMORY) {
        PyErr_SetString(PyExc_MemoryError, libration_error_message());
        throw py::error_already_set();
    }
    const py::object raised = py::module_::import("libration.errors")
                                  .attr("error_of")(code, libration_error_message(), libration_error_subject(),
                                                    libration_error_value(), libration_error_reason());
    if (!partial.is_none()) {
        raised.attr("partial") = partial;
    }
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
    throw py::error_already_set();
}

// call() without the interpreter's lock; its error as an exception. The error is kept for this thread.
template <class Call>
void run(const Call& call) {
    int code = LIBRATION_OK;
    {
        const py::gil_scoped_release released;
        code = call();
    }
    if (code != LIBRATION_OK) {
        raise(code);
    }
}

// The object created by call(&handle).
template <class Owned, class Call>
Owned made(const Call& call) {
    typename Owned::pointer handle = nullptr;
    run([&] { return call(&handle); });
    return Owned(handle);
}

// Handles Ctrl-C in long calls, and passes the part that is done to the package, ten times a second
// (python/libration/progress.py).
inline int watch_signals(double part, void* /*context*/) {
    using clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds pause{100};
    thread_local clock::time_point told = clock::now();
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) {
        return 1;
    }
    if (clock::now() - told < pause) {
        return 0;
    }
    told = clock::now();
    try {
        py::module_::import("libration.progress").attr("reached")(part);
        return 0;
    } catch (py::error_already_set& problem) {
        problem.restore();
        return 1;
    }
}

inline const char* optional_text(const std::optional<std::string>& text) { return text ? text->c_str() : nullptr; }

inline number_parts parts_of(const libration_number* number) {
    return {libration_number_decimal(number), libration_number_uncertainty(number), libration_number_rigour(number)};
}

template <class Call>
number_parts number(const Call& call) {
    return parts_of(made<owned::number>(call).get());
}

inline table_parts parts_of(const libration_table* found) {
    table_parts parts;
    const std::size_t columns = libration_table_columns(found);
    for (std::size_t i = 0; i < columns; ++i) {
        parts.first.emplace_back(libration_table_name(found, i));
    }
    for (std::size_t row = 0; row < libration_table_rows(found); ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const libration_number* const cell = libration_table_number(found, row, column);
            if (cell != nullptr) {
                parts.second.append(parts_of(cell));
            } else {
                parts.second.append(libration_table_text(found, row, column));
            }
        }
    }
    return parts;
}

template <class Call>
table_parts table(const Call& call) {
    return parts_of(made<owned::table>(call).get());
}

// For a call that returns a table of known values even if it fails; the exception has it as `partial`.
template <class Call>
table_parts known_table(const Call& call) {
    libration_table* handle = nullptr;
    int code = LIBRATION_OK;
    {
        const py::gil_scoped_release released;
        code = call(&handle);
    }
    const owned::table found(handle);
    if (code != LIBRATION_OK) {
        raise(code, found ? py::cast(parts_of(found.get())) : py::none());
    }
    return parts_of(found.get());
}

}  // namespace libration::python
