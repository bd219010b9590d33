// Catch2 3 under the one header that Catch2 2 has: in the path of includes where the former is found.
#pragma once

#include <catch2/catch_all.hpp>

#include <string>

namespace Catch {

inline auto Contains(const std::string& part) { return Matchers::ContainsSubstring(part); }
using Matchers::Equals;
using Matchers::MatcherBase;
using Matchers::WithinRel;

}  // namespace Catch

using Catch::Approx;
