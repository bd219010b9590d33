// The answers about radii and singularities in the columns of the C interface.
#pragma once

#include <string>

#include "handles.hpp"
#include "libration/problem/answer.hpp"

namespace libration::c {

/// The tests of a radius, the verdict first. `usual` is the unknown of an answer about a single one.
libration_table table_of_radii(const answer& found, const std::string& usual);

/// Throws error of the kind undecided for a request of this rigour of which a row is not proved.
libration_table table_of_singularities(const answer& found, int rigour);

}  // namespace libration::c
