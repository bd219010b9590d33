// Invalid input ends with exit status 2 and one line on stderr with the option, the value and the remedy; nothing is
// printed on stdout and no file is left.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "command/child_process.hpp"

namespace libration::tests {

/// Whether the last sentence of a message is a remedy.
inline bool has_remedy(const std::string& line) {
    static const words verbs{"write ", "give ",  "add ", "use ", "choose ",  "ask ",    "make ",
                             "name ",  "leave ", "run ", "see ", "replace ", "shorten "};
    const auto colon = line.rfind(": ");
    return colon != std::string::npos && std::any_of(verbs.begin(), verbs.end(), [&](const std::string& verb) {
               return line.compare(colon + 2, verb.size(), verb) == 0;
           });
}

/// Checks that the command line is rejected, that the message contains all of `mentioned`, and that the directory is
/// unchanged.
inline void check_refused(const words& line, const words& mentioned, const temporary_folder& folder) {
    const auto before = folder.content();
    const finished_process done = run_libration(line, folder.path());
    INFO(command_line(line) << "\n" << done.err);
    CHECK(done.exit_code == 2);
    CHECK(done.out.empty());
    CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
    CHECK(done.err.ends_with("\n"));
    CHECK(done.err.starts_with("libration: "));
    CHECK(has_remedy(done.err));
    for (const std::string& mention : mentioned) {
        INFO("should mention " << mention);
        CHECK(done.err.find(mention) != std::string::npos);
    }
    CHECK(folder.content() == before);
}

/// The same in an empty directory.
inline void check_refused(const words& line, const words& mentioned) {
    const temporary_folder folder;
    check_refused(line, mentioned, folder);
}

}  // namespace libration::tests
