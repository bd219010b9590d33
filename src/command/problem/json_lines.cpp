#include "json_lines.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace libration {

namespace {

// Collects cells without turning a number into a double.
class line_collector : public nlohmann::json_sax<nlohmann::json> {
public:
    bool null() override { return take(""); }
    bool boolean(bool) override { return refuse("a truth value"); }
    bool number_integer(number_integer_t value) override { return take(std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return take(std::to_string(value)); }
    bool number_float(number_float_t, const string_t& written) override { return take(written); }
    bool string(string_t& value) override { return take(value); }
    bool binary(binary_t&) override { return refuse("binary data"); }
    bool start_array(std::size_t) override {
        pairs_ = pairs_ || depth_ == 1;
        return open();
    }
    bool end_array() override {
        if (depth_ == 2 && cells_.size() != 2) {
            refuse("an array that is not a pair");
        }
        return close();
    }
    bool start_object(std::size_t) override {
        objects_ = true;
        return depth_ == 0 ? refuse("no array") : open();
    }
    bool end_object() override { return close(); }
    bool key(string_t& name) override {
        if (rows_ == 0) {
            header_.push_back(name);
        } else if (cells_.size() >= header_.size() || header_[cells_.size()] != name) {
            return refuse("objects with other keys than the first");
        }
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) override {
        throw std::runtime_error("is not JSON at character " + std::to_string(position));
    }

    std::string text() const {
        return (objects_ ? joined(header_) : pairs_ ? std::string("re,im\n") : std::string()) + lines_;
    }

private:
    static std::string joined(const std::vector<std::string>& cells) {
        std::string line;
        for (const auto& each : cells) {
            line += (line.empty() ? "" : ",") + each;
        }
        return line + "\n";
    }
    [[noreturn]] bool refuse(const std::string& what) const {
        throw std::runtime_error("has " + what + " in row " + std::to_string(rows_ + 1));
    }
    bool take(const std::string& cell) {
        if (cell.find_first_of(",;\n\"") != std::string::npos) {
            refuse("a string that is not a number");
        }
        cells_.push_back(cell);
        return depth_ == 1 ? end_row() : true;
    }
    bool open() {
        if (++depth_ > 2) {
            refuse("an array in an array");
        }
        return true;
    }
    bool close() { return --depth_ == 1 ? end_row() : true; }
    bool end_row() {
        lines_ += joined(cells_);
        cells_.clear();
        ++rows_;
        return true;
    }

    std::vector<std::string> header_, cells_;
    std::string lines_;
    std::size_t rows_ = 0;
    int depth_ = 0;
    bool objects_ = false, pairs_ = false;
};

}  // namespace

std::string lines_of_json(const std::string& text) {
    line_collector lines;
    nlohmann::json::sax_parse(text, &lines);
    return lines.text();
}

}  // namespace libration
