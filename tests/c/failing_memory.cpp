// A program that asks the C interface a question, a larger one in want of memory, and the first one again, whose answer
// has to be the same:
//
//     failing_memory one|all|cold|limit QUESTION SMALL LARGE FIRST STEP COUNT
//
// one: during the larger question allocation k fails, for k = FIRST, FIRST + STEP, ...; all: that one and all behind
// it; cold: as one, and the larger question is the first of its process; limit: the address space and the data of the
// process may grow by k bytes. QUESTION is a motion or a problem, at time 3, to SMALL and to LARGE digits. Each k has a
// process of its own. Prints how many of them answered alike, refused the question, answered otherwise, crashed or did
// not end, and had memory enough (after which no further k is tried), and a line for each that went wrong. Exit code: 1
// where one did.
#include <libration.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the allocation of glibc
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)
}

namespace {

// Allocations until one fails; below 0 all succeed.
std::atomic<long> left{-1};
std::atomic<bool> failed{false};
bool all_behind = false;

bool fails() {
    if (left.load(std::memory_order_relaxed) < 0) {
        return false;
    }
    if (left.fetch_sub(1) != 0) {
        return false;
    }
    failed = true;
    errno = ENOMEM;
    if (all_behind) {
        left = 0;
    }
    return true;
}

}  // namespace

extern "C" void* malloc(std::size_t size) noexcept { return fails() ? nullptr : __libc_malloc(size); }
extern "C" void* calloc(std::size_t count, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_calloc(count, size);
}
extern "C" void* realloc(void* memory, std::size_t size) noexcept {
    return fails() ? nullptr : __libc_realloc(memory, size);
}

namespace {

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

answer ask_problem(const char* text, long digits) {
    libration_problem* problem = nullptr;
    libration_table* table = nullptr;
    int code = libration_problem_new(text, nullptr, &problem);
    if (code == LIBRATION_OK) {
        code = libration_problem_states(problem, "3", digits, LIBRATION_PROVED, nullptr, nullptr, &table);
    }
    answer result{code, libration_table_text(table, 0, 1)};
    libration_table_free(table);
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
              const std::string& expected) {
    if (mode != "cold" && ask(question, small).text != expected) {
        return other;
    }
    const answer torn = mode == "limit" ? ask_within(question, large, k) : ask_with_failure(question, large, k);
    if (!failed) {
        return enough;
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
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = read(ends[0], part.data(), part.size())) > 0;) {
        text.append(part.data(), static_cast<std::size_t>(size));
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return text;
}

outcome in_process(const std::string& mode, const char* question, long small, long large, long k,
                   const std::string& expected) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        _exit(tried(mode, question, small, large, k, expected));
    }
    int status = 0;
    waitpid(child, &status, 0);
    const bool ended = WIFEXITED(status) && WEXITSTATUS(status) < outcomes;
    if (!ended) {
        std::printf("k = %ld: %s %d\n", k, WIFSIGNALED(status) ? "signal" : "exit code",
                    WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
        std::fflush(stdout);
    }
    return ended ? static_cast<outcome>(WEXITSTATUS(status)) : crashed;
}

}  // namespace

int main(int count, char** words) {
    if (count != 8) {
        return 2;
    }
    const std::string mode = words[1];
    all_behind = mode == "all";
    const long small = std::atol(words[3]);
    const long large = std::atol(words[4]);
    const long step = std::atol(words[6]);
    long k = std::atol(words[5]);
    const std::string expected = expected_answer(words[2], small);
    if (expected.empty()) {
        return 2;
    }
    std::array<long, outcomes> counts{};
    for (long left_to_try = std::atol(words[7]); left_to_try > 0 && counts[enough] == 0; --left_to_try, k += step) {
        ++counts[in_process(mode, words[2], small, large, k, expected)];
    }
    std::printf("alike %ld, refused %ld, other %ld, crashed %ld, enough %ld\n", counts[alike], counts[refused],
                counts[other], counts[crashed], counts[enough]);
    return counts[other] + counts[crashed] == 0 ? 0 : 1;
}
