#include "libration/digits/growing_precision.hpp"

#include "libration/scalar/error.hpp"

namespace libration {

void refuse_undecided(const std::string& subject, long digits) {
    throw error(error_kind::undecided, subject, "", "is not decided by " + std::to_string(digits) + " digits");
}

}  // namespace libration
