// The one writer of a journal: takes finished cells from all threads and commits them in groups.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "journal.hpp"

namespace libration {

/// Commits records at most `patience` after they were added, in a separate thread. Memory is bounded: adding blocks
/// while `most_waiting` records are queued.
class journal_writer {
public:
    static constexpr std::chrono::milliseconds patience{100};
    static constexpr std::size_t most_waiting = 20'000;

    explicit journal_writer(journal& into);
    journal_writer(const journal_writer&) = delete;
    journal_writer& operator=(const journal_writer&) = delete;
    /// Commits the remaining records and ignores errors; flush() reports them.
    ~journal_writer();

    /// Throws what the last commit threw.
    void add(std::vector<journal_record> records);
    /// Returns when everything is committed. Throws as add does.
    void flush();

private:
    void write_all();
    void rethrow() const;

    journal& into_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<journal_record> waiting_;
    bool writing_ = false, hurried_ = false, ended_ = false;
    std::exception_ptr failure_;
    std::jthread thread_;
};

}  // namespace libration
