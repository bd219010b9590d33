#include "journal_writer.hpp"

#include <iterator>
#include <utility>

namespace libration {

journal_writer::journal_writer(journal& into) : into_(into), thread_([this] { write_all(); }) {}

journal_writer::~journal_writer() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
}

void journal_writer::rethrow() const {
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void journal_writer::add(std::vector<journal_record> records) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_waiting || failure_; });
    rethrow();
    waiting_.insert(waiting_.end(), std::make_move_iterator(records.begin()), std::make_move_iterator(records.end()));
    changed_.notify_all();
}

void journal_writer::flush() {
    std::unique_lock lock(mutex_);
    hurried_ = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return (waiting_.empty() && !writing_) || failure_; });
    hurried_ = false;
    rethrow();
}

void journal_writer::write_all() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return !waiting_.empty() || ended_; });
        if (waiting_.empty() || failure_) {
            return;
        }
        // More may come in the same time: one commit for all.
        changed_.wait_for(lock, patience, [&] { return hurried_ || ended_ || waiting_.size() >= most_waiting; });
        const std::vector<journal_record> group = std::exchange(waiting_, {});
        writing_ = true;
        changed_.notify_all();
        lock.unlock();
        std::exception_ptr problem;
        try {
            into_.add(group);
        } catch (...) {
            problem = std::current_exception();
        }
        lock.lock();
        writing_ = false;
        failure_ = problem;
        changed_.notify_all();
        if (failure_) {
            return;
        }
    }
}

}  // namespace libration
