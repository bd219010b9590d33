// The end of a command after --timeout, or at a signal, with what is finished by then.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <thread>

namespace libration {

/// During its lifetime a command ends after a time, and if `signals` at INT, TERM and HUP, with exit code 1 and one line
/// on stderr with how far it came (status_source). A computation that calls check_time() between its steps ends by an
/// exception, so that the command prints what is finished. If it does not call it for some seconds, the actions of
/// at_ending_signal are called, and the process ends. One object at a time.
class time_limit {
public:
    /// `typed` is the value of --timeout.
    time_limit(std::optional<std::chrono::milliseconds> limit, std::string typed, bool signals);
    time_limit(const time_limit&) = delete;
    time_limit& operator=(const time_limit&) = delete;
    ~time_limit();

private:
    void wait_for_end(const std::stop_token& finished, std::chrono::milliseconds limit);

    std::string typed_;
    bool signals_;
    std::jthread timer_;
};

/// Throws error of the kind undecided, with how far the command came, if it is to end.
void check_time();

/// During its lifetime, the line with which a command ends contains this text: how far it came. The function is called
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
