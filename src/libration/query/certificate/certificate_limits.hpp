// The limits of certificates (docs/certificates.md), so that none is written that the programs that check reject.
#pragma once

#include <cstddef>
#include <string>

namespace libration::ode {

inline constexpr std::size_t most_certified_unknowns = 200;  // with derivatives and added ones
inline constexpr std::size_t most_certified_definitions = 100;
inline constexpr std::size_t most_certified_claims = 10'000;
inline constexpr std::size_t most_certified_zeros = 10'000;
inline constexpr std::size_t longest_certified_formula = 100'000;
inline constexpr long most_certified_bits = 10'000;

/// Throws error of the kind argument and the subject "certificate": "`what`: `remedy`".
[[noreturn]] void refuse_certificate(const std::string& what, const std::string& remedy);

/// The same if there are more than `most` of something.
void require_at_most(std::size_t count, std::size_t most, const std::string& what);

/// The same for the name of a variable or an unknown that cannot be one in a certificate: of a function, pi, _1, or not
/// of ASCII letters, digits and _.
void require_certified_name(const std::string& name);

/// The same for a formula that is too long, too deep, or has integers of too many digits.
void require_certified_formula(const std::string& text);

}  // namespace libration::ode
