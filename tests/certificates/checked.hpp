// What check/libration_check.py, a program in integers for Python's standard library, says about a certificate.
#pragma once

#include <sys/wait.h>
#include <zlib.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace libration::tests {

struct checked_certificate {
    int exit_code = -1;
    std::string out;
};

inline checked_certificate checked(const std::filesystem::path& file) {
    checked_certificate result;
    const std::string line = "python3 -I " LIBRATION_CHECKER " '" + file.string() + "' 2>&1";
    FILE* const pipe = popen(line.c_str(), "r");
    if (pipe == nullptr) {
        return result;
    }
    std::array<char, 4096> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
        result.out.append(part.data(), n);
    }
    const int status = pclose(pipe);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

/// The same about the text of a certificate, written to a file.
inline checked_certificate checked_text(const std::string& text, const std::filesystem::path& file) {
    uLongf size = compressBound(text.size());
    std::string content(size, '\0');
    compress(reinterpret_cast<Bytef*>(content.data()), &size, reinterpret_cast<const Bytef*>(text.data()), text.size());
    std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(size));
    return checked(file);
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace libration::tests
