#include "claims/claim.hpp"

namespace libration {

std::vector<claim> claims_of_resummation() { return {}; }

}  // namespace libration
