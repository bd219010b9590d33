// What `libration series` finds: values, errors against the order, poles and zeros, ratios and roots of the list.
#pragma once

#include "list_request.hpp"
#include "text/table.hpp"

namespace libration {

/// time,method,order,value,reference,error,time_typed,uncertainty,methods,note: first, for each time, the verdict: the
/// value of the function by the methods that agree (convergence/sum.hpp), with the digits that its uncertainty leaves,
/// empty with the reason in `note` if no digit is certain. Then a row for each method and time, of the whole list: each
/// value right to one unit in its last digit as a function of the numbers in the list, its uncertainty the largest
/// change by the last two coefficients that are not 0. Empty where a Pade approximant has a pole. Cost: O(N^3) for Pade
/// approximants, in two precisions.
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
