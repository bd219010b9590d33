// What `libration series` finds: values, errors against the order, poles and zeros, ratios and roots of the list.
#pragma once

#include "list/list_request.hpp"
#include "text/table.hpp"

namespace libration {

/// time,method,order,value,reference,error,time_typed: a row for each time and method, of the whole list, each value
/// right to one unit in its last digit as a function of the numbers in the list. Empty where a Pade approximant has a
/// pole. Cost: O(N^3) for Pade approximants, in two precisions.
table list_values(const list_request& request);

/// time,method,order,error,log10_error for at most 40 orders up to N. Without rows where there is no reference.
table list_errors(const list_request& request);

/// kind,position_re,position_im,modulus,distance: the poles and zeros of the Pade approximant [L/M], M = N/2 or as much
/// less as determines it, by growing modulus; of conjugate ones that with im > 0. `distance` is the one to the nearest
/// of the other kind: where it is small, both are an artefact of rounding (Froissart).
table list_poles(const list_request& request);

/// n,inverse_n,ratio,root,corrected_root,power,ratio_in_power: what Domb-Sykes and root plots draw, a_n/a_(n-1),
/// |a_n|^(1/n), |n a_n|^(1/n), the power p of t in which the list behind a_0 is a series, and a_n/a_(n-p), without a_0
/// where p > 1; empty where they do not exist.
table list_ratios(const list_request& request);

}  // namespace libration
