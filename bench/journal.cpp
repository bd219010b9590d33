// The cost per cell of the engine of studies and its journal, without the computation of the cell, and the number of
// cores for which one writer suffices.
//
//   ./run bench journal                   10^6 empty cells through the engine
//   ./run bench journal --cells 100000
//   ./run bench journal --model FILE.csv  the same, and the table of docs/pictures/one_writer.gp into FILE.csv
//
// An empty cell is one row of its two inputs. Memory is the resident size reported by the system, after a tenth of the
// cells and after all of them.
#include <unistd.h>

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "sweep/cell_engine.hpp"
#include "sweep/record_text.hpp"

namespace {

using namespace libration;
using clock_type = std::chrono::steady_clock;

double seconds_since(clock_type::time_point start) {
    return std::chrono::duration<double>(clock_type::now() - start).count();
}

// The resident size of the process in megabytes.
double resident_megabytes() {
    std::ifstream file("/proc/self/statm");
    long total = 0;
    long resident = 0;
    file >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

struct empty_row {
    std::size_t group, cell;
};

const column_list<empty_row>& empty_columns() {
    static const column_list<empty_row> all{{"group", "", [](const empty_row& r) { return r.group; }},
                                            {"cell", "", [](const empty_row& r) { return r.cell; }}};
    return all;
}

// Groups of this many cells that compute nothing.
study empty_cells(std::size_t cells, std::size_t in_group) {
    study result{.name = "empty",
                 .title = "Empty cells",
                 .label = "",
                 .question = "What does a cell cost?",
                 .reading = "",
                 .of = &pendulum_problem(),
                 .parameters = {},
                 .quick = {},
                 .seconds = 1,
                 .excluded = {},
                 .plan = {}};
    result.plan = [cells, in_group](const study_request&) {
        study_plan plan;
        plan.tables = {head_of("", read_scalar("double"), empty_columns())};
        plan.groups = cells / in_group;
        plan.group = [in_group](std::size_t i) {
            cell_group group;
            for (std::size_t k = 0; k < in_group; ++k) {
                group.cells.push_back({{"group", std::to_string(i)}, {"cell", std::to_string(k)}});
            }
            group.compute = [i](const std::vector<std::size_t>& which) {
                std::vector<cell_rows> rows;
                for (const std::size_t k : which) {
                    rows.push_back({{{cell(i), cell(k)}}});
                }
                return rows;
            };
            return group;
        };
        return plan;
    };
    return result;
}

struct measured_engine {
    double microseconds;  // per cell
    double bytes;         // of the journal, per cell
    double early_megabytes, late_megabytes;
};

measured_engine run_engine(const std::filesystem::path& folder, std::size_t cells, std::size_t in_group) {
    const study what = empty_cells(cells, in_group);
    study_order order{&what, {}, "libration study empty", ""};
    order.request.jobs = 2;
    const study_cells of(order);
    const auto path = folder / fmt::format("empty{}.journal", in_group);
    measured_engine result{};
    const auto start = clock_type::now();
    {
        journal into(path, journal::access::write);
        journal_store store(into);
        const cells_found found = missing_cells(of, store, {});
        std::atomic<std::size_t> seen{0};
        std::atomic<double> early{0};
        executor() = [&](const study_cells& all, const std::vector<group_work>& work, const cell_events& events) {
            compute_on_threads(all, work,
                               {events.begun, [&](const group_work& one, std::vector<journal_record> records) {
                                    const std::size_t count = one.cells.size();
                                    events.finished(one, std::move(records));
                                    if ((seen += count) >= cells / 10 && early == 0) {
                                        early = resident_megabytes();
                                    }
                                }});
        };
        compute_missing(of, store, found);
        executor() = compute_on_threads;
        result.early_megabytes = early;
        result.late_megabytes = resident_megabytes();
        into.settle();
    }
    result.microseconds = seconds_since(start) * 1e6 / static_cast<double>(cells);
    result.bytes = static_cast<double>(std::filesystem::file_size(path)) / static_cast<double>(cells);
    return result;
}

// The work of rank 0 per cell: parsing the record, and writing it into the journal. Microseconds.
struct writer_cost {
    double message, write;
};

writer_cost measure_writer(const std::filesystem::path& folder) {
    constexpr int count = 200'000;
    constexpr int together = 2'000;
    std::vector<std::string> texts;
    for (int i = 0; i < count; ++i) {
        const std::string inputs = fmt::format("energy=1.71 gap=0.29 order={}", i);
        const cell_rows rows{{{cell("1.71"), cell(i), cell("series"), cell::number("1.2345678901234567890e-10", 20)}}};
        texts.push_back(to_record_text({{key_of(inputs), inputs, false, 1, 0.001, to_cell_text(rows)}}));
    }
    std::vector<journal_record> records;
    const auto reading = clock_type::now();
    for (const std::string& each : texts) {
        records.push_back(records_from(each).front());
    }
    const double message = seconds_since(reading) * 1e6 / count;
    journal into(folder / "writer.journal", journal::access::write);
    const auto writing = clock_type::now();
    for (int i = 0; i < count; i += together) {
        into.add({records.begin() + i, records.begin() + i + together});
    }
    return {message, seconds_since(writing) * 1e6 / count};
}

// Cells per second on so many cores, against the time per cell, if one writer stores all of them.
void write_model(const std::string& path, const writer_cost& writer) {
    std::string csv = "cores,cell_seconds,cells_a_second,writer_limit\n";
    const double limit = 1e6 / (writer.message + writer.write);
    for (const double cell_seconds : {1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
        for (double cores = 1; cores <= 65536; cores *= std::sqrt(2.0)) {
            csv += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", cores, cell_seconds,
                               std::min(cores / cell_seconds, limit), limit);
        }
    }
    write_whole_file(path, csv);
}

void print_results(std::size_t cells, const std::vector<std::pair<std::size_t, measured_engine>>& engines,
                   const writer_cost& writer) {
    fmt::print("{} empty cells through the engine, two threads; limits: 60 microseconds and 500 bytes per cell\n\n",
               cells);
    fmt::print("{:>16} {:>18} {:>12} {:>20} {:>12}\n", "cells in a group", "microseconds/cell", "bytes/cell",
               "MB after a tenth", "MB at the end");
    for (const auto& [in_group, found] : engines) {
        fmt::print("{:>16} {:>18.2f} {:>12.1f} {:>20.1f} {:>12.1f}\n", in_group, found.microseconds, found.bytes,
                   found.early_megabytes, found.late_megabytes);
    }
    const double limit = 1e6 / (writer.message + writer.write);
    fmt::print("\nOne writer: {:.2f} microseconds to read a message, {:.2f} to write a cell: {:.0f} cells a second.\n",
               writer.message, writer.write, limit);
    fmt::print("{:>16} {:>18}\n", "a cell takes", "cores it feeds");
    for (const double seconds : {1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
        fmt::print("{:>14.4f} s {:>18.0f}\n", seconds, seconds * limit);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t cells = 1'000'000;
    std::string model;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view option = argv[i];
        if (option == "--cells") {
            cells = std::stoul(argv[i + 1]);
        } else if (option == "--model") {
            model = argv[i + 1];
        } else {
            fmt::print(stderr, "bench journal: '{}' is not an option: write --cells N or --model FILE\n", option);
            return 2;
        }
    }
    std::string name = (std::filesystem::temp_directory_path() / "libration-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        fmt::print(stderr, "bench journal: cannot make {}\n", name);
        return 1;
    }
    std::vector<std::pair<std::size_t, measured_engine>> engines;
    for (const std::size_t in_group : {std::size_t{1}, std::size_t{100}}) {
        engines.emplace_back(in_group, run_engine(name, cells, in_group));
    }
    const writer_cost writer = measure_writer(name);
    std::filesystem::remove_all(name);
    print_results(cells, engines, writer);
    if (!model.empty()) {
        write_model(model, writer);
    }
    return 0;
}
