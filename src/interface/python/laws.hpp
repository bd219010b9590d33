// The law of all Taylor coefficients of a solution, in Python.
#pragma once

#include "calls.hpp"

namespace libration::python {

inline void define_laws(py::module_& m) {
    py::class_<law_object> law(m, "Law");
    law.def(py::init(
        [](const problem_object& of, const std::optional<std::string>& show, const std::optional<std::string>& within) {
            return law_object{made<owned::law>([&](auto** to) {
                return libration_law_new(of.handle.get(), optional_text(show), optional_text(within), watch_signals,
                                         nullptr, to);
            })};
        }));
    law.def("rho", [](const law_object& of) { return libration_law_rho(of.handle.get()); });
    law.def("first", [](const law_object& of) { return libration_law_first(of.handle.get()); });
    law.def("stride", [](const law_object& of) { return libration_law_stride(of.handle.get()); });
    law.def("residue", [](const law_object& of) { return libration_law_residue(of.handle.get()); });
    law.def("singularities", [](const law_object& of, long digits) {
        return table([&](auto** to) { return libration_law_singularities(of.handle.get(), digits, to); });
    });
    law.def("coefficient", [](const law_object& of, long n, long digits) {
        return number([&](auto** to) { return libration_law_coefficient(of.handle.get(), n, digits, to); });
    });
    law.def("ratio", [](const law_object& of, long n, long digits) {
        return number([&](auto** to) { return libration_law_ratio(of.handle.get(), n, digits, to); });
    });
    law.def("words", [](const law_object& of) {
        return table([&](auto** to) { return libration_law_words(of.handle.get(), to); });
    });
}

}  // namespace libration::python
