// A folder to make files in before they are moved to where they belong.
#pragma once

#include <optional>
#include <string>

#include "run/ending_signal.hpp"

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

private:
    std::string path_;
    int lock_ = -1;
    std::optional<at_ending_signal> at_signal_;
};

}  // namespace libration
