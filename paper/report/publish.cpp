#include "publish.hpp"

#include <unistd.h>

#include <filesystem>

#include "option/options.hpp"
#include "report.hpp"
#include "reproduce_set.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// Copies to a temporary directory, then exchanges it with the old one, so that an interruption never leaves half of it.
// Journals remain in the directory of the run.
void replace(const fs::path& from, const fs::path& target) {
    const std::string own = "." + target.filename().string() + "." + std::to_string(::getpid());
    const fs::path beside = target.parent_path() / (own + ".part");
    const fs::path old = target.parent_path() / (own + ".old");
    fs::copy(from, beside, fs::copy_options::recursive);
    if (fs::is_directory(beside)) {
        fs::remove(beside / (from.filename().string() + ".journal"));
    }
    if (fs::exists(target)) {
        fs::rename(target, old);
    }
    fs::rename(beside, target);
    fs::remove_all(old);
}

}  // namespace

void publish(const std::string& made, const std::string& published, const std::vector<std::string>& parts) {
    output_folder into("--results", published);
    for (const std::string& part : parts) {
        const std::string name = place_of_part(part);
        if (fs::exists(fs::path(made) / name)) {
            replace(fs::path(made) / name, fs::path(published) / name);
            into.keep();
        }
    }
    write_report(published);
}

}  // namespace libration
