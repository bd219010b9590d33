// Command lines of `period`, one word per line: they are parsed, and run if that is cheap.
#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "libration/scalar/error.hpp"
#include "option/subcommand.hpp"
#include "text/input_error.hpp"

namespace {

// No file is written and no result has many digits.
bool is_cheap(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        int digits = 0;
        for (const char c : word) {
            digits = c >= '0' && c <= '9' ? digits + 1 : 0;
            if (digits > 2) {
                return false;
            }
        }
        if (word.starts_with("--o") || word.find_first_of("^*(") != std::string::npos) {
            return false;
        }
    }
    return true;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
    return std::freopen("/dev/null", "w", stdout) == nullptr ? 1 : 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
    std::vector<std::string> words;
    for (std::string word; std::getline(lines, word);) {
        words.push_back(word);
    }
    CLI::App program("fuzzed", "libration");
    program.require_subcommand(1);
    const auto period = libration::period_command(program);
    const bool runs = is_cheap(words);
    try {
        program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (runs) {
            libration::check_combinations(*period.options, {});
            period.run();
        }
    } catch (const CLI::Error&) {
    } catch (const libration::input_error&) {
    } catch (const libration::error&) {
    }
    return 0;
}
