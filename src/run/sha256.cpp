#include "run/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace libration {

std::string sha256(std::string_view bytes) {
    std::array<unsigned char, 32> digest{};
    unsigned int length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1 ||
        length != digest.size()) {
        throw std::runtime_error("OpenSSL computes no SHA-256 here: its configuration has no provider of it");
    }
    std::string digits;
    for (const unsigned char byte : digest) {
        digits += fmt::format("{:02x}", byte);
    }
    return digits;
}

}  // namespace libration
