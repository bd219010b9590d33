#include "sweep/study_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "option/options.hpp"
#include "run/child_program.hpp"
#include "run/provenance.hpp"
#include "text/input_error.hpp"
#include "text/latex.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

std::string stem_of(const study& what, const study_table& part) {
    return part.suffix.empty() ? what.name : what.name + "_" + part.suffix;
}

std::string description_of(const study_order& order, const std::vector<study_table>& tables) {
    nlohmann::ordered_json description;
    description["study"] = order.what->name;
    description["question"] = order.what->question;
    description["command"] = order.command;
    if (!order.left_out.empty()) {
        description["left out"] = order.left_out;
    }
    for (const column& c : tables.front().data.columns()) {
        description["columns"][c.name] = c.meaning;
    }
    for (const study_table& part : tables) {
        nlohmann::ordered_json entry{{"file", stem_of(*order.what, part) + ".csv"},
                                     {"scalar", part.scalar.name()},
                                     {"digits", part.scalar.digits},
                                     {"rows", part.data.rows().size()}};
        if (&part != &tables.front()) {
            for (const column& c : part.data.columns()) {
                entry["columns"][c.name] = c.meaning;
            }
        }
        if (part.timed) {
            entry["note"] = "times of the machine that made it";
        }
        description["tables"].push_back(std::move(entry));
    }
    description["note"] =
        "mpfr tables depend on the parameters alone; in the others libm may move the last digit from machine to "
        "machine";
    for (const auto& [name, version] : provenance()) {
        description["made with"][name] = version;
    }
    return description.dump(2) + '\n';
}

// gnuplot string literals in single quotes double the quote.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? "''" : std::string(1, c);
    }
    return result + "'";
}

}  // namespace

void write_into(const std::string& path, const std::string& content) {
    try {
        write_whole_file(path, content);
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", path, fmt::format("cannot be written ({})", problem.what()),
                          "choose a folder that you may write in");
    }
}

std::string studies_folder() {
    if (fs::exists(LIBRATION_STUDIES_DIR)) {
        return LIBRATION_STUDIES_DIR;
    }
    std::error_code error;
    return (fs::read_symlink("/proc/self/exe", error).parent_path() / LIBRATION_INSTALLED_STUDIES_DIR).string();
}

void write_study(const study_order& order, const std::string& folder) {
    if (folder.empty()) {
        throw input_error("--out", folder, "is no folder", "name one");
    }
    output_folder into("--out", (fs::path(folder) / order.what->name).string());
    const std::string& own = into.path();
    const auto tables = tables_of(order);
    into.keep();
    for (const study_table& part : tables) {
        const std::string stem = stem_of(*order.what, part);
        write_into((fs::path(own) / (stem + ".csv")).string(), to_csv(part.data));
        write_into((fs::path(own) / (stem + ".tex")).string(),
                   to_latex(part.data, {latex_text(order.what->title + ". Made by " + order.command + "."), stem}));
    }
    write_into((fs::path(own) / (order.what->name + ".json")).string(), description_of(order, tables));
}

namespace {

// NAME.gp, in one of the folders of studies/.
fs::path script_of(const study& what) {
    for (const auto& folder : fs::directory_iterator(studies_folder())) {
        const fs::path script = folder.path() / (what.name + ".gp");
        if (fs::exists(script)) {
            return script;
        }
    }
    throw std::runtime_error(fmt::format("{} holds no {}.gp", studies_folder(), what.name));
}

}  // namespace

void draw_study(const study& what, const std::string& folder) {
    const fs::path own = fs::path(folder) / what.name;
    const fs::path script = script_of(what);
    if (!fs::exists(own / (what.name + ".csv"))) {
        throw input_error("--out", folder, "holds no " + what.name + "/" + what.name + ".csv",
                          "run 'libration study " + what.name + "' with the same --out first");
    }
    const output_folder into("--out", own.string());
    // Figures are drawn beside and moved onto their names when all of them are whole.
    const fs::path beside = own / fmt::format(".drawing.{}", ::getpid());
    fs::create_directories(beside);
    const std::string setting = fmt::format("data = {}; target = {}; scripts = {}", quoted(own.string()),
                                            quoted(beside.string()), quoted(studies_folder()));
    const int code = run_program({"gnuplot", "-e", setting, script.string()});
    if (code == 0) {
        for (const auto& entry : fs::directory_iterator(beside)) {
            fs::rename(entry.path(), own / entry.path().filename());
        }
    }
    fs::remove_all(beside);
    if (code == 127) {
        throw input_error("gnuplot is not installed: install the Debian package gnuplot-nox");
    }
    if (code != 0) {
        throw std::runtime_error(fmt::format("gnuplot could not draw {}", script.string()));
    }
}

const study& study_named(std::string_view option, std::string_view name) {
    const auto studies = all_studies();
    const auto found =
        std::find_if(studies.begin(), studies.end(), [&](const study* candidate) { return candidate->name == name; });
    if (found != studies.end()) {
        return **found;
    }
    std::string names;
    for (const study* candidate : studies) {
        names += (names.empty() ? "" : ", ") + candidate->name;
    }
    throw input_error(std::string(option), std::string(name), "is not a study", "choose one of " + names);
}

}  // namespace libration
