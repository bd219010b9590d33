// Statements of every kind compared with independent true values.
#pragma once

namespace libration::attack {

/// Runs this number of questions, on so many threads (0: one per core), and prints the verdicts on the statements of
/// each kind as a table in Markdown on stdout, false and undecided ones with the command that reproduces them on
/// stderr. Question i of a seed does not depend on the threads and the number of questions. Returns the exit code: 1 if
/// a statement is false, or if a question takes more than 120 s.
int attack_statements(long questions, unsigned long seed, long threads);

/// Question number i alone.
int attack_statement(long index, unsigned long seed);

}  // namespace libration::attack
