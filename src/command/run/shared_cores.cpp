#include "run/shared_cores.hpp"

namespace libration {

namespace {

thread_local core_share* share_of_thread = nullptr;

}  // namespace

void shared_cores::take(int rank) {
    std::unique_lock lock(mutex_);
    waiting_.insert(rank);
    changed_.wait(lock, [&] { return free_ > 0 && *waiting_.begin() == rank; });
    waiting_.erase(waiting_.find(rank));
    --free_;
    if (free_ > 0 && !waiting_.empty()) {
        changed_.notify_all();
    }
}

void shared_cores::give_back() {
    const std::lock_guard lock(mutex_);
    ++free_;
    if (!waiting_.empty()) {
        changed_.notify_all();
    }
}

void shared_cores::let_others(int rank) {
    {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty() || *waiting_.begin() >= rank) {
            return;
        }
    }
    give_back();
    take(rank);
}

core_share::core_share(shared_cores& of, int rank) : core_share(of, rank, taken) { cores_.take(rank_); }

core_share::core_share(shared_cores& of, int rank, taken_tag /*by*/) : cores_(of), rank_(rank) {
    share_of_thread = this;
}

core_share::~core_share() {
    share_of_thread = nullptr;
    cores_.give_back();
}

core_share* core_share::of_this_thread() { return share_of_thread; }

core_share::turn::turn(core_share* share) : share_(share) {
    if (share_ != nullptr) {
        share_->cores_.take(share_->rank_);
    }
}

core_share::turn::~turn() {
    if (share_ != nullptr) {
        share_->cores_.give_back();
    }
}

void core_share::turn::let_others() const {
    if (share_ != nullptr) {
        share_->cores_.let_others(share_->rank_);
    }
}

core_share::pause::pause(core_share* share) : share_(share) {
    if (share_ != nullptr) {
        share_->cores_.give_back();
    }
}

core_share::pause::~pause() {
    if (share_ != nullptr) {
        share_->cores_.take(share_->rank_);
    }
}

}  // namespace libration
