// What can be seen in coefficients a_0 .. a_N: the poles and zeros of a Pade approximant, ratios and roots.
#pragma once

#include "libration/approximant/pade.hpp"
#include "libration/problem/answer.hpp"
#include "libration/series/power_series.hpp"
#include "text/table.hpp"

namespace libration {

/// The digits in which poles_of and ratios_of compute, for coefficients that are rounded to them.
long digits_for_poles(long digits, int order);
long digits_for_ratios(long digits);

/// [L/M] with L + M = N and M = N/2, or the next smaller M whose equations are not singular.
pade_approximant<mpfr> pade_of_list(const series::power_series<mpfr>& a);

/// kind,position_re,position_im,modulus,distance: the poles and zeros of pade_of_list, by growing modulus; of conjugate
/// ones that with im > 0. `distance` is the one to the nearest of the other kind: where it is small, both are an
/// artefact of rounding (Froissart).
table poles_of(const series::power_series<mpfr>& a, long digits);

/// n,inverse_n,ratio,root,corrected_root,power,ratio_in_power,pair_ratio: what Domb-Sykes and root plots draw,
/// a_n/a_(n-1), |a_n|^(1/n), |n a_n|^(1/n), the power p of t in which the list behind a_0 is a series, a_n/a_(n-p),
/// without a_0 where p > 1, and for a pair of singularities (D_n/D_(n-p))^(1/2) with D_n = a_(n+p) a_(n-p) - a_n^2
/// [MercerRoberts1990]; empty where they do not exist.
table ratios_of(const series::power_series<mpfr>& a, long digits);

/// The columns of a radius_answer without the remarks: tests of the radius, the verdict first.
table tests_of(const answer& found);

}  // namespace libration
