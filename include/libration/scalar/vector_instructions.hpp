// The vector instructions of the processor, selected at run time [Highway].
#pragma once

#include <string>
#include <vector>

namespace libration {

/// The instruction sets that this processor has and the library is compiled for, best first, by their Highway names:
/// AVX3 is AVX-512, SCALAR is without vectors. Compiled only in the target libration::libration.
std::vector<std::string> vector_instructions();

/// While it exists, these instructions are used, in all threads; one scope at a time. For comparing them. Throws error
/// of the kind argument for a name that is not among vector_instructions().
class vector_instructions_scope {
public:
    explicit vector_instructions_scope(const std::string& name);
    vector_instructions_scope(const vector_instructions_scope&) = delete;
    vector_instructions_scope& operator=(const vector_instructions_scope&) = delete;
    ~vector_instructions_scope();
};

}  // namespace libration
