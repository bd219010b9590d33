// What `libration series` finds: values, errors against the order, poles and zeros, ratios and roots of the list.
#pragma once

#include "list_request.hpp"
#include "text/table.hpp"

namespace libration {

/// time,method,order,value,reference,error,time_typed: a row for each time and method, of the whole list, each value
/// right to one unit in its last digit as a function of the numbers in the list. Empty where a Pade approximant has a
/// pole. Cost: O(N^3) for Pade approximants, in two precisions.
table list_values(const list_request& request);

/// time,method,order,error,log10_error for at most 40 orders up to N. Without rows where there is no reference.
table list_errors(const list_request& request);

/// The poles and zeros of a Pade approximant (poles_of).
table list_poles(const list_request& request);

/// What Domb-Sykes and root plots draw (ratios_of).
table list_ratios(const list_request& request);

/// The tests of the radius of convergence of the list (tests_of), the verdict first.
table list_radius(const list_request& request);

}  // namespace libration
