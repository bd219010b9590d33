// The modulus and the argument as given, read exactly: shared by the rounded and the proved digits.
#pragma once

#include <string>

#include "libration/elliptic/exact_functions.hpp"
#include "libration/elliptic/given_modulus.hpp"

namespace libration::elliptic {

/// The parameter; throws error of the kind argument if none or two are given, or one outside [0, 1].
exact_parameter exact_parameter_of(const given_modulus& given);

/// The argument of am, sn, cn and dn; throws error of the kind argument for angles in degrees and for times.
exact exact_argument(const std::string& text);

}  // namespace libration::elliptic
