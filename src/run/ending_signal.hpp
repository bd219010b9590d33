// What is to be done when a signal ends the process.
#pragma once

#include <functional>
#include <list>
#include <mutex>

namespace libration {

/// During its lifetime, INT, TERM and HUP call `done` before they end the process in the default way: in a separate
/// thread, the latest first, so that `done` may call any function but should return soon. A signal that was ignored
/// when the process started (nohup) remains ignored.
class at_ending_signal {
public:
    explicit at_ending_signal(std::function<void()> done);
    at_ending_signal(const at_ending_signal&) = delete;
    at_ending_signal& operator=(const at_ending_signal&) = delete;
    ~at_ending_signal();

    /// Called at a signal before the actions, and instead of them if it does not return; an empty function removes it. Throws
    /// std::system_error if no thread can be started.
    static void set_first(std::function<void()> first);

    /// While it is held, these signals wait: for the moment in which files change places.
    static std::unique_lock<std::mutex> uninterrupted();

    /// What a signal would call, for another sudden end. Nothing is thrown.
    static void call_all() noexcept;

private:
    std::list<std::function<void()>>::iterator place_;
};

}  // namespace libration
