#include "run/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <stdexcept>

namespace libration {

std::array<std::uint8_t, 32> sha256_digest(std::string_view bytes) {
    std::array<std::uint8_t, 32> digest{};
    unsigned int length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1 ||
        length != digest.size()) {
        throw std::runtime_error("OpenSSL computes no SHA-256 here: its configuration has no provider of it");
    }
    return digest;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string digits;
    for (const auto byte : bytes) {
        digits += fmt::format("{:02x}", byte);
    }
    return digits;
}

std::string sha256(std::string_view bytes) { return hexadecimal(sha256_digest(bytes)); }

}  // namespace libration
