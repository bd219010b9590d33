// The journal: what was added comes back, from this process and the next, or its damage is told.
#include "sweep/journal.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "command/temporary_folder.hpp"
#include "sweep/journal_writer.hpp"

namespace sweep_journal_test {

using namespace libration;
using libration::tests::temporary_folder;
using libration::tests::text_of_file;

namespace {

journal_record numbered(int i, bool failed = false) {
    const std::string name = "order=" + std::to_string(i);
    return {key_of(name), name, failed, 1, 0.25, "rows of " + name};
}

std::string file_in(const temporary_folder& folder) { return (folder.path() / "study.journal").string(); }

// Runs f in a child process; its exit code, or 128 + its signal.
template <class F>
int in_child(const F& f) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            f();
            ::_exit(0);
        } catch (...) {
            ::_exit(3);
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void fill(const std::string& path, int count) {
    journal cells(path, journal::access::write);
    cells.set_stamp({"study", "1", "0.9"});
    std::vector<journal_record> records;
    for (int i = 0; i < count; ++i) {
        records.push_back(numbered(i));
    }
    cells.add(records);
}

journal_error::fault fault_of(const std::string& path, journal::access how) {
    try {
        const journal cells(path, how);
        cells.counts();
        cells.for_each([](const journal_record&) {});
    } catch (const journal_error& problem) {
        return problem.kind();
    }
    throw std::logic_error("nothing was wrong with " + path);
}

}  // namespace

TEST_CASE("the key of a cell is the beginning of the SHA-256 of its words", "[journal]") {
    // printf abc | sha256sum
    const cell_key expected{0xba, 0x78, 0x16, 0xbf, 0x8f, 0x01, 0xcf, 0xea,
                            0x41, 0x41, 0x40, 0xde, 0x5d, 0xae, 0x22, 0x23};
    CHECK(key_of("abc") == expected);
}

TEST_CASE("records, stamp and commands outlive the journal that wrote them", "[journal]") {
    const temporary_folder folder;
    const journal_stamp stamp{"error_norm", "2", "0.9 (abc)"};
    {
        journal cells(file_in(folder), journal::access::write);
        CHECK_FALSE(cells.stamp());
        cells.set_stamp(stamp);
        cells.add_command("libration study a");
        cells.add_command("libration study b");
        cells.add_command("libration study a");
        cells.add({numbered(1), numbered(2, true)});
        cells.add({numbered(3)});
    }
    CHECK(folder.content() == std::vector<std::string>{"study.journal"});
    journal cells(file_in(folder), journal::access::read);
    CHECK(cells.stamp() == stamp);
    CHECK(cells.commands() == std::vector<std::string>{"libration study a", "libration study b"});
    const auto found = cells.find(numbered(1).key);
    REQUIRE(found);
    CHECK(found->inputs == "order=1");
    CHECK_FALSE(found->failed);
    CHECK(found->seconds == 0.25);
    CHECK(found->content == "rows of order=1");
    CHECK(cells.find(numbered(2).key)->failed);
    CHECK_FALSE(cells.find(numbered(4).key));
    CHECK(cells.counts().done == 2);
    CHECK(cells.counts().failed == 1);
    CHECK(cells.counts().seconds == 0.75);
    std::string order;
    cells.for_each([&](const journal_record& each) { order += each.inputs + " "; });
    CHECK(order == "order=1 order=2 order=3 ");
}

TEST_CASE("a record of the same key takes the place of the one before", "[journal]") {
    const temporary_folder folder;
    journal cells(file_in(folder), journal::access::write);
    cells.add({numbered(1, true)});
    journal_record again = numbered(1);
    again.attempts = 2;
    cells.add({again});
    CHECK(cells.counts().done == 1);
    CHECK(cells.counts().failed == 0);
    CHECK(cells.find(again.key)->attempts == 2);
}

TEST_CASE("one process writes a journal, and others read it meanwhile", "[journal]") {
    const temporary_folder folder;
    journal cells(file_in(folder), journal::access::write);
    cells.add({numbered(1)});
    const std::string path = file_in(folder);
    CHECK(in_child([&] {
              try {
                  const journal second(path, journal::access::write);
              } catch (const journal_error& problem) {
                  ::_exit(problem.kind() == journal_error::fault::in_use ? 7 : 8);
              }
          }) == 7);
    CHECK(in_child([&] { ::_exit(journal(path, journal::access::read).find(numbered(1).key) ? 9 : 10); }) == 9);
    CHECK_THROWS_AS(drop_journal(path), journal_error);
    cells.add({numbered(2)});
    CHECK(cells.counts().done == 2);
}

TEST_CASE("a process that is killed loses nothing that it had committed", "[journal]") {
    const temporary_folder folder;
    const std::string path = file_in(folder);
    CHECK(in_child([&] {
              journal cells(path, journal::access::write);
              journal_writer writer(cells);
              for (int i = 0; i < 5; ++i) {
                  writer.add({numbered(i)});
              }
              writer.flush();
              writer.add({numbered(5)});
              ::kill(::getpid(), SIGKILL);
          }) == 128 + SIGKILL);
    const journal cells(path, journal::access::write);
    for (int i = 0; i < 5; ++i) {
        CHECK(cells.find(numbered(i).key));
    }
}

TEST_CASE("the writer commits by itself, within 0.2 s", "[journal]") {
    const temporary_folder folder;
    journal cells(file_in(folder), journal::access::write);
    journal_writer writer(cells);
    writer.add({numbered(1)});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(journal(file_in(folder), journal::access::read).find(numbered(1).key));
}

TEST_CASE("a full disk ends the writer with an error, and what was committed stays", "[journal]") {
    const temporary_folder folder;
    const std::string path = file_in(folder);
    fill(path, 10);
    CHECK(in_child([&] {
              journal cells(path, journal::access::write);
              journal_writer writer(cells);
              const rlim_t size = 200'000;
              const rlimit small{size, size};
              ::setrlimit(RLIMIT_FSIZE, &small);
              try {
                  for (int i = 10; i < 100'000; ++i) {
                      writer.add({numbered(i)});
                  }
                  writer.flush();
              } catch (const journal_error& problem) {
                  ::_exit(problem.kind() == journal_error::fault::unwritable ? 7 : 8);
              }
          }) == 7);
    const journal cells(path, journal::access::write);
    CHECK(cells.counts().done >= 10);
    CHECK(cells.find(numbered(9).key));
}

TEST_CASE("damage is told and not trusted", "[journal]") {
    const temporary_folder folder;
    const std::string path = file_in(folder);
    fill(path, 2000);
    const std::string whole = text_of_file(path);
    const auto write = [&](const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; };

    write(whole.substr(0, whole.size() / 2));
    CHECK(fault_of(path, journal::access::read) == journal_error::fault::damaged);
    write(
        "no database at all, but a text of more than a hundred bytes, so that nobody takes it for an empty file ....");
    CHECK(fault_of(path, journal::access::write) == journal_error::fault::damaged);

    // A single letter of a row, which SQLite itself does not notice.
    std::string changed = whole;
    const auto place = changed.find("rows of order=1234");
    REQUIRE(place != std::string::npos);
    changed[place] = 'R';
    write(changed);
    CHECK(fault_of(path, journal::access::read) == journal_error::fault::damaged);
    const journal cells(path, journal::access::read);
    CHECK_THROWS_WITH(cells.find(numbered(1234).key), Catch::Contains("checksum of order=1234"));
    CHECK(cells.find(numbered(1233).key));
}

TEST_CASE("a journal that does not exist, or cannot be written, is told", "[journal]") {
    const temporary_folder folder;
    CHECK(fault_of(file_in(folder), journal::access::read) == journal_error::fault::unwritable);
    CHECK(fault_of((folder.path() / "missing" / "study.journal").string(), journal::access::write) ==
          journal_error::fault::unwritable);
}

TEST_CASE("a file that a run has just made is a journal that holds nothing yet, and its next writer begins it",
          "[journal]") {
    const temporary_folder folder;
    std::ofstream(file_in(folder)).close();
    CHECK(fault_of(file_in(folder), journal::access::read) == journal_error::fault::unbegun);
    fill(file_in(folder), 2);
    CHECK(journal(file_in(folder), journal::access::read).counts().done == 2);
}

TEST_CASE("a dropped journal leaves nothing beside it", "[journal]") {
    const temporary_folder folder;
    fill(file_in(folder), 3);
    drop_journal(file_in(folder));
    CHECK(folder.content().empty());
}

}  // namespace sweep_journal_test
