#include "ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include <mpfr.h>

#include "counted_text.hpp"
#include "record_text.hpp"

namespace libration {

namespace {

// Messages: a rank sends its number of threads; it receives groups, one more than it has threads; it sends finished
// cells; and it is released.
constexpr int tag_ready = 1;
constexpr int tag_work = 2;
constexpr int tag_finished = 3;
constexpr int tag_release = 4;
constexpr std::chrono::milliseconds between_looks{1};

void require(int code) {
    if (code != MPI_SUCCESS) {
        throw std::runtime_error("MPI could not send or receive a message");
    }
}

void send(const std::string& text, int to, int tag) {
    require(MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD));
}

struct message {
    int from, tag;
    std::string text;
};

// A message that has arrived; std::nullopt if there is none.
std::optional<message> arrived() {
    int there = 0;
    MPI_Status status;
    require(MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status));
    if (there == 0) {
        return std::nullopt;
    }
    int size = 0;
    require(MPI_Get_count(&status, MPI_BYTE, &size));
    message result{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(size), '\0')};
    require(MPI_Recv(result.text.data(), size, MPI_BYTE, result.from, result.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE));
    return result;
}

std::string text_of(const group_work& work) {
    std::string text;
    add_number(text, static_cast<long>(work.group));
    add_number(text, static_cast<long>(work.cells.size()));
    for (const std::size_t each : work.cells) {
        add_number(text, static_cast<long>(each));
    }
    return text;
}

group_work work_from(const std::string& text) {
    counted_text rest(text);
    group_work work{static_cast<std::size_t>(rest.number()), {}};
    work.cells.resize(rest.count());
    for (std::size_t& each : work.cells) {
        each = static_cast<std::size_t>(rest.number());
    }
    return work;
}

// The threads of a rank: a queue of groups to compute and one of finished ones.
class crew {
public:
    crew(const study_cells& of, int jobs) : of_(of) {
        for (int i = 0; i < jobs; ++i) {
            threads_.emplace_back([this](const std::stop_token& ended) { work(ended); });
        }
    }
    void add(group_work work) {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(work));
        changed_.notify_one();
    }
    /// The text of finished cells.
    std::optional<std::string> take_finished() {
        const std::lock_guard lock(mutex_);
        if (finished_.empty()) {
            return std::nullopt;
        }
        std::string first = std::move(finished_.front());
        finished_.pop_front();
        return first;
    }

private:
    void work(const std::stop_token& ended) {
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, ended, [&] { return !waiting_.empty(); })) {
            const group_work next = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            std::string text;
            add_number(text, static_cast<long>(next.group));
            text += to_record_text(of_.compute(next));
            lock.lock();
            finished_.push_back(std::move(text));
        }
        mpfr_free_cache();
    }

    const study_cells& of_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<group_work> waiting_;
    std::deque<std::string> finished_;
    std::vector<std::jthread> threads_;  // last, so that they end first
};

// The state on rank 0 of the groups that are being computed.
class handing_out {
public:
    handing_out(const std::vector<group_work>& work, const cell_events& events) : work_(work), events_(events) {}

    bool ended() const { return finished_ == work_.size(); }
    void see(const message& came) {
        if (came.tag == tag_ready) {
            free_[came.from] += std::stoi(came.text);
        } else if (came.tag == tag_finished) {
            counted_text rest(came.text);
            const auto group = static_cast<std::size_t>(rest.number());
            const std::string records = came.text.substr(came.text.find(':') + 1);
            events_.finished(*out_.at(group), records_from(records));
            out_.erase(group);
            ++finished_;
            ++free_[came.from];
        }
        hand_out();
    }

private:
    // One group at a time to each rank with a free thread, so that long ones are distributed.
    void hand_out() {
        for (bool any = true; any && next_ < work_.size();) {
            any = false;
            for (auto& [rank, free] : free_) {
                if (free > 0 && next_ < work_.size()) {
                    const group_work& each = work_[next_++];
                    events_.begun(each);
                    send(text_of(each), rank, tag_work);
                    out_[each.group] = &each;
                    --free;
                    any = true;
                }
            }
        }
    }

    const std::vector<group_work>& work_;
    const cell_events& events_;
    std::map<int, int> free_;
    std::map<std::size_t, const group_work*> out_;
    std::size_t next_ = 0;
    std::size_t finished_ = 0;
};

}  // namespace

mpi_ranks::mpi_ranks(int* argc, char*** argv) {
    int provided = 0;
    require(MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided));
    if (provided < MPI_THREAD_FUNNELED) {
        throw std::runtime_error("this MPI cannot be used by a process with threads");
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

mpi_ranks::~mpi_ranks() { MPI_Finalize(); }

void mpi_ranks::compute(const study_cells& of, const std::vector<group_work>& work, const cell_events& events) const {
    if (count_ == 1 || of.of().alone) {
        compute_on_threads(of, work, events);
        return;
    }
    handing_out shared(work, events);
    while (!shared.ended()) {
        if (const auto came = arrived()) {
            shared.see(*came);
        } else {
            std::this_thread::sleep_for(between_looks);
        }
    }
}

void mpi_ranks::serve(const study_cells& of) {
    const int jobs = of.of().alone ? 1 : of.request().jobs;
    crew threads(of, jobs);
    send(std::to_string(jobs + 1), 0, tag_ready);
    while (!released_) {
        bool idle = true;
        if (const auto came = arrived()) {
            released_ = came->tag == tag_release;
            if (came->tag == tag_work) {
                threads.add(work_from(came->text));
            }
            idle = false;
        }
        while (const auto text = threads.take_finished()) {
            send(*text, 0, tag_finished);
            idle = false;
        }
        if (idle) {
            std::this_thread::sleep_for(between_looks);
        }
    }
}

void mpi_ranks::release() const {
    for (int rank = 1; rank < count_; ++rank) {
        send("", rank, tag_release);
    }
}

void mpi_ranks::wait_for_release() {
    while (!released_) {
        const auto came = arrived();
        released_ = came && came->tag == tag_release;
        if (!came) {
            std::this_thread::sleep_for(between_looks);
        }
    }
}

}  // namespace libration
