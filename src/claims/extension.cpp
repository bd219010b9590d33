#include "claims/claim.hpp"

namespace libration {

std::vector<claim> claims_of_extension() { return {}; }

}  // namespace libration
