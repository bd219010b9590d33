// What is to be done when a signal ends the process, and the end of a command at a signal or after --timeout.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

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

    /// Called at a signal before the actions, and instead of them if it does not return; an empty function removes it.
    /// Throws std::system_error if no thread can be started.
    static void set_first(std::function<void()> first);

    /// While it is held, these signals wait: for the moment in which files change places.
    static std::unique_lock<std::mutex> uninterrupted();

    /// What a signal would call, for another sudden end. Nothing is thrown.
    static void call_all() noexcept;

private:
    std::list<std::function<void()>>::iterator place_;
};

/// During its lifetime a command ends after a time, and if `signals` at INT, TERM and HUP, with exit code 1 and one
/// line on stderr with how far it got (status_source). A computation that calls check_time() between its steps ends by
/// an exception, so that the command prints what is finished. If it does not call it within 5 s, the actions of
/// at_ending_signal are called, and the process ends; within 0.4 s if it has not called it before, or if the command
/// prints nothing before all is finished. One object at a time.
class time_limit {
public:
    /// `typed` is the value of --timeout.
    time_limit(std::optional<std::chrono::milliseconds> limit, std::string typed, bool signals,
               bool prints_parts = true);
    time_limit(const time_limit&) = delete;
    time_limit& operator=(const time_limit&) = delete;
    ~time_limit();

private:
    void wait_for_end(const std::stop_token& finished, std::chrono::milliseconds limit);

    std::string typed_;
    bool signals_;
    std::jthread timer_;
};

/// Throws error of the kind undecided, with how far the command got, if it is to end.
void check_time();
/// Whether a signal or --timeout is ending the command, so that what returns is not complete.
bool is_ending();

/// During its lifetime, the line with which a command ends contains this text: how far it got. The function is called
/// from another thread.
class status_source {
public:
    explicit status_source(std::function<std::string()> status);
    status_source(const status_source&) = delete;
    status_source& operator=(const status_source&) = delete;
    ~status_source();

private:
    std::list<std::function<std::string()>>::iterator place_;
};

}  // namespace libration
