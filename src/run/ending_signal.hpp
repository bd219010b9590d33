// What is to be done when a signal ends the process.
#pragma once

#include <functional>
#include <list>
#include <mutex>

namespace libration {

/// While it lives, INT, TERM and HUP call `done` before they end the process as they do by themselves: in a thread of
/// its own, one after the other, so that it may do anything, but not for long. A signal that the process was started to
/// ignore (nohup) stays ignored.
class at_ending_signal {
public:
    explicit at_ending_signal(std::function<void()> done);
    at_ending_signal(const at_ending_signal&) = delete;
    at_ending_signal& operator=(const at_ending_signal&) = delete;
    ~at_ending_signal();

    /// While it is held, these signals wait: for the moment in which files change places.
    static std::unique_lock<std::mutex> uninterrupted();

    /// What a signal would call, for another sudden end. Nothing is thrown.
    static void call_all() noexcept;

private:
    std::list<std::function<void()>>::iterator place_;
};

}  // namespace libration
