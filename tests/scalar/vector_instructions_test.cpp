#include "libration/scalar/vector_instructions.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace scalar_vector_instructions_test {

using namespace libration;

TEST_CASE("vector instructions are chosen by their name", "[scalar]") {
    const std::vector<std::string> names = vector_instructions();
    REQUIRE_FALSE(names.empty());
    CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
    CHECK_THROWS_WITH(vector_instructions_scope("AVX-7"),
                      "vector instructions 'AVX-7' are not among those of this processor");
}

}  // namespace scalar_vector_instructions_test
