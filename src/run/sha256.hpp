// The fingerprint of a file, as sha256sum prints it.
#pragma once

#include <string>
#include <string_view>

namespace libration {

/// SHA-256 of the bytes [FIPS 180-4, section 6.2] in 64 hexadecimal digits, by OpenSSL; throws std::runtime_error where
/// its configuration provides none.
std::string sha256(std::string_view bytes);

}  // namespace libration
