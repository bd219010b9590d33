// Values of motions of the pendulum and of elliptic functions against independent routes.
#pragma once

namespace libration::attack {

/// Checks this number of random values, on so many threads (0: one per core); wrong ones and errors are printed on
/// stderr. Returns the exit code: 1 if there are any.
int attack_motions(long values, unsigned long seed, long threads);

/// Values as CSV for by_integers.py.
int print_motions(long values);

}  // namespace libration::attack
