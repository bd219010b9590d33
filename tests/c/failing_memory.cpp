// A program that asks the C interface a question, a larger one in want of memory, and the first one again, whose answer
// has to be the same; or runs a command in want of memory, whose table has to be the same, or a part of it:
//
//     failing_memory one|all|cold|limit QUESTION SMALL LARGE FIRST STEP COUNT
//     failing_memory command failing_allocation.so FIRST STEP COUNT PROGRAM WORD...
//
// one: during the larger question allocation k fails, for k = FIRST, FIRST + STEP, ...; all: that one and all behind
// it; cold: as one, and the larger question is the first of its process; limit: the address space and the data of the
// process may grow by k bytes. QUESTION is a motion or a problem, at time 3, to SMALL and to LARGE digits; or one of
//     bounds|PROBLEM with sets, at time 1       radius|PROBLEM       find|PROBLEM|UNKNOWNS|CONDITIONS
// Each k has a process of its own. Prints how many of them answered alike, refused the question, answered otherwise, crashed or did
// not end, and had memory enough (after which no further k is tried), and a line for each that went wrong. Exit code: 1
// where one did.
#include <fcntl.h>
#include <libration.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "failing_allocation.hpp"

namespace {

using failing_allocation::all_behind, failing_allocation::failed, failing_allocation::left;

enum outcome { alike, refused, other, crashed, enough, outcomes };

struct answer {
    int code;
    std::string text;
};

answer of_number(int code, libration_number* number) {
    answer result{code, ""};
    if (code == LIBRATION_OK) {
        result.text = std::string(libration_number_decimal(number)) + " +- " + libration_number_uncertainty(number);
    }
    libration_number_free(number);
    return result;
}

answer ask_motion(const char* given, long digits) {
    libration_motion* motion = nullptr;
    libration_number* number = nullptr;
    int code = libration_motion_new(given, &motion);
    if (code == LIBRATION_OK) {
        code = libration_motion_theta(motion, "3", digits, LIBRATION_PROVED, &number);
    }
    libration_motion_free(motion);
    return of_number(code, number);
}

// The parts of a question between bars.
std::vector<std::string> parts_of(const std::string& question) {
    std::vector<std::string> parts;  // without a stream, which would hide that there is no memory
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = question.find('|', begin);
        parts.push_back(question.substr(begin, end - begin));
    }
    return parts;
}

// What a table says, or a bound.
std::string text_of(const libration_table* table) {
    std::string text;
    for (size_t row = 0; row < libration_table_rows(table); ++row) {
        for (size_t column = 0; column < libration_table_columns(table); ++column) {
            text += std::string(libration_table_text(table, row, column)) + " ";
        }
    }
    return text;
}

answer asked_of(const libration_problem* problem, const std::vector<std::string>& parts, long digits) {
    libration_table* table = nullptr;
    if (parts[0] == "radius") {
        libration_number* lower = nullptr;
        libration_number* upper = nullptr;
        const int code = libration_problem_radius_bounds(problem, digits, &lower, &upper);
        libration_number_free(upper);
        return of_number(code, lower);
    }
    const int code = parts[0] == "find" ? libration_problem_find(problem, parts[2].c_str(), parts[3].c_str(), digits,
                                                                 nullptr, nullptr, &table)
                     : parts[0] == "bounds"
                         ? libration_problem_enclosures(problem, "1", 2, digits, nullptr, nullptr, &table)
                         : libration_problem_states(problem, "3", digits, LIBRATION_PROVED, nullptr, nullptr, &table);
    answer result{code, code == LIBRATION_OK ? text_of(table) : ""};
    libration_table_free(table);
    return result;
}

answer ask_problem(const std::string& question, long digits) {
    const auto parts = parts_of(question);
    libration_problem* problem = nullptr;
    answer result{libration_problem_new(parts[parts.size() > 1 ? 1 : 0].c_str(), nullptr, &problem), ""};
    if (result.code == LIBRATION_OK) {
        result = asked_of(problem, parts, digits);
    }
    libration_problem_free(problem);
    return result;
}

answer ask(const char* question, long digits) {
    try {
        for (const char* const name : {"theta0", "energy", "gap"}) {
            if (std::strstr(question, name) != nullptr) {
                return ask_motion(question, digits);
            }
        }
        return ask_problem(question, digits);
    } catch (const std::bad_alloc&) {  // for the texts of this program
        return {LIBRATION_NO_MEMORY, ""};
    }
}

// The bytes of the process: all of its addresses, and its data with the stack.
std::array<rlim_t, 2> memory_in_use() {
    std::array<rlim_t, 6> pages{};
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        for (rlim_t& each : pages) {
            static_cast<void>(std::fscanf(file, "%lu", &each));
        }
        std::fclose(file);
    }
    const auto size = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    return {pages[0] * size, pages[5] * size};
}

// The limit of addresses alone would not do: malloc has them in store for each thread.
answer ask_within(const char* question, long digits, long room) {
    const std::array<decltype(RLIMIT_AS), 2> kinds{RLIMIT_AS, RLIMIT_DATA};
    const auto used = memory_in_use();
    std::array<rlimit, 2> before{};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        getrlimit(kinds[i], &before[i]);
        rlimit narrow = before[i];
        narrow.rlim_cur = used[i] + static_cast<rlim_t>(room);
        setrlimit(kinds[i], &narrow);
    }
    answer result = ask(question, digits);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        setrlimit(kinds[i], &before[i]);
    }
    failed = result.code != LIBRATION_OK;
    return result;
}

answer ask_with_failure(const char* question, long digits, long k) {
    left = k;
    answer result = ask(question, digits);
    left = -1;
    return result;
}

outcome tried(const std::string& mode, const char* question, long small, long large, long k,
              const std::string& expected, const std::string& expected_large) {
    if (mode != "cold" && ask(question, small).text != expected) {
        return other;
    }
    const answer torn = mode == "limit" ? ask_within(question, large, k) : ask_with_failure(question, large, k);
    if (!failed) {
        return enough;
    }
    if (torn.code == LIBRATION_OK && torn.text != expected_large) {
        std::printf("k = %ld: %.40s instead of %.40s\n", k, torn.text.c_str(), expected_large.c_str());
        std::fflush(stdout);
        return other;
    }
    const answer again = ask(question, small);
    if (again.code != LIBRATION_OK) {
        return refused;
    }
    if (again.text != expected) {
        std::printf("k = %ld, code %d, then %.40s instead of %.40s\n", k, torn.code, again.text.c_str(),
                    expected.c_str());
        std::fflush(stdout);
        return other;
    }
    return alike;
}

std::string all_from(int end) {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = read(end, part.data(), part.size())) > 0;) {
        text.append(part.data(), static_cast<std::size_t>(size));
    }
    close(end);
    return text;
}

// From a process of its own, so that this one has asked nothing.
std::string expected_answer(const char* question, long small) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        return "";
    }
    const pid_t child = fork();
    if (child == 0) {
        const std::string text = ask(question, small).text;
        _exit(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
    }
    close(ends[1]);
    std::string text = all_from(ends[0]);
    waitpid(child, nullptr, 0);
    return text;
}

// Its outcome, if it has exited with one.
outcome ended(pid_t child, long k, int most) {
    int status = 0;
    waitpid(child, &status, 0);
    const bool exited = WIFEXITED(status) && WEXITSTATUS(status) <= most;
    if (!exited) {
        std::printf("k = %ld: %s %d\n", k, WIFSIGNALED(status) ? "signal" : "exit code",
                    WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
        std::fflush(stdout);
    }
    return exited ? static_cast<outcome>(WEXITSTATUS(status)) : crashed;
}

struct sweep {
    long first, step, count;

    // Tries each k.
    template <class Try>
    int over(const Try& tried_at) const {
        std::array<long, outcomes> counts{};
        for (long i = 0, k = first; i < count && counts[enough] == 0; ++i, k += step) {
            ++counts[tried_at(k)];
        }
        std::printf("alike %ld, refused %ld, other %ld, crashed %ld, enough %ld\n", counts[alike], counts[refused],
                    counts[other], counts[crashed], counts[enough]);
        return counts[other] + counts[crashed] == 0 ? 0 : 1;
    }
};

int of_interface(const std::string& mode, const char* question, long small, long large, const sweep& of) {
    all_behind = mode == "all";
    const std::string expected = expected_answer(question, small);
    const std::string expected_large = expected_answer(question, large);
    if (expected.empty() || expected_large.empty()) {
        return 2;
    }
    return of.over([&](long k) {
        const pid_t child = fork();
        if (child == 0) {
            alarm(60);
            _exit(tried(mode, question, small, large, k, expected, expected_large));
        }
        return ended(child, k, outcomes - 1);
    });
}

// What a command prints on stdout and on stderr, and whether an allocation failed in it.
struct command_run {
    std::string out, err;
    bool failed;
    pid_t child;
};

command_run run_command(char** words, const char* preloaded, long k) {
    std::array<std::array<int, 2>, 3> ends{};
    for (auto& each : ends) {
        if (pipe(each.data()) != 0) {
            std::exit(2);
        }
    }
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        dup2(ends[0][1], 1);
        dup2(ends[1][1], 2);
        for (int i = 0; i < 2; ++i) {
            close(ends[static_cast<std::size_t>(i)][0]);
            close(ends[static_cast<std::size_t>(i)][1]);
        }
        close(ends[2][0]);
        setenv("LD_PRELOAD", preloaded, 1);
        setenv("LIBRATION_FAILURE_TO", std::to_string(ends[2][1]).c_str(), 1);
        setenv("LIBRATION_FAILS_AT", std::to_string(k).c_str(), 1);
        execv(words[0], words);
        _exit(127);
    }
    for (const auto& each : ends) {
        close(each[1]);
    }
    // stderr has a few lines, which do not fill its pipe.
    command_run result{all_from(ends[0][0]), all_from(ends[1][0]), false, child};
    result.failed = !all_from(ends[2][0]).empty();
    return result;
}

// 0: the same table. 1: a message, and no line on stdout that is not in the table.
outcome judged(const command_run& run, const std::string& expected, long k) {
    const outcome code = ended(run.child, k, 1);
    bool right = code == 0 ? run.out == expected : !run.err.empty();
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) {
        right = right && ("\n" + expected).find("\n" + line + "\n") != std::string::npos;
    }
    if (code != crashed && right) {
        return !run.failed ? enough : code == 0 ? alike : refused;
    }
    std::printf("k = %ld: %s %.200s\n", k, run.out.c_str(), run.err.c_str());
    std::fflush(stdout);
    return code == crashed ? crashed : other;
}

int of_command(char** words, const char* preloaded, const sweep& of) {
    const command_run whole = run_command(words, preloaded, -1);
    if (ended(whole.child, -1, 0) == crashed) {
        return 2;
    }
    return of.over([&](long k) { return judged(run_command(words, preloaded, k), whole.out, k); });
}

}  // namespace

int main(int count, char** words) {
    const std::string mode = count > 1 ? words[1] : "";
    if (mode == "command" && count > 6) {
        return of_command(words + 6, words[2], {std::atol(words[3]), std::atol(words[4]), std::atol(words[5])});
    }
    if (count != 8) {
        return 2;
    }
    return of_interface(mode, words[2], std::atol(words[3]), std::atol(words[4]),
                        {std::atol(words[5]), std::atol(words[6]), std::atol(words[7])});
}
