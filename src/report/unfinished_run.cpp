#include "report/unfinished_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/published.hpp"
#include "run/provenance.hpp"
#include "sweep/study_files.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// The versions, and what tells two builds of the same commit apart.
std::string this_program() {
    std::error_code error;
    const fs::path file = fs::read_symlink("/proc/self/exe", error);
    const auto size = fs::file_size(file, error);
    const auto written = fs::last_write_time(file, error).time_since_epoch().count();
    return fmt::format("{}\nof {} bytes, written at {}", version_text(), size, written);
}

}  // namespace

unfinished_run::unfinished_run(const std::string& folder)
    : path_((fs::path(folder) / "unfinished.json").string()), program_(this_program()) {
    if (!fs::exists(path_)) {
        return;
    }
    const auto record = nlohmann::json::parse(text_of(path_), nullptr, false);
    if (record.is_object() && record.value("program", "") == program_ && record.contains("made")) {
        for (const auto& part : record["made"]) {
            made_.insert(part.is_string() ? part.get<std::string>() : "");
        }
    }
}

void unfinished_run::add(const std::string& part) {
    made_.insert(part);
    const nlohmann::ordered_json record{{"program", program_}, {"made", made_}};
    write_into(path_, record.dump(2) + '\n');
}

void unfinished_run::finish() {
    made_.clear();
    std::error_code error;
    fs::remove(path_, error);
}

}  // namespace libration
