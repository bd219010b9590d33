// Values of motions of the pendulum and of elliptic functions against independent routes.
#pragma once

namespace libration::attack {

/// So many random values, on so many threads (0: one for each core); wrong and refused ones on stderr. The exit code: 1
/// where there is one.
int attack_motions(long values, unsigned long seed, long threads);

/// Values as CSV for by_integers.py.
int print_motions(long values);

}  // namespace libration::attack
