// What `verify` compares a file with, by its options and by the names of its columns.
#pragma once

#include <memory>

#include "libration/verification/compare_rules.hpp"
#include "problem/motion_options.hpp"
#include "problem/problem_options.hpp"
#include "verify/row_question.hpp"

namespace libration {

/// The problem of --problem; otherwise motions, whose missing numbers are those of the options, or elliptic functions,
/// by the columns of the file. Throws input_error for options that contradict each other, and read() for a file of
/// neither kind. The arguments have to outlive it.
std::unique_ptr<row_subject> row_subject_of(const problem_options& problem, const motion_options& motion,
                                            const compare_rules& rules);

}  // namespace libration
