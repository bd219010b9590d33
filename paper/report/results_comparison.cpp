#include "results_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "published.hpp"
#include "reproduce_set.hpp"
#include "text/table.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

bool depends_on_machine(const std::string& scalar) {
    return scalar == "double" || scalar == "long-double" || scalar == "quad";
}

// Where two tables differ.
struct table_difference {
    std::size_t exact = 0;    // cells that have to be the same
    std::size_t machine = 0;  // cells of rows of an arithmetic of the machine
    std::string first;        // of those that have to be the same, in words
};

void note(table_difference& found, bool of_machine, const std::string& where) {
    found.first = !of_machine && found.exact == 0 ? where : found.first;
    ++(of_machine ? found.machine : found.exact);
}

table_difference difference_of(const table& made, const table& published) {
    const auto header = [](const table& data) { return to_csv(table(data.columns())); };
    if (header(made) != header(published) || made.rows().size() != published.rows().size()) {
        return {1, 0,
                fmt::format("{} rows under {} columns, published {} under {}", made.rows().size(),
                            made.columns().size(), published.rows().size(), published.columns().size())};
    }
    const auto& columns = made.columns();
    const auto scalar = std::ranges::find(columns, "scalar", &column::name);
    table_difference found;
    for (std::size_t i = 0; i < made.rows().size(); ++i) {
        const auto& row = made.rows()[i];
        const bool of_machine = scalar != columns.end() &&
                                depends_on_machine(row[static_cast<std::size_t>(scalar - columns.begin())].text());
        for (std::size_t j = 0; j < row.size(); ++j) {
            if (!(row[j] == published.rows()[i][j])) {
                note(found, of_machine,
                     fmt::format("line {}, {}: {}, published {}", i + 2, columns[j].name, row[j].text(),
                                 published.rows()[i][j].text()));
            }
        }
    }
    return found;
}

class folder_comparison {
public:
    folder_comparison(fs::path made, fs::path published) : made_(std::move(made)), published_(std::move(published)) {}

    void compare(const std::string& part) {
        if (!fs::exists(made_ / description_of_part(part))) {
            found_.missing.push_back(part);
        } else if (part == claims_name) {
            compare_part(part, {{place_of_part(part), false}});
        } else {
            compare_part(part, tables_of(part));
            compare_figures(part);
        }
    }

    const results_comparison& found() const { return found_; }

private:
    // The CSV files of both folders, and whether they hold what the machine may move.
    std::map<std::string, bool> tables_of(const std::string& part) const {
        std::map<std::string, bool> tables;
        for (const fs::path& root : {made_, published_}) {
            for (const std::string& file : files_of(root, part, ".csv")) {
                tables.emplace(file, false);
            }
        }
        if (part == references_name) {
            return tables;
        }
        const auto json = nlohmann::json::parse(text_of((made_ / description_of_part(part)).string()));
        for (const auto& each : json.at("tables")) {
            const bool timed = each.contains("note");
            tables[part + "/" + each.at("file").get<std::string>()] =
                timed || depends_on_machine(each.at("scalar").get<std::string>());
        }
        return tables;
    }

    static std::set<std::string> files_of(const fs::path& root, const std::string& part, const char* extension) {
        std::set<std::string> files;
        if (fs::is_directory(root / part)) {
            for (const auto& entry : fs::directory_iterator(root / part)) {
                if (entry.path().extension() == extension) {
                    files.insert(part + "/" + entry.path().filename().string());
                }
            }
        }
        return files;
    }

    void compare_part(const std::string& part, const std::map<std::string, bool>& tables) {
        if (!fs::exists(published_ / place_of_part(part))) {
            found_.fresh.push_back(part);
            return;
        }
        for (const auto& [file, of_machine] : tables) {
            compare_table(file, of_machine);
        }
    }

    void compare_table(const std::string& file, bool of_machine) {
        ++(of_machine ? found_.machine : found_.exact);
        auto& differing = of_machine ? found_.moved : found_.wrong;
        if (!fs::exists(made_ / file) || !fs::exists(published_ / file)) {
            differing.push_back(file +
                                (fs::exists(made_ / file) ? " is not published" : " is published and was not made"));
            return;
        }
        const std::string made = text_of((made_ / file).string());
        const std::string published = text_of((published_ / file).string());
        if (made == published) {
            return;
        }
        const table_difference where = difference_of(from_csv(made), from_csv(published));
        if (of_machine || where.exact == 0) {
            found_.moved.push_back(file);
        } else {
            differing.push_back(fmt::format("{} {} ({} {})", file, where.first, where.exact,
                                            where.exact == 1 ? "difference" : "differences"));
        }
    }

    void compare_figures(const std::string& part) {
        for (const std::string& file : files_of(made_, part, ".svg")) {
            if (fs::exists(published_ / file)) {
                ++found_.figures;
                if (text_of((made_ / file).string()) != text_of((published_ / file).string())) {
                    found_.redrawn.push_back(file);
                }
            }
        }
    }

    fs::path made_, published_;
    results_comparison found_;
};

// "3 of 14 WHAT: a, b, c", or nothing.
void add_line(std::vector<std::string>& lines, const std::vector<std::string>& some, std::size_t all,
              const std::string& what) {
    if (!some.empty()) {
        lines.push_back(fmt::format("{} of {} {}: {}", some.size(), all, what, fmt::join(some, ", ")));
    }
}

}  // namespace

std::vector<std::string> results_comparison::lines(const std::string& published) const {
    std::vector<std::string> lines;
    if (wrong.empty()) {
        lines.push_back(fmt::format("compared with {}: {} the same", published,
                                    exact == 1 ? "the one table of mpfr or of balls is"
                                               : fmt::format("all {} tables of mpfr and of balls are", exact)));
    } else {
        lines.push_back(fmt::format("compared with {}: {} of {} tables of mpfr and of balls differ", published,
                                    wrong.size(), exact));
    }
    for (const std::string& each : wrong) {
        lines.push_back("differs: " + each);
    }
    add_line(lines, moved, machine + exact,
             "tables of rounded values (double, long double, quad) or of times differ, as expected between machines");
    add_line(lines, redrawn, figures, "figures differ");
    if (!missing.empty()) {
        lines.push_back(fmt::format("not compared, because not made: {}", fmt::join(missing, ", ")));
    }
    if (!fresh.empty()) {
        lines.push_back(fmt::format("{} does not have yet: {}", published, fmt::join(fresh, ", ")));
    }
    return lines;
}

results_comparison compared(const std::string& made, const std::string& published,
                            const std::vector<std::string>& parts) {
    folder_comparison folders(made, published);
    for (const std::string& part : parts) {
        folders.compare(part);
    }
    return folders.found();
}

}  // namespace libration
