// Handles of the C interface that free themselves, for callers in C++.
#pragma once

#include <libration.h>

#include <memory>

namespace libration::owned {

template <class Handle, void (*free)(Handle*)>
struct freeing {
    void operator()(Handle* handle) const { free(handle); }
};
template <class Handle, void (*free)(Handle*)>
using handle = std::unique_ptr<Handle, freeing<Handle, free>>;

using number = handle<libration_number, libration_number_free>;
using table = handle<libration_table, libration_table_free>;
using motion = handle<libration_motion, libration_motion_free>;
using problem = handle<libration_problem, libration_problem_free>;
using solution = handle<libration_solution, libration_solution_free>;
using law = handle<libration_law, libration_law_free>;
using sampler = handle<libration_sampler, libration_sampler_free>;
using steps = handle<libration_steps, libration_steps_free>;

}  // namespace libration::owned
