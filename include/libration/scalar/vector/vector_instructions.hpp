// The vector instructions of the processor, among which a program chooses where it runs [Highway].
#pragma once

#include <string>
#include <vector>

namespace libration {

/// The sets of instructions that this processor has and the library is compiled for, the best first, in the words of
/// Highway: AVX3 is AVX-512, SCALAR no vectors. Compiled: in the target libration::libration alone.
std::vector<std::string> vector_instructions();

/// While it lives, these instructions are taken, in all threads; one scope at a time. To compare them. Throws error of
/// the kind argument for what is not among vector_instructions().
class vector_instructions_scope {
public:
    explicit vector_instructions_scope(const std::string& name);
    vector_instructions_scope(const vector_instructions_scope&) = delete;
    vector_instructions_scope& operator=(const vector_instructions_scope&) = delete;
    ~vector_instructions_scope();
};

}  // namespace libration
