// A folder to make files in before they are moved to where they belong.
#pragma once

#include <mutex>
#include <string>

namespace libration {

/// PARENT/.drawing.PID, locked while it lives. It is taken away with what is in it when the object dies and when INT,
/// TERM or HUP ends the process; what a killed process left there, the next working folder in PARENT takes away.
class working_folder {
public:
    /// Throws std::runtime_error where it cannot be made.
    explicit working_folder(const std::string& parent);
    working_folder(const working_folder&) = delete;
    working_folder& operator=(const working_folder&) = delete;
    ~working_folder();

    const std::string& path() const { return path_; }

    /// While it is held, INT, TERM and HUP wait: for the moment in which files change places.
    static std::unique_lock<std::mutex> uninterrupted();

private:
    std::string path_;
    int lock_ = -1;
};

}  // namespace libration
