// Cores shared by several sweeps: the first sweep uses as many as it can, the next one the remaining ones, so that no
// core waits for the last step of another.
#pragma once

#include <condition_variable>
#include <mutex>
#include <set>

namespace libration {

/// So many cores, taken in turns. Of those who wait, the one with the lowest rank is next.
class shared_cores {
public:
    explicit shared_cores(int cores) : free_(cores) {}
    shared_cores(const shared_cores&) = delete;
    shared_cores& operator=(const shared_cores&) = delete;

    /// Waits for a core.
    void take(int rank);
    void give_back();
    /// Between two steps: gives the core back and takes one again where somebody of a lower rank waits.
    void let_others(int rank);

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int free_;
    std::multiset<int> waiting_;
};

/// A part of a larger work, bound to its thread while it lives: it holds one core, and the sweeps that the thread
/// starts (on_threads) use the shared cores by its rank, step by step, instead of separate ones.
class core_share {
public:
    /// Waits for a core.
    core_share(shared_cores& of, int rank);
    /// With a core that was taken for it.
    struct taken_tag {};
    static constexpr taken_tag taken{};
    core_share(shared_cores& of, int rank, taken_tag by);
    core_share(const core_share&) = delete;
    core_share& operator=(const core_share&) = delete;
    ~core_share();

    /// That of this thread; nullptr where its sweeps share with nobody.
    static core_share* of_this_thread();

    /// A core for a thread of the sweep; no core if the share is nullptr.
    class turn {
    public:
        explicit turn(core_share* share);
        turn(const turn&) = delete;
        turn& operator=(const turn&) = delete;
        ~turn();
        /// Between two steps.
        void let_others() const;

    private:
        core_share* share_;
    };

    /// While the share's own thread waits for those of its sweep, its core is theirs.
    class pause {
    public:
        explicit pause(core_share* share);
        pause(const pause&) = delete;
        pause& operator=(const pause&) = delete;
        ~pause();

    private:
        core_share* share_;
    };

private:
    shared_cores& cores_;
    int rank_;
};

}  // namespace libration
