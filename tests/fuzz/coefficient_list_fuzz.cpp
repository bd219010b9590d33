// Lists of coefficients: the reader returns the coefficients, or throws an error that names a line of the text.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "libration/convergence/coefficient_list.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        libration::convergence::coefficient_reader().read(text);
    } catch (const libration::convergence::malformed_line& problem) {
        const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
        if (problem.number() < 1 || problem.number() > lines) {
            std::abort();
        }
    } catch (const libration::error&) {
    }
    return 0;
}
