// The columns that a verdict on a list has in addition to those of every test, and its description in words.
#pragma once

#include <string>
#include <vector>

#include "libration/convergence/radius_answers.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// bound, gevrey, action, action_uncertainty, suspect, suspect_predicted, suspect_uncertainty, prediction, history, ring.
std::vector<std::string> verdict_columns();

/// Their values, with at most so many digits; of a list in powers of the root-th root of the variable. history and ring
/// are JSON arrays of objects: {order, radius, uncertainty}, {position_re, position_im, uncertainty, exponent,
/// exponent_uncertainty, kind}.
std::vector<answer_value> values_of(const convergence::list_verdict& verdict, long digits, int root);

/// "0", "inf", or the radius as printed otherwise.
std::string radius_text(const convergence::list_verdict& verdict, const std::string& printed);

/// The notes below the radius: the growth, the action, the exponent at a known place, a suspect coefficient, how the last
/// coefficient was predicted.
std::vector<answer_note> notes_of(const convergence::list_verdict& verdict, const request& how);

}  // namespace libration
