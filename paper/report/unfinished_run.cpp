#include "unfinished_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "published.hpp"
#include "reproduce_set.hpp"
#include "run/provenance.hpp"
#include "sweep/study_files.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// The versions, and what distinguishes two builds of the same commit.
std::string this_program() {
    std::error_code error;
    const fs::path file = fs::read_symlink("/proc/self/exe", error);
    const auto size = fs::file_size(file, error);
    const auto written = fs::last_write_time(file, error).time_since_epoch().count();
    return fmt::format("{}\nof {} bytes, written at {}", version_text(), size, written);
}

// The files of a part, relative to the folder of the results.
std::vector<std::string> files_of_part(const fs::path& folder, const std::string& part) {
    const fs::path place = folder / place_of_part(part);
    if (!fs::is_directory(place)) {
        return {place_of_part(part)};
    }
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(place)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().lexically_relative(folder).generic_string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

unfinished_run::unfinished_run(const std::string& folder)
    : folder_(folder), path_((fs::path(folder) / "unfinished.json").string()), program_(this_program()) {
    if (!fs::exists(path_)) {
        return;
    }
    const auto record = nlohmann::json::parse(text_of(path_), nullptr, false);
    if (record.is_object() && record.value("program", "") == program_ && record.contains("made") &&
        record["made"].is_object()) {
        made_ = record["made"].get<std::map<std::string, std::vector<std::string>>>();
    }
}

bool unfinished_run::has(const std::string& part) const {
    const auto found = made_.find(part);
    return found != made_.end() && std::all_of(found->second.begin(), found->second.end(), [&](const auto& file) {
               return fs::is_regular_file(fs::path(folder_) / file);
           });
}

void unfinished_run::add(const std::string& part) {
    made_[part] = files_of_part(folder_, part);
    const nlohmann::ordered_json record{{"program", program_}, {"made", made_}};
    write_into(path_, record.dump(2) + '\n');
}

void unfinished_run::finish() {
    made_.clear();
    std::error_code error;
    fs::remove(path_, error);
}

}  // namespace libration
