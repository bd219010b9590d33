#include "sweep/study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "libration/scalar/near_word.hpp"
#include "option/options.hpp"
#include "run/provenance.hpp"
#include "run/sha256.hpp"
#include "run/stream_content.hpp"
#include "run/working_folder.hpp"
#include "text/input_error.hpp"
#include "text/latex.hpp"
#include "text/members.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

std::string stem_of(const study& what, const study_table& part) {
    return part.suffix.empty() ? what.name : what.name + "_" + part.suffix;
}

nlohmann::ordered_json description_of(const study_order& order, const gathered_tables& gathered) {
    const auto& tables = gathered.tables;
    nlohmann::ordered_json description;
    description["study"] = order.what->name;
    description["question"] = order.what->question;
    description["command"] = order.command;
    if (order.what->equation) {
        description["problem"] = order.what->equation->text;
    }
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
                                     {"rows", gathered.too_long ? part.rows : part.data.rows().size()}};
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
    for (const cell_failure& each : gathered.failures.first) {
        description["failed"].push_back({{"cell", each.inputs}, {"reason", each.reason}, {"attempts", each.attempts}});
    }
    description["note"] =
        "mpfr tables depend on the parameters alone; in the others libm may move the last digit from machine to "
        "machine";
    for (const auto& [name, version] : provenance()) {
        description["made with"][name] = version;
    }
    return description;
}

std::string content_of_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return content_of(file, path.string());
}

// Names and fingerprints of the files in a directory, without JSON and hidden files.
std::map<std::string, std::string> fingerprints(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && !name.starts_with(".") && entry.path().extension() != ".json") {
            files[name] = sha256(content_of_file(entry.path()));
        }
    }
    return files;
}

// Whether a file of DIR/NAME is one that a run may write there. Files of other names belong to the user.
bool belongs_to(const study& what, const std::string& file) {
    const std::string stem = fs::path(file).stem().string();
    const std::string extension = fs::path(file).extension().string();
    return (stem == what.name || stem.starts_with(what.name + "_")) &&
           (extension == ".csv" || extension == ".tex" || extension == ".json" || is_figure(file));
}

// The files in `made` replace those in `own` that are selected by `replaced`; the JSON is removed first and added last,
// so that it never describes missing files.
template <class Pick>
void take_places(const fs::path& made, const fs::path& own, const std::string& json, const Pick& replaced) {
    for (const auto& entry : fs::directory_iterator(made)) {
        if (fs::is_directory(own / entry.path().filename())) {
            throw input_error("--out", (own / entry.path().filename()).string(),
                              "is a directory where a file is to be written", "move it or name another --out");
        }
    }
    const auto guard = at_ending_signal::uninterrupted();
    fs::remove(own / json);
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(own)) {
        if (entry.is_regular_file() && replaced(entry.path().filename().string())) {
            old.push_back(entry.path());
        }
    }
    std::for_each(old.begin(), old.end(), [](const fs::path& each) { fs::remove(each); });
    std::vector<fs::path> fresh;
    for (const auto& entry : fs::directory_iterator(made)) {
        if (!entry.is_symlink() && entry.path().filename() != json) {
            fresh.push_back(entry.path());
        }
    }
    std::for_each(fresh.begin(), fresh.end(), [&](const fs::path& each) { fs::rename(each, own / each.filename()); });
    fs::rename(made / json, own / json);
}

// If a directory of the program cannot be created, it is not writable.
std::unique_ptr<working_folder> folder_within(const std::string& own) {
    try {
        return std::make_unique<working_folder>(own);
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", own, fmt::format("cannot be written ({})", problem.what()),
                          "choose a writable directory");
    }
}

}  // namespace

void require_columns(const std::vector<study_table>& tables, const std::optional<std::string>& names) {
    std::vector<column> all;
    for (const study_table& part : tables) {
        if (part.written) {
            all.insert(all.end(), part.data.columns().begin(), part.data.columns().end());
        }
    }
    if (names) {
        with_named_columns(table(all), *names);
    }
}

void write_into(const std::string& path, const std::string& content) {
    try {
        write_whole_file(path, content);
    } catch (const std::runtime_error& problem) {
        throw input_error("--out", path, fmt::format("cannot be written ({})", problem.what()),
                          "choose a writable directory");
    }
}

namespace {

void write_tables(const study_order& order, const std::vector<study_table>& tables, const fs::path& folder) {
    for (const study_table& part : tables) {
        const std::string stem = stem_of(*order.what, part);
        write_into((folder / (stem + ".csv")).string(), to_csv(part.data));
        const table chosen = with_columns_of(part.data, order.columns);
        write_into((folder / (stem + ".tex")).string(),
                   to_latex(chosen, {latex_text(order.what->title + ". Made by " + order.command + "."), stem}));
    }
}

// The description of DIR/NAME.
nlohmann::ordered_json described(const study& what, const std::string& folder) {
    const std::string again = "run 'libration study " + what.name + "' with the same --out first";
    const fs::path json = fs::path(folder) / what.name / (what.name + ".json");
    if (!fs::exists(json)) {
        throw input_error("--out", folder, "contains no " + what.name + "/" + what.name + ".json", again);
    }
    auto description = nlohmann::ordered_json::parse(content_of_file(json), nullptr, false);
    if (!description.is_object() || !description.contains("tables") || !description.contains("files")) {
        throw input_error("--out", folder,
                          "has in " + what.name + ".json no files with their SHA-256: an older version wrote it",
                          again);
    }
    return description;
}

// The tables named in the JSON, linked into the working directory.
void show_tables(const study& what, const nlohmann::ordered_json& description, const fs::path& own,
                 const fs::path& working) {
    for (const auto& part : description.at("tables")) {
        const std::string file = part.at("file");
        const bool same =
            fs::exists(own / file) && description.at("files").value(file, "") == sha256(content_of_file(own / file));
        if (!same) {
            throw input_error("--out", (own / file).string(),
                              fs::exists(own / file) ? "is not the table that " + what.name + ".json describes"
                                                     : "is missing, which " + what.name + ".json describes",
                              "run '" + description.value("command", "libration study " + what.name) + "' again");
        }
        fs::create_symlink(fs::path("..") / file, working / file);
    }
}

// One CSV after the other, in constant memory.
void write_long_tables(const study_order& order, const gathered_tables& gathered, const fs::path& folder) {
    std::vector<own_columns> kept;
    std::vector<csv_stream> files;
    for (const study_table& part : gathered.tables) {
        kept.emplace_back(part.data.columns());
    }
    gathered.each_row([&](std::size_t place, const table_row_cells& row) { kept[place].see(row); });
    for (std::size_t i = 0; i < gathered.tables.size(); ++i) {
        const study_table& part = gathered.tables[i];
        files.emplace_back((folder / (stem_of(*order.what, part) + ".csv")).string(), part.data.columns(),
                           kept[i].places());
    }
    gathered.each_row([&](std::size_t place, const table_row_cells& row) { files[place].add(row); });
    for (csv_stream& file : files) {
        file.finish();
    }
    say_line(fmt::format("{} has tables of more than {} rows: they are not typeset and not drawn", order.what->name,
                         most_rows_in_memory));
}

}  // namespace

failures_found make_tables(const study_order& order, const study_cells& of, cell_store& store,
                           const std::string& folder) {
    const study& what = *order.what;
    const std::string own = (fs::path(folder) / what.name).string();
    gathered_tables gathered = gather(of, store);
    if (gathered.finished == 0 && gathered.failures.count > 0) {
        of.rethrow_first_failure();
        throw std::runtime_error(message_of(gathered.failures));
    }
    const auto working = folder_within(own);
    if (gathered.too_long) {
        write_long_tables(order, gathered, working->path());
    } else {
        without_repetitions(gathered.tables);
        write_tables(order, gathered.tables, working->path());
        if (what.files) {
            for (const text_file& each : what.files(gathered.tables)) {
                write_into((fs::path(working->path()) / each.name).string(), each.content);
            }
        }
    }
    if (what.remarks) {
        for (const std::string& each : what.remarks(gathered.tables)) {
            say_line(each);
        }
    }
    std::exception_ptr undrawn;
    try {
        if (!gathered.too_long) {
            draw_figures(what, working->path());
        }
    } catch (const std::exception&) {
        undrawn = std::current_exception();
    }
    auto description = description_of(order, gathered);
    description["files"] = fingerprints(working->path());
    const std::string json = what.name + ".json";
    write_into((fs::path(working->path()) / json).string(), description.dump(2) + '\n');
    take_places(working->path(), own, json, [&](const std::string& file) { return belongs_to(what, file); });
    if (undrawn) {
        say_line(fmt::format("the tables are in {}, without figures: 'libration figure {} --out {}' draws them", own,
                             what.name, folder));
        std::rethrow_exception(undrawn);
    }
    return gathered.failures;
}

void draw_study(const study& what, const std::string& folder) {
    auto description = described(what, folder);
    const output_folder into("--out", (fs::path(folder) / what.name).string());
    const fs::path own = into.path();
    const auto working = folder_within(into.path());
    show_tables(what, description, own, working->path());
    draw_figures(what, working->path());
    auto files = fingerprints(working->path());
    for (const auto& [name, fingerprint] : description["files"].items()) {
        if (!is_figure(name)) {
            files[name] = fingerprint;
        }
    }
    description["files"] = files;
    const std::string json = what.name + ".json";
    write_into((fs::path(working->path()) / json).string(), description.dump(2) + '\n');
    take_places(working->path(), own, json,
                [&](const std::string& file) { return is_figure(file) && belongs_to(what, file); });
}

const study& study_named(std::string_view option, std::string_view name) {
    const auto studies = all_studies();
    const auto found = std::ranges::find(studies, name, &study::name);
    if (found != studies.end()) {
        return **found;
    }
    const auto names = members_of(studies, &study::name);
    const std::string near = suggestion(name, names);
    throw input_error(
        std::string(option), std::string(name), "is not a study" + near,
        near.empty() ? fmt::format("choose one of {}", fmt::join(names, ", ")) : "see 'libration studies'");
}

}  // namespace libration
