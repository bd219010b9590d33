#include "plot/figure_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "run/progress.hpp"
#include "run/working_folder.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

constexpr const char* drawn_name = "figure";

working_folder folder_next_to(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    try {
        return working_folder(parent.empty() ? "." : parent.string());
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", path, fmt::format("cannot be written ({})", problem.what()),
                          "choose a writable directory");
    }
}

using greek_letter = std::pair<std::string_view, std::string_view>;
constexpr std::array<greek_letter, 21> greek_letters{
    {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"},  {"eta", "η"},
     {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},      {"xi", "ξ"},    {"rho", "ρ"},
     {"sigma", "σ"}, {"tau", "τ"},   {"phi", "φ"},    {"chi", "χ"},   {"psi", "ψ"},     {"omega", "ω"}, {"pi", "π"}}};

std::string with_greek_letter(const std::string& word) {
    const auto found = std::ranges::find(greek_letters, word, &greek_letter::first);
    return found == greek_letters.end() ? word : std::string(found->second);
}

}  // namespace

figure_file::figure_file(const std::optional<std::string>& out) {
    const std::string remedy = "write FILE.svg, FILE.pdf or FILE.png, or FILE for all three";
    if (!out) {
        throw input_error("--plot draws a file: add --out FILE.svg, FILE.pdf or FILE.png, or FILE for all three");
    }
    const fs::path given(*out);
    const std::string ending = given.extension().string();
    const bool named = given.has_filename() && given.filename() != "." && given.filename() != "..";
    if (!named || (!ending.empty() && !is_figure(*out))) {
        throw input_error("--out", *out, "is not the name of a figure", remedy);
    }
    path_ = (given.parent_path() / given.stem()).string();
    kinds_ = ending.empty() ? figure_kinds() : std::vector<std::string>{ending.substr(1)};
    folder_next_to(path_);
    for (const std::string& kind : kinds_) {
        if (fs::is_directory(path_ + "." + kind)) {
            throw input_error("--out", path_ + "." + kind, "is a directory", "choose another name");
        }
    }
}

void figure_file::draw(const figure_content& content) const {
    const working_folder working = folder_next_to(path_);
    for (const text_file& each : content.tables) {
        write_into((fs::path(working.path()) / each.name).string(), each.content);
    }
    auto variables = content.variables;
    variables.emplace_back("figure", drawn_name);
    draw_by_script(content.script, variables, kinds_, working.path());
    for (const std::string& kind : kinds_) {
        const std::string target = path_ + "." + kind;
        std::error_code failed;
        fs::rename(fs::path(working.path()) / (std::string(drawn_name) + "." + kind), target, failed);
        if (failed) {
            throw input_error("--out", target, fmt::format("cannot be written ({})", failed.message()),
                              "choose a writable file");
        }
        say_line("wrote " + target);
    }
}

std::string words_for_script(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& each : words) {
        list += (list.empty() ? "\"" : " \"") + each + "\"";
    }
    return list;
}

std::string text_in_figure(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        plain += std::string_view("^_@&~{}\\").find(c) != std::string_view::npos ? "\\" : "";
        plain += c;
    }
    return plain;
}

std::string heading_in_figure(const std::string& heading) {
    if (heading.find_first_of("= ") == std::string::npos) {
        return heading;
    }
    std::string text;
    for (const char c : text_in_figure(heading)) {
        text += c == '\'' ? "\u2032" : std::string(1, c);
    }
    return text;
}

std::string name_in_figure(const std::string& name) {
    const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0; };
    std::string text;
    bool below = false;
    for (std::size_t i = 0; i < name.size();) {
        const auto end = std::find_if_not(name.begin() + static_cast<std::ptrdiff_t>(i), name.end(), is_letter);
        const auto length = static_cast<std::size_t>(end - name.begin()) - i;
        if (length > 0) {
            text += with_greek_letter(name.substr(i, length));
            i += length;
        } else if (name[i] == '_' && !below && i > 0) {
            text += "_{";
            below = true;
            ++i;
        } else {
            // A prime ends a subscript; other signs have a meaning for gnuplot.
            if (name[i] == '\'' && below) {
                text += "}";
                below = false;
            }
            text += name[i] == '\''                                                         ? "′"
                    : std::string_view("^@&~{}_\\").find(name[i]) != std::string_view::npos ? " "
                                                                                            : name.substr(i, 1);
            ++i;
        }
    }
    return below ? text + "}" : text;
}

}  // namespace libration
