#include "integrator_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <utility>

#include "libration/scalar/near_word.hpp"
#include "run/ending_signal.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* integrator_remedy = "write automatic, taylor, comparison or collocation";
constexpr const char* trace_remedy = "choose a file in a folder that exists and that you may write in";

std::string line_of(const ode::collocation_use& used) {
    return fmt::format("integrated by collocation{} from t = {:.6g} to {:.6g}: {} steps{}",
                       used.proved ? " (theorem K)" : "", used.first, used.last, used.steps,
                       used.periods > 1 ? fmt::format(" in {} intervals", used.periods) : "");
}

const char* name_of(ode::step_method method) {
    switch (method) {
        case ode::step_method::taylor: return "taylor";
        case ode::step_method::comparison: return "comparison";
        case ode::step_method::collocation: return "collocation";
        case ode::step_method::exponential: return "exponential";
    }
    return "";
}

}  // namespace

void integrator_options::add_to(CLI::App& command) {
    command
        .add_option("--integrator", integrator_,
                    "automatic (default), taylor, comparison (for many unknowns), or collocation (for stiff "
                    "equations); the last three are used even where a closed form is known")
        ->type_name("NAME");
}

ode::integrator_choice integrator_options::choice() const {
    const std::string word = integrator_.value_or("automatic");
    if (word == "automatic") {
        return ode::integrator_choice::automatic;
    }
    if (word == "taylor") {
        return ode::integrator_choice::taylor;
    }
    if (word == "comparison") {
        return ode::integrator_choice::comparison;
    }
    if (word == "collocation") {
        return ode::integrator_choice::collocation;
    }
    throw input_error("--integrator", word,
                      "is not an integrator" + suggestion(word, {"automatic", "taylor", "comparison", "collocation"}),
                      integrator_remedy);
}

void integrator_options::state(const std::vector<ode::collocation_use>& used, bool proved) const {
    for (const ode::collocation_use& each : used) {
        fmt::print(stderr, "libration: {}\n", line_of(each));
    }
    if (used.empty() && choice() == ode::integrator_choice::collocation) {
        fmt::print(stderr, "libration: no step of collocation was {}: integrated by Taylor series\n",
                   proved ? "proved" : "found");
    }
}

struct step_trace::parts {
    std::string path, written;
    std::FILE* file = nullptr;
    std::mutex mutex;
    std::optional<at_ending_signal> at_end;  ///< destroyed first, without the lock

    [[noreturn]] void fail() const {
        throw input_error("--trace", path, fmt::format("cannot be written ({})", std::strerror(errno)), trace_remedy);
    }

    void close() {
        const std::lock_guard lock(mutex);
        if (file == nullptr) {
            return;
        }
        const bool flushed = std::fclose(std::exchange(file, nullptr)) == 0;
        std::error_code error;
        if (flushed && written != path) {
            std::filesystem::rename(written, path, error);
            errno = error.value();
        }
        if (!flushed || error) {
            fail();
        }
    }
};

step_trace::step_trace(const std::string& path) : parts_(std::make_unique<parts>()) {
    namespace fs = std::filesystem;
    std::error_code error;
    parts_->path = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error).string() : path;
    const bool as_it_is = fs::exists(parts_->path, error) && !fs::is_regular_file(parts_->path, error);
    parts_->written = as_it_is ? parts_->path : fmt::format("{}.{}.part", parts_->path, ::getpid());
    parts_->file = std::fopen(parts_->written.c_str(), "wb");
    if (parts_->file == nullptr) {
        parts_->fail();
    }
    fmt::print(parts_->file, "time,bits,order,length,method,log2_relative_width\n");
    parts_->at_end.emplace([all = parts_.get()] {
        try {
            all->close();
        } catch (const std::exception& problem) {
            fmt::print(stderr, "libration: {}\n", problem.what());
        }
    });
}

step_trace::~step_trace() {
    try {
        finish();
    } catch (const std::exception& problem) {
        fmt::print(stderr, "libration: {}\n", problem.what());
    }
}

void step_trace::add(const ode::step_report& step) {
    const std::lock_guard lock(parts_->mutex);
    if (parts_->file == nullptr) {
        return;  // the process ends
    }
    fmt::print(parts_->file, "{},{},{},{:.6g},{},{:.2f}\n", step.time, step.bits, step.order, step.length,
               name_of(step.method), step.log2_of_width);
}

void step_trace::finish() { parts_->close(); }

}  // namespace libration
