// The compiled half of the Python package: the C interface with Python's texts, exceptions and arrays. The public
// interface is in python/libration.
#include <pybind11/numpy.h>

#include <array>

#include "calls.hpp"
#include "laws.hpp"
#include "solutions.hpp"

namespace {

using namespace libration::python;
namespace owned = libration::owned;

using doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::pair<doubles, doubles> sampled(const sampler_object& of, const doubles& times) {
    const std::vector<py::ssize_t> shape(times.shape(), times.shape() + times.ndim());
    doubles theta(shape);
    doubles omega(shape);
    const double* const from = times.data();
    double* const angles = theta.mutable_data();
    double* const speeds = omega.mutable_data();
    const auto count = static_cast<std::size_t>(times.size());
    run([&] { return libration_sampler_at(of.handle.get(), count, from, angles, speeds); });
    return {theta, omega};
}

// The states at the times, [solution][time][name]; without starts, of the solution of the problem itself.
doubles flow(const problem_object& of, double begin, const std::optional<doubles>& starts, const doubles& times) {
    const auto size = static_cast<py::ssize_t>(libration_problem_size(of.handle.get()));
    if ((starts && (starts->ndim() != 2 || starts->shape(1) != size)) || times.ndim() != 1) {
        throw py::value_error("starts are rows of " + std::to_string(size) + " numbers, times one row");
    }
    doubles values({starts ? starts->shape(0) : 1, times.shape(0), size});
    const double* const from = starts ? starts->data() : nullptr;
    const double* const at = times.data();
    double* const to = values.mutable_data();
    const auto solutions = static_cast<std::size_t>(values.shape(0));
    const auto count = static_cast<std::size_t>(times.shape(0));
    run([&] {
        return libration_problem_flow(of.handle.get(), begin, solutions, from, count, at, watch_signals, nullptr, to);
    });
    return values;
}

// flow() with a row of values of these parameters and initial values for each solution.
doubles varied_flow(const problem_object& of, const std::string& names, const doubles& numbers, double begin,
                    const std::optional<doubles>& starts, const doubles& times) {
    const auto size = static_cast<py::ssize_t>(libration_problem_size(of.handle.get()));
    const bool fits =
        !starts || (starts->ndim() == 2 && starts->shape(1) == size && starts->shape(0) == numbers.shape(0));
    if (numbers.ndim() != 2 || !fits || times.ndim() != 1) {
        throw py::value_error("numbers and starts have a row for each solution, times are one row");
    }
    doubles values({numbers.shape(0), times.shape(0), size});
    const double* const given = numbers.data();
    const double* const from = starts ? starts->data() : nullptr;
    const double* const at = times.data();
    double* const to = values.mutable_data();
    const auto solutions = static_cast<std::size_t>(values.shape(0));
    const auto count = static_cast<std::size_t>(times.shape(0));
    run([&] {
        return libration_problem_varied_flow(of.handle.get(), names.c_str(), given, begin, solutions, from, count, at,
                                             watch_signals, nullptr, to);
    });
    return values;
}

// The initial time, and the state there.
std::pair<double, doubles> start(const problem_object& of) {
    doubles values(static_cast<py::ssize_t>(libration_problem_size(of.handle.get())));
    double time = 0;
    double* const to = values.mutable_data();
    run([&] { return libration_problem_start(of.handle.get(), &time, to); });
    return {time, values};
}

// The points between the steps, and their coefficients [step][name][power].
std::pair<doubles, doubles> steps(const problem_object& of, double begin, const doubles& start, double end) {
    const auto size = static_cast<py::ssize_t>(libration_problem_size(of.handle.get()));
    if (start.ndim() != 1 || start.shape(0) != size) {
        throw py::value_error("the start is one row of " + std::to_string(size) + " numbers");
    }
    const double* const from = start.data();
    const auto found =
        made<owned::steps>([&](auto** to) { return libration_steps_new(of.handle.get(), begin, from, end, to); });
    const auto count = static_cast<py::ssize_t>(libration_steps_count(found.get()));
    const auto powers = static_cast<py::ssize_t>(libration_steps_order(found.get())) + 1;
    return {doubles(count + 1, libration_steps_times(found.get())),
            doubles({count, size, powers}, libration_steps_coefficients(found.get()))};
}

// mantissa, exponent, radius, exponent of the radius of the number with these parts.
std::tuple<std::string, long, unsigned long, long> exact_parts(const libration_number* number) {
    std::string mantissa(libration_number_mantissa_size(number), '\0');
    long exponent = 0;
    unsigned long radius = 0;
    long radius_exponent = 0;
    run([&] {
        return libration_number_exact(number, mantissa.data(), mantissa.size(), &exponent, &radius, &radius_exponent);
    });
    return {mantissa.c_str(), exponent, radius, radius_exponent};
}

void define_motions(py::module_& m) {
    py::class_<motion_object> motion(m, "Motion");
    motion.def(py::init([](const std::string& given) {
        return motion_object{made<owned::motion>([&](auto** to) { return libration_motion_new(given.c_str(), to); })};
    }));
    motion.def("regime", [](const motion_object& of) { return libration_motion_regime(of.handle.get()); });
    const auto define = [&](const char* name, auto* function) {
        motion.def(name, [function](const motion_object& of, long digits, int rigour) {
            return number([&](auto** to) { return function(of.handle.get(), digits, rigour, to); });
        });
    };
    define("period", libration_motion_period);
    define("effective_period", libration_motion_effective_period);
    define("energy", libration_motion_energy);
    define("gap", libration_motion_gap);
    const auto define_at = [&](const char* name, auto* function) {
        motion.def(name, [function](const motion_object& of, const std::string& at, long digits, int rigour) {
            return number([&](auto** to) { return function(of.handle.get(), at.c_str(), digits, rigour, to); });
        });
    };
    define_at("theta", libration_motion_theta);
    define_at("omega", libration_motion_omega);
    define_at("radius", libration_motion_radius);
    motion.def("states", [](const motion_object& of, const std::string& times, long digits, int rigour) {
        return table([&](auto** to) {
            return libration_motion_states(of.handle.get(), times.c_str(), digits, rigour, watch_signals, nullptr, to);
        });
    });
    motion.def("coefficients", [](const motion_object& of, const std::string& point, long first, long last, long digits,
                                  int rigour) {
        return table([&](auto** to) {
            return libration_motion_coefficients(of.handle.get(), point.c_str(), first, last, digits, rigour, to);
        });
    });
    motion.def("verify", [](const motion_object& of, const std::string& names, const std::string& times,
                            const std::string& values, const std::string& rules) {
        return table([&](auto** to) {
            return libration_motion_verify(of.handle.get(), names.c_str(), times.c_str(), values.c_str(), rules.c_str(),
                                           watch_signals, nullptr, to);
        });
    });
    py::class_<sampler_object>(m, "Sampler")
        .def(py::init([](const motion_object& of) {
            return sampler_object{
                made<owned::sampler>([&](auto** to) { return libration_sampler_new(of.handle.get(), to); })};
        }))
        .def("at", sampled);
}

void define_problems(py::module_& m) {
    py::class_<problem_object> problem(m, "Problem");
    problem.def(py::init([](const std::string& text, const std::string& settings) {
        return problem_object{
            made<owned::problem>([&](auto** to) { return libration_problem_new(text.c_str(), settings.c_str(), to); })};
    }));
    problem.def("names", [](const problem_object& of) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < libration_problem_size(of.handle.get()); ++i) {
            names.emplace_back(libration_problem_name(of.handle.get(), i));
        }
        return names;
    });
    problem.def("states", [](const problem_object& of, const std::string& times, long digits, int rigour) {
        return known_table([&](auto** to) {
            return libration_problem_known_states(of.handle.get(), times.c_str(), digits, rigour, watch_signals,
                                                  nullptr, to);
        });
    });
    problem.def("derivatives",
                [](const problem_object& of, const std::string& times, const std::string& numbers, long digits) {
                    return known_table([&](auto** to) {
                        return libration_problem_derivatives(of.handle.get(), times.c_str(), numbers.c_str(), digits,
                                                             watch_signals, nullptr, to);
                    });
                });
    problem.def("start", start);
    problem.def("flow", flow);
    problem.def("varied_flow", varied_flow);
    problem.def("steps", steps);
    problem.def("coefficients",
                [](const problem_object& of, const std::optional<std::string>& point,
                   const std::optional<std::string>& corners, long first, long last, long digits, int rigour) {
                    return table([&](auto** to) {
                        return libration_problem_coefficients(of.handle.get(), optional_text(point),
                                                              optional_text(corners), first, last, digits, rigour, to);
                    });
                });
    problem.def("fractions", [](const problem_object& of, long first, long last) {
        return table([&](auto** to) { return libration_problem_fractions(of.handle.get(), first, last, to); });
    });
    problem.def("radius", [](const problem_object& of, long last, long digits) {
        return table([&](auto** to) { return libration_problem_radius(of.handle.get(), last, digits, to); });
    });
    problem.def("radius_bounds", [](const problem_object& of, long digits) {
        libration_number* lower = nullptr;
        libration_number* upper = nullptr;
        run([&] { return libration_problem_radius_bounds(of.handle.get(), digits, &lower, &upper); });
        const owned::number below(lower);
        const owned::number above(upper);
        return std::pair(parts_of(lower), parts_of(upper));
    });
    problem.def("singularities",
                [](const problem_object& of, const std::optional<std::string>& within, long digits, int rigour) {
                    int complete = 0;
                    auto found = table([&](auto** to) {
                        return libration_problem_singularities(of.handle.get(), optional_text(within), digits, rigour,
                                                               to, &complete);
                    });
                    return std::pair(std::move(found), complete == 1);
                });
    problem.def("limits", [](const problem_object& of, long digits) {
        return known_table([&](auto** to) { return libration_problem_limits(of.handle.get(), digits, to); });
    });
    problem.def("enclosures", [](const problem_object& of, const std::string& times, long parts, long digits) {
        return known_table([&](auto** to) {
            return libration_problem_enclosures(of.handle.get(), times.c_str(), parts, digits, watch_signals, nullptr,
                                                to);
        });
    });
    problem.def("enclosed_events",
                [](const problem_object& of, const std::string& condition, long count, long parts, long digits) {
                    return known_table([&](auto** to) {
                        return libration_problem_enclosed_events(of.handle.get(), condition.c_str(), count, parts,
                                                                 digits, watch_signals, nullptr, to);
                    });
                });
    problem.def("events", [](const problem_object& of, const std::string& condition, long count, long digits) {
        return known_table(
            [&](auto** to) { return libration_problem_events(of.handle.get(), condition.c_str(), count, digits, to); });
    });
    problem.def("certificate",
                [](const problem_object& of, const std::string& times, long digits, const std::string& path) {
                    return table([&](auto** to) {
                        return libration_problem_certificate(of.handle.get(), times.c_str(), digits, path.c_str(),
                                                             watch_signals, nullptr, to);
                    });
                });
    problem.def("event_certificate", [](const problem_object& of, const std::string& condition, long count, long digits,
                                        const std::string& path) {
        return table([&](auto** to) {
            return libration_problem_event_certificate(of.handle.get(), condition.c_str(), count, digits, path.c_str(),
                                                       watch_signals, nullptr, to);
        });
    });
    problem.def("find",
                [](const problem_object& of, const std::string& unknowns, const std::string& conditions, long digits) {
                    return table([&](auto** to) {
                        return libration_problem_find(of.handle.get(), unknowns.c_str(), conditions.c_str(), digits,
                                                      watch_signals, nullptr, to);
                    });
                });
    problem.def("find_certificate", [](const problem_object& of, const std::string& unknowns,
                                       const std::string& conditions, long digits, const std::string& path) {
        return table([&](auto** to) {
            return libration_problem_find_certificate(of.handle.get(), unknowns.c_str(), conditions.c_str(), digits,
                                                      path.c_str(), watch_signals, nullptr, to);
        });
    });
    problem.def("orbit_certificate", [](const problem_object& of, long digits, const std::string& path) {
        return table([&](auto** to) {
            return libration_problem_orbit_certificate(of.handle.get(), digits, path.c_str(), watch_signals, nullptr,
                                                       to);
        });
    });
    problem.def("branch", [](const problem_object& of, const std::string& unknowns, const std::string& conditions,
                             const std::string& along, long digits) {
        return known_table([&](auto** to) {
            return libration_problem_branch(of.handle.get(), unknowns.c_str(), conditions.c_str(), along.c_str(),
                                            digits, watch_signals, nullptr, to);
        });
    });
    problem.def("orbit", [](const problem_object& of, long digits) {
        return table(
            [&](auto** to) { return libration_problem_orbit(of.handle.get(), digits, watch_signals, nullptr, to); });
    });
    problem.def("verify", [](const problem_object& of, const std::string& names, const std::string& times,
                             const std::string& values, const std::string& rules) {
        return table([&](auto** to) {
            return libration_problem_verify(of.handle.get(), names.c_str(), times.c_str(), values.c_str(),
                                            rules.c_str(), watch_signals, nullptr, to);
        });
    });
}

// A number reconstructed from its parts, for functions that only the library provides.
class number_object {
public:
    number_object(const std::string& decimal, const std::string& uncertainty, int rigour)
        : handle_(made<owned::number>(
              [&](auto** to) { return libration_number_of(decimal.c_str(), uncertainty.c_str(), rigour, to); })) {}

    double nearest() const {
        double value = 0;
        run([&] { return libration_number_double(handle_.get(), &value); });
        return value;
    }
    std::pair<double, double> bounds() const {
        double lower = 0;
        double upper = 0;
        run([&] { return libration_number_bounds(handle_.get(), &lower, &upper); });
        return {lower, upper};
    }
    auto exact() const { return exact_parts(handle_.get()); }

private:
    owned::number handle_;
};

}  // namespace

PYBIND11_MODULE(_libration, m) {
    m.doc() = "The C interface of Libration; use the package libration.";
    m.def("version", libration_version);
    m.def("read", [](const std::string& text, long digits) {
        return number([&](auto** to) { return libration_number_read(text.c_str(), digits, to); });
    });
    m.def("list_radius", [](const std::string& coefficients, long digits) {
        return table([&](auto** to) { return libration_list_radius(coefficients.c_str(), digits, to); });
    });
    m.def("find_at_infinity", [](const std::string& text, const std::string& unknowns, long digits) {
        return table([&](auto** to) {
            return libration_find_at_infinity(text.c_str(), unknowns.c_str(), digits, watch_signals, nullptr, to);
        });
    });
    m.def("states_at_infinity",
          [](const std::string& text, const std::string& unknowns, const std::string& times, long digits) {
              return known_table([&](auto** to) {
                  return libration_states_at_infinity(text.c_str(), unknowns.c_str(), times.c_str(), digits,
                                                      watch_signals, nullptr, to);
              });
          });
    m.def("eigenvalues", [](const std::string& text, const std::string& energy, long count, long digits) {
        return table([&](auto** to) {
            return libration_eigenvalues(text.c_str(), energy.c_str(), count, digits, watch_signals, nullptr, to);
        });
    });
    m.def("catalogue", [] {
        std::vector<std::pair<std::string, std::string>> all;
        for (std::size_t i = 0; i < libration_catalogue_size(); ++i) {
            all.emplace_back(libration_catalogue_name(i), libration_catalogue_text(i));
        }
        return all;
    });
    py::class_<number_object>(m, "Number")
        .def(py::init<const std::string&, const std::string&, int>())
        .def("nearest", &number_object::nearest)
        .def("bounds", &number_object::bounds)
        .def("exact", &number_object::exact);
    define_motions(m);
    define_problems(m);
    define_solutions(m);
    define_laws(m);
}
