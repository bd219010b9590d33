#include "libration/scalar/vector_instructions.hpp"

#include <hwy/highway.h>

#include <cstdint>

#include "libration/scalar/error.hpp"

namespace libration {

std::vector<std::string> vector_instructions() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        names.emplace_back(hwy::TargetName(target));
    }
    return names;
}

vector_instructions_scope::vector_instructions_scope(const std::string& name) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name == hwy::TargetName(target)) {
            hwy::GetChosenTarget().Update(target);
            return;
        }
    }
    throw error(error_kind::argument, "vector instructions", name, "are not among those of this processor");
}

vector_instructions_scope::~vector_instructions_scope() { hwy::GetChosenTarget().DeInit(); }

}  // namespace libration
