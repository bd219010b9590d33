// Readers of numbers, of lists and ranges, and of the name of an arithmetic: each throws libration::error or returns a
// number whose decimal or fraction is read as the same number.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "libration/number/exact.hpp"
#include "libration/number/grid.hpp"
#include "libration/number/written_number.hpp"
#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/error.hpp"

namespace {

using namespace libration;

template <class Read>
void read_or_refuse(const Read& read) {
    try {
        read();
    } catch (const error&) {
    }
}

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    read_or_refuse([&] {
        const exact number = read_exact(text);
        if (number.is_fraction()) {
            require(read_exact(number.coefficient.str()).coefficient == number.coefficient);
        }
    });
    read_or_refuse([&] {
        const exact number = read_typed(text);
        if (number.is_fraction()) {
            require(read_exact(number.coefficient.str()).coefficient == number.coefficient);
        }
    });
    read_or_refuse([&] { require(read_written(text).value == read_typed(text).coefficient); });
    read_or_refuse([&] { require(read_digits(text) > 0); });
    read_or_refuse([&] { require(!read_scalar(text, arithmetics::proved_too).name().empty()); });
    read_or_refuse([&] { require(read_count(text, 1000) <= 1000); });
    if (text.size() < 40 && text.find(':') == std::string::npos) {  // ranges of millions take long
        read_or_refuse([&] { require(!read_grid(text).empty()); });
    }
    return 0;
}
