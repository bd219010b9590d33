// The engine of studies: computes the missing cells, stores finished ones, and makes their tables. The tables depend
// only on the cells of the order, in the order of their inputs, and not on threads, machines and interruptions.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "journal.hpp"
#include "journal_writer.hpp"
#include "sweep/study_order.hpp"

namespace libration {

/// The storage of finished cells.
class cell_store {
public:
    cell_store() = default;
    cell_store(const cell_store&) = delete;
    cell_store& operator=(const cell_store&) = delete;
    virtual ~cell_store() = default;
    /// The record of a cell, also of one that failed.
    virtual std::optional<journal_record> find(const cell_key& key) const = 0;
    /// Safe to call from several threads.
    virtual void add(std::vector<journal_record> records) = 0;
    /// Returns when everything is stored.
    virtual void flush() = 0;
};

/// In memory, for tables that are written to stdout.
class memory_store : public cell_store {
public:
    std::optional<journal_record> find(const cell_key& key) const override;
    void add(std::vector<journal_record> records) override;
    void flush() override {}

private:
    mutable std::mutex mutex_;
    std::unordered_map<std::string, journal_record> all_;
};

/// In a journal, with its writer.
class journal_store : public cell_store {
public:
    explicit journal_store(journal& into) : into_(into), writer_(into) {}
    std::optional<journal_record> find(const cell_key& key) const override { return into_.find(key); }
    void add(std::vector<journal_record> records) override { writer_.add(std::move(records)); }
    void flush() override { writer_.flush(); }

private:
    journal& into_;
    journal_writer writer_;
};

/// Some of the cells of a group.
struct group_work {
    std::size_t group;
    std::vector<std::size_t> cells;
};

/// A share of the groups, for independent jobs: every count-th group, starting at index.
struct study_shard {
    std::size_t index = 0;
    std::size_t count = 1;
};

/// The cells of an order, with their keys.
class study_cells {
public:
    explicit study_cells(const study_order& order);

    const study& of() const { return *order_.what; }
    const study_request& request() const { return order_.request; }
    const study_plan& plan() const { return plan_; }
    cell_key key(const cell_inputs& inputs) const;
    /// The version of the code that computes cells of the study: its own and the library's.
    journal_stamp stamp() const;
    double cost(std::size_t group) const { return plan_.cost ? plan_.cost(group) : 1; }
    /// The records of these cells of a group: a failure affects only the cell that fails.
    std::vector<journal_record> compute(const group_work& work) const;
    /// Rethrows the exception of the first of the cells that failed here, in the order of the tables.
    void rethrow_first_failure() const;

private:
    void keep_failure(std::size_t group, std::size_t cell) const;

    const study_order& order_;
    study_plan plan_;
    std::string common_;  // the common beginning of the keys of all cells
    mutable std::mutex mutex_;
    mutable std::pair<std::size_t, std::size_t> place_of_failure_{};
    mutable std::exception_ptr first_failure_;
};

/// "energy=1.71 order=20".
std::string words_of(const cell_inputs& inputs);

/// A cell that failed, and the reason.
struct cell_failure {
    std::string inputs;
    std::string reason;
    int attempts;
};

/// The state of the cells of an order in a store.
struct cells_found {
    std::vector<group_work> missing;  ///< including those that failed before
    std::size_t cells = 0;            ///< of the order, or of its shard
    std::size_t to_compute = 0;
};
cells_found missing_cells(const study_cells& of, const cell_store& in, const study_shard& shard);

/// Called when a group starts and when its cells are finished, from any thread.
struct cell_events {
    std::function<void(const group_work&)> begun;
    std::function<void(const group_work&, std::vector<journal_record>)> finished;
};

/// Computes groups: by threads of this process, or in other processes.
using cell_executor = std::function<void(const study_cells&, const std::vector<group_work>&, const cell_events&)>;

/// On the threads of this process.
void compute_on_threads(const study_cells& of, const std::vector<group_work>& work, const cell_events& events);

/// The executor of all orders: compute_on_threads, unless the program sets another before its first study.
cell_executor& executor();

/// In a process that computes cells for another: all orders are processed by this function, without tables and files.
/// Empty in all other processes.
std::function<void(const study_cells&)>& cell_server();

/// Computes what is missing, the longest first, and shows the progress.
void compute_missing(const study_cells& of, cell_store& store, cells_found found);

/// The first failures among the cells, and their number.
struct failures_found {
    std::vector<cell_failure> first;
    std::size_t count = 0;

    void add(const journal_record& failed);
};

/// The missing cells that failed; the others have not been tried.
failures_found failures_among(const cells_found& found, const study_cells& of, const cell_store& store);

/// The tables of an order from its finished cells.
struct gathered_tables {
    std::vector<study_table> tables;
    failures_found failures;
    std::size_t finished = 0;
    /// One of the tables is too long to be held in memory: their data have no rows, which each_row provides.
    bool too_long = false;
    /// Calls see(index of the table, row) in the order of the tables.
    std::function<void(const std::function<void(std::size_t, const table_row_cells&)>& see)> each_row;
};

/// The maximum number of rows of a table that is held in memory, typeset and drawn.
inline constexpr std::size_t most_rows_in_memory = 100'000;

gathered_tables gather(const study_cells& of, const cell_store& store, std::size_t most_rows = most_rows_in_memory);

/// The tables of an order that is computed in memory, without columns that repeat others. Rethrows the exception of the
/// first cell that failed.
std::vector<study_table> tables_of(const study_order& order);

/// The same, but a failure is returned if at least one other cell has a result.
struct tables_and_failures {
    std::vector<study_table> tables;
    failures_found failures;
};
tables_and_failures answers_of(const study_order& order);

/// "2 cells failed: energy=1e-400 (energy ... is below the range); ...", with the first of them.
std::string message_of(const failures_found& failures);

}  // namespace libration
