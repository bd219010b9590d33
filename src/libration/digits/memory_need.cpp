#include "libration/digits/memory_need.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string_view>

namespace libration {

namespace {

constexpr double kilobyte = 1024;
constexpr double always_there = 64 * kilobyte * kilobyte;

// The first number in a file; std::nullopt if there is none, as in "max".
std::optional<double> number_in(const char* path) {
    std::ifstream file(path);
    double value = 0;
    return file >> value ? std::optional(value) : std::nullopt;
}

// The sum of the numbers after these words in a file; std::nullopt if one is missing.
std::optional<double> sum_in(const char* path, std::initializer_list<std::string_view> words) {
    std::ifstream file(path);
    std::size_t found = 0;
    double sum = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream parts(line);
        std::string word;
        double value = 0;
        if (parts >> word >> value && std::find(words.begin(), words.end(), word) != words.end()) {
            sum += value;
            ++found;
        }
    }
    return found == words.size() ? std::optional(sum) : std::nullopt;
}

// The pages of this process: its whole address space, and its data with the stack.
struct pages {
    double all, data;
};

std::optional<pages> pages_of_process() {
    std::ifstream file("/proc/self/statm");
    std::array<double, 6> values{};
    for (double& each : values) {
        if (!(file >> each)) {
            return std::nullopt;
        }
    }
    return pages{values[0], values[5]};
}

// What remains of a limit; std::nullopt without one.
std::optional<double> left_of(const rlimit& limit, double used_pages) {
    if (limit.rlim_cur == RLIM_INFINITY) {
        return std::nullopt;
    }
    return static_cast<double>(limit.rlim_cur) - used_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// Files in memory count as used but are released when memory is short.
std::optional<double> left_of_group() {
    const auto most = number_in("/sys/fs/cgroup/memory.max");
    const auto used = number_in("/sys/fs/cgroup/memory.current");
    const auto files = sum_in("/sys/fs/cgroup/memory.stat", {"file"});
    return most && used ? std::optional(*most - *used + files.value_or(0)) : std::nullopt;
}

std::optional<double> left_of_machine() {
    const auto kilobytes = sum_in("/proc/meminfo", {"MemAvailable:", "SwapFree:"});
    return kilobytes ? std::optional(*kilobytes * kilobyte) : std::nullopt;
}

// 1.2 GB, 300 MB.
std::string text_of_bytes(double bytes) {
    constexpr double mega = 1e6;
    constexpr double giga = 1e9;
    std::ostringstream text;
    text.precision(bytes >= giga ? 1 : 0);
    text << std::fixed << (bytes >= giga ? bytes / giga : bytes / mega) << (bytes >= giga ? " GB" : " MB");
    return text.str();
}

}  // namespace

std::optional<double> available_memory() {
    std::optional<double> least;
    const auto consider = [&](const std::optional<double>& left) {
        if (left) {
            least = std::max(0.0, std::min(least.value_or(std::numeric_limits<double>::infinity()), *left));
        }
    };
    if (const auto used = pages_of_process()) {
        rlimit limit{};
        consider(::getrlimit(RLIMIT_AS, &limit) == 0 ? left_of(limit, used->all) : std::nullopt);
        consider(::getrlimit(RLIMIT_DATA, &limit) == 0 ? left_of(limit, used->data) : std::nullopt);
    }
    consider(left_of_group());
    consider(left_of_machine());
    return least;
}

void require_memory(const std::string& quantity, double least) {
    if (least < always_there) {
        return;
    }
    const auto available = available_memory();
    if (available && least > *available) {
        throw memory_shortage(quantity + " needs at least " + text_of_bytes(least) + " of memory, and " +
                              text_of_bytes(*available) + " are available: reduce it");
    }
}

}  // namespace libration
