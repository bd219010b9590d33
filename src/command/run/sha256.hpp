// The fingerprint of a file, as sha256sum prints it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace libration {

/// SHA-256 of the bytes [FIPS 180-4, section 6.2].
std::array<std::uint8_t, 32> sha256_digest(std::string_view bytes);

/// Two digits a byte.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

/// The digest in 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace libration
