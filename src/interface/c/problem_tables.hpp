// The tables of radii and singularities in the C interface.
#pragma once

#include <string>
#include <vector>

#include "handles.hpp"
#include "libration/problem/series_request.hpp"

namespace libration::c {

/// The results for several lists, the verdict of the nearest first and then all of each; to at most this number of
/// digits.
libration_table table_of_radii(const std::vector<unknown_series>& unknowns, long digits);

/// Of the unknowns of a system, from coefficients 0 .. last about its initial point.
libration_table radius_table(const ode::explicit_system& system, long last, long digits);

/// The singularities within a distance of the initial point, "" for twice the nearest, and whether the whole disc was
/// searched.
struct found_singularities {
    libration_table table;
    bool complete;
};
found_singularities singularity_table(const ode::explicit_system& system, const std::string& within, long digits,
                                      bool proved);

}  // namespace libration::c
