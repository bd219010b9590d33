// Statements of every kind against independent truth.
#pragma once

namespace libration::attack {

/// Asks so many questions, on so many threads (0: one for each core), and prints how the statements of each kind ended
/// as a table in Markdown on stdout, false and undecided ones with the command that shows them on stderr. Question i of
/// a seed is the same whatever the threads and the number of questions. The exit code: 1 where a statement is false, or
/// where a question has no answer after 120 s.
int attack_statements(long questions, unsigned long seed, long threads);

/// Question number i alone.
int attack_statement(long index, unsigned long seed);

}  // namespace libration::attack
