// The journal of a study: its finished cells in one file, SQLite's, which outlives the process that writes it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace libration {

/// What a cell is found by: the first 16 bytes of the SHA-256 of its study, the versions of what computes it and its
/// inputs.
using cell_key = std::array<std::uint8_t, 16>;

/// The key of these words.
cell_key key_of(const std::string& words);

/// A cell that was computed, or that failed.
struct journal_record {
    cell_key key;
    std::string inputs;  ///< for a reader: "energy=1.71 order=20"
    bool failed = false;
    int attempts = 1;
    double seconds = 0;   ///< that it took; of cells that were computed together the mean
    std::string content;  ///< its rows (cell_text.hpp), or the reason of the failure
};

/// Whose cells they are: cells of other versions are never mixed with them.
struct journal_stamp {
    std::string study;
    std::string version;  ///< of the study
    std::string library;
    friend bool operator==(const journal_stamp&, const journal_stamp&) = default;
};

/// How far a journal has come.
struct journal_counts {
    long done = 0;
    long failed = 0;
    double seconds = 0;  ///< of all cells
};

/// An error of the journal file itself.
class journal_error : public std::runtime_error {
public:
    /// unbegun: a run made the file, and was killed before it wrote the tables, or has just begun.
    enum class fault { in_use, damaged, unbegun, unwritable };
    journal_error(fault kind, std::string path, std::string reason)
        : std::runtime_error(path + " " + reason), kind_(kind), path_(std::move(path)), reason_(std::move(reason)) {}
    fault kind() const { return kind_; }
    const std::string& path() const { return path_; }
    /// A predicate of the file: "is in use by another run".
    const std::string& reason() const { return reason_; }

private:
    fault kind_;
    std::string path_, reason_;
};

/// One file of cells. Every record carries a checksum: what comes back is what went in, or journal_error. Calls may
/// come
/// from several threads; one process at a time writes, others may read meanwhile.
class journal {
public:
    enum class access { read, write };

    /// Opens the file; for writing it is made where it is missing. Write-ahead log, or a rollback journal where
    /// the file
    /// system is of a network; synchronous NORMAL. Throws journal_error.
    journal(std::filesystem::path path, access how);
    journal(const journal&) = delete;
    journal& operator=(const journal&) = delete;
    journal(journal&& other) noexcept;
    ~journal();

    const std::filesystem::path& path() const { return path_; }
    /// std::nullopt for a new one.
    std::optional<journal_stamp> stamp() const;
    void set_stamp(const journal_stamp& stamp);
    /// The commands whose cells are here, in the order in which they were first run.
    std::vector<std::string> commands() const;
    void add_command(const std::string& words);

    std::optional<journal_record> find(const cell_key& key) const;
    /// Adds all or none; a record of a key that is there is replaced.
    void add(const std::vector<journal_record>& records);
    /// Ends a period of writing: everything is moved into the one file, and SQLite's auxiliary files are removed,
    /// unless another process is reading it.
    void settle();
    /// In the order in which they were added.
    void for_each(const std::function<void(const journal_record&)>& see) const;
    journal_counts counts() const;

private:
    struct database;
    std::filesystem::path path_;
    std::unique_ptr<database> database_;
};

/// Removes a journal and SQLite's auxiliary files. Throws journal_error of the kind in_use.
void drop_journal(const std::filesystem::path& path);

}  // namespace libration
