#include "certificate_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "libration/scalar/ball/predicates.hpp"

namespace libration {

std::string text_of_certificate(const ode::explicit_system& system, const ode::certified_statement& statement,
                                const rational& farthest, long digits, const request& how) {
    const auto whole = farthest.convert_to<double>();
    return ode::certificate_of(system, statement, digits, [&](const ball& reached, long bits) {
        const auto time = midpoint_of(reached).convert_to<double>();
        if (how.reached) {
            how.reached(time, bits);
        }
        if (how.progress) {
            how.progress(whole == 0 ? 0 : std::clamp(time / whole, 0.0, 1.0));
        }
    });
}

namespace {

// The checkers read at most so many, and so long ones.
constexpr std::size_t most_notes = 100;
constexpr std::size_t longest_note = 1000;

std::string with_notes(const std::string& text, const certificate_notes& notes) {
    std::string lines;
    for (std::size_t k = 0; k < std::min(notes.size(), most_notes); ++k) {
        std::string note = notes[k].substr(0, longest_note);
        std::ranges::replace_if(
            note, [](char c) { return c < ' ' || c > '~'; }, '?');
        lines += note.empty() ? "" : "note " + note + "\n";
    }
    return std::string(text).insert(text.find('\n') + 1, lines);
}

}  // namespace

std::string compressed_certificate(const std::string& plain, const certificate_notes& notes) {
    const std::string text = with_notes(plain, notes);
    uLongf size = compressBound(text.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                  text.size(), Z_BEST_COMPRESSION) != Z_OK) {
        throw std::runtime_error("zlib does not compress a text in memory");
    }
    result.resize(size);
    return result;
}

}  // namespace libration
