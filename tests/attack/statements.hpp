// Statements of every kind compared with independent true values.
#pragma once

#include <string>

namespace libration::attack {

/// Of this number of questions, runs those of one kind (all, if it is empty), on so many threads (0: one per core), and
/// prints the verdicts on the statements of each kind as a table in Markdown on stdout, false and undecided ones with
/// the command that reproduces them on stderr. Question i of a seed does not depend on the other arguments. Returns the
/// exit code: 1 if a statement is false, or if a question takes more than 120 s; 2 if there is no such kind.
int attack_statements(long questions, unsigned long seed, long threads, const std::string& kind);

/// Question number i alone.
int attack_statement(long index, unsigned long seed);

}  // namespace libration::attack
