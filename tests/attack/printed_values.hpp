// Values that the program prints for problems with steps and events, whose solutions are known exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attack/question.hpp"

namespace libration::attack {

/// A question to `libration reference --times`.
struct printed_question {
    struct unknown {
        std::string name;
        std::vector<std::optional<truth>> values;  ///< at each time; none where there is more than one solution
    };

    std::string problem;
    std::vector<std::string> times;
    std::vector<unknown> unknowns;
    long digits = 10;
    bool slides = true;  ///< whether a message may state that the solution slides along a surface
};

/// The verdicts on each printed value, or on the message if there are fewer. The program runs in a process by itself, so
/// that its end by a signal is a false answer, too.
outcome asked_program(const printed_question& question);

}  // namespace libration::attack
