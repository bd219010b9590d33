// CSV files as records and cells: records that were read are written and read again without a change.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "text/csv_records.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
    libration::csv_records records(file);
    long line = 0;
    while (const auto record = records.next()) {
        if (record->line <= line) {
            std::abort();
        }
        line = record->line;
        const auto cells = libration::cells_of(record->text);
        if (!cells) {
            continue;
        }
        std::string written;
        for (const std::string& cell : *cells) {
            written += (written.empty() && &cell == &cells->front() ? "" : ",") + libration::written_cell(cell);
        }
        if (libration::cells_of(written) != cells) {
            std::abort();
        }
    }
    return 0;
}
