#include "sweep/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "run/child_program.hpp"
#include "run/program_files.hpp"
#include "run/stream_content.hpp"
#include "sweep/image.hpp"
#include "text/input_error.hpp"
#include "text/table.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// gnuplot string literals in single quotes double the quote.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? "''" : std::string(1, c);
    }
    return result + "'";
}

fs::path script_of(const std::string& name) {
    if (!fs::is_directory(studies_folder())) {
        throw input_error(
            fmt::format("figures need gnuplot and the scripts of Libration, but {} does not exist: run "
                        "without --out, or install Libration with its scripts",
                        studies_folder()));
    }
    const std::string file = name + ".gp";
    for (const auto& each : fs::recursive_directory_iterator(studies_folder())) {
        if (each.path().filename() == file) {
            return each.path();
        }
    }
    throw std::runtime_error(fmt::format("{} holds no {}", studies_folder(), file));
}

std::vector<fs::path> figures_in(const std::string& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (is_figure(entry.path().filename().string())) {
            found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

// The names of its tables, by which a script finds out which of them exist.
std::string tables_in(const std::string& folder) {
    std::string names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".csv") {
            names += entry.path().filename().string() + " ";
        }
    }
    return names;
}

void run_gnuplot(const std::string& name, const script_variables& variables, const std::vector<std::string>& kinds,
                 const std::string& folder) {
    const fs::path script = script_of(name);
    std::string setting = fmt::format("cd {}; data = '.'; target = '.'; tables = {}; scripts = {}; terminals = {}",
                                      quoted(folder), quoted(tables_in(folder)), quoted(studies_folder()),
                                      quoted(fmt::format("{}", fmt::join(kinds, " "))));
    for (const auto& [variable, text] : variables) {
        setting += fmt::format("; {} = {}", variable, quoted(text));
    }
    const int code = run_program({"gnuplot", "-e", setting, script.string()});
    if (code == 127) {
        throw input_error("gnuplot is not installed: install the Debian package gnuplot-nox");
    }
    if (code != 0) {
        throw std::runtime_error(fmt::format("gnuplot could not draw {}", script.string()));
    }
}

void finish(const fs::path& figure) {
    std::ifstream file(figure, std::ios::binary);
    const std::string content = content_of(file, figure.filename().string());
    const std::string extension = figure.extension().string();
    if (!is_whole_image(extension, content)) {
        throw std::runtime_error(figure.filename().string() + " was cut short while it was drawn: is the disk full?");
    }
    try {
        write_whole_file(figure.string(), finished_image(extension, content));
    } catch (const std::runtime_error& problem) {
        throw std::runtime_error(fmt::format("{} cannot be written ({})", figure.filename().string(), problem.what()));
    }
}

// Checks that each figure exists in all of the kinds.
void require_all_kinds(const std::string& script, const std::vector<std::string>& kinds,
                       const std::vector<fs::path>& figures) {
    for (const std::string& kind : kinds) {
        const auto own = [&](const fs::path& each) { return each.extension() == "." + kind; };
        const auto count = std::count_if(figures.begin(), figures.end(), own);
        if (count == 0 || static_cast<std::size_t>(count) * kinds.size() != figures.size()) {
            throw std::runtime_error(fmt::format("gnuplot did not draw every .{} of {}", kind, script));
        }
    }
}

}  // namespace

const std::vector<std::string>& figure_kinds() {
    static const std::vector<std::string> kinds{"svg", "pdf", "png"};
    return kinds;
}

bool is_figure(const std::string& file) {
    const std::string extension = fs::path(file).extension().string();
    return std::ranges::any_of(figure_kinds(), [&](const std::string& kind) { return extension == "." + kind; });
}

std::string studies_folder() {
    return runs_from_build_folder() ? LIBRATION_STUDIES_DIR : path_from_program(LIBRATION_INSTALLED_STUDIES_DIR);
}

void draw_by_script(const std::string& script, const script_variables& variables, const std::vector<std::string>& kinds,
                    const std::string& folder) {
    try {
        run_gnuplot(script, variables, kinds, folder);
        const auto figures = figures_in(folder);
        require_all_kinds(script, kinds, figures);
        std::for_each(figures.begin(), figures.end(), finish);
    } catch (const std::exception&) {
        for (const fs::path& figure : figures_in(folder)) {
            fs::remove(figure);
        }
        throw;
    }
}

void draw_figures(const study& what, const std::string& folder) {
    draw_by_script(what.script.empty() ? what.name : what.script,
                   {{"stem", what.name}, {"equation", what.equation ? what.equation->name : ""}}, figure_kinds(),
                   folder);
}

}  // namespace libration
