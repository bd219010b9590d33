#include "verify/row_writer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace libration {

namespace {

std::string joined(const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        text += (i > 0 ? "," : "") + written_cell(cells[i]);
    }
    return text;
}

}  // namespace

row_writer::row_writer(bool json, separator between, std::vector<std::string> input,
                       const std::vector<std::string>& added)
    : json_(json), between_(between), names_(std::move(input)) {
    const auto own = static_cast<std::ptrdiff_t>(names_.size());
    for (const std::string& name : added) {
        const bool taken = std::find(names_.begin(), names_.begin() + own, name) != names_.begin() + own;
        names_.push_back((taken ? "verify_" : "") + name);
    }
}

std::string row_writer::head() const { return json_ ? "[\n" : joined(names_) + "\n"; }

std::string row_writer::row(const csv_record& record, const std::vector<std::string>& cells,
                            const std::vector<std::string>& added) const {
    if (!json_) {
        const bool as_it_is = between_ == separator::comma && !record.text.empty();
        return (as_it_is ? record.text : joined(cells)) + ',' + joined(added);
    }
    nlohmann::ordered_json object;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const std::string& cell = i < cells.size() ? cells[i] : added[i - cells.size()];
        object[names_[i]] = cell.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(cell);
    }
    return "  " + object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace libration
