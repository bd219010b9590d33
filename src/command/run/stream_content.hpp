// All that a stream holds.
#pragma once

#include <array>
#include <istream>
#include <limits>
#include <stdexcept>
#include <string>

namespace libration {

/// What is left of a stream, in large pieces: an iterator over its characters takes ten times as long. Of a stream with
/// more than `most` characters more than `most` are returned, not all. Throws std::runtime_error where reading fails,
/// with the name.
inline std::string content_of(std::istream& stream, const std::string& name,
                              std::size_t most = std::numeric_limits<std::size_t>::max()) {
    std::string content;
    std::array<char, 1 << 16> piece{};
    while (content.size() <= most && (stream.read(piece.data(), piece.size()) || stream.gcount() > 0)) {
        content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) {
        throw std::runtime_error(name + " cannot be read");
    }
    return content;
}

}  // namespace libration
