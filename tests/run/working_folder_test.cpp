// Folders to work in. That nothing of them stays when a signal ends the program is tested in command/study_test.cpp.
#include "run/working_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "command/temporary_folder.hpp"

namespace run_working_folder_test {

using libration::working_folder;
using libration::tests::temporary_folder;

TEST_CASE("a working folder goes with its object", "[run]") {
    const temporary_folder parent;
    {
        const working_folder working(parent.path().string());
        std::ofstream(working.path() + "/file") << "x";
        CHECK(parent.content().size() == 2);
    }
    CHECK(parent.content().empty());
}

TEST_CASE("what a killed process left is taken away by the next one, and what a living one has is not", "[run]") {
    const temporary_folder parent;
    std::filesystem::create_directories(parent.path() / ".drawing.2" / "tables");
    std::filesystem::create_directory(parent.path() / ".drawing.1");
    const int living = ::open((parent.path() / ".drawing.1").c_str(), O_RDONLY | O_DIRECTORY);
    REQUIRE(::flock(living, LOCK_EX) == 0);
    { const working_folder working(parent.path().string()); }
    CHECK(parent.content() == std::vector<std::string>{".drawing.1"});
    ::close(living);
    { const working_folder working(parent.path().string()); }
    CHECK(parent.content().empty());
}

}  // namespace run_working_folder_test
