#include "program.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "libration/digits/memory_need.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/ball/failure.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/near_word.hpp"
#include "option/exclusions.hpp"
#include "option/help.hpp"
#include "option/subcommand.hpp"
#include "option/timeout_option.hpp"
#include "run/ending_signal.hpp"
#include "run/provenance.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace {

constexpr int failed = 1;
constexpr int bad_input = 2;
constexpr const char* out_of_memory = "out of memory: ask for fewer digits, powers or times";

// If GMP or FLINT cannot allocate memory, no exception can be thrown: the actions of an ending signal are called,
// stdout keeps its complete rows, and the process ends as after an error.
void end_process(libration::failure_kind kind) {
    static std::atomic_flag ending;
    if (ending.test_and_set()) {
        for (;;) {
            ::pause();  // another thread ends the process
        }
    }
    constexpr unsigned seconds = 10;
    ::alarm(seconds);  // an action may wait for a lock that this thread holds
    std::fflush(stdout);
    libration::at_ending_signal::call_all();
    std::fputs("libration: ", stderr);
    std::fputs(kind == libration::failure_kind::no_memory ? out_of_memory : "FLINT aborted with the message above",
               stderr);
    std::fputs("\n", stderr);
    ::_exit(failed);
}

std::terminate_handler usual_end = nullptr;

// An exception that nothing catches: during the initialisation of the program, or in a function that throws none.
[[noreturn]] void end_at_exception() {
    try {
        if (const auto thrown = std::current_exception()) {
            std::rethrow_exception(thrown);
        }
    } catch (const std::bad_alloc&) {
        end_process(libration::failure_kind::no_memory);
    } catch (...) {
        usual_end();
    }
    std::abort();
}

// One line for any message, without control characters.
int complain(const std::string& message, int code) {
    fmt::print(stderr, "libration: {}\n", libration::shortened(message));
    return code;
}

// CLI11 quotes words of any length.
std::string with_short_words(std::string message, int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto at = word.size() > libration::longest_quotation ? message.find(word) : std::string::npos;
        if (at != std::string::npos) {
            message.replace(at, word.size(), libration::without_controls(word, libration::longest_quotation));
        }
    }
    return message;
}

// The first unexpected word: after a subcommand it is an unknown option.
std::string unexpected_word(const CLI::App& program) {
    const auto words = program.remaining(true);
    if (!program.get_subcommands().empty()) {
        for (const auto& word : words) {
            if (word.starts_with("-")) {
                return word;
            }
        }
    }
    return words.empty() ? "" : words.front();
}

// The names of the subcommands, and of the options of one.
std::vector<std::string> names_in(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App* /*all*/) { return true; })) {
        names.push_back(each->get_name());
    }
    for (const CLI::Option* each : app.get_options()) {
        for (const std::string& name : each->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

// A problem of the catalogue, or an equation, without the option that accepts it.
std::string advice_for_problem(const std::string& word, const CLI::App& command) {
    const auto& known = libration::catalogue();
    const bool named = std::any_of(known.begin(), known.end(), [&](const auto& each) { return each.name == word; });
    const bool equation = !word.starts_with("-") && word.find('=') != std::string::npos;
    return (named || equation) && command.get_option_no_throw("--problem") != nullptr
               ? fmt::format(": write --problem {}", equation ? "\"" + libration::shortened(word) + "\"" : word)
               : "";
}

// CLI11's error message as one line with a remedy, and a similar valid name.
int complain_of_usage(const CLI::App& program, const std::string& problem) {
    const std::string unexpected = unexpected_word(program);
    const auto chosen = program.get_subcommands();
    std::string near = libration::suggestion(unexpected.substr(0, unexpected.find('=')),
                                             names_in(chosen.empty() ? program : *chosen.front()));
    if (near.empty() && !chosen.empty()) {
        near = advice_for_problem(unexpected, *chosen.front());
    }
    const std::string line =
        unexpected.empty() ? problem : libration::quotation(unexpected) + " is not understood" + near;
    const std::string help =
        chosen.empty() ? "libration --help" : "libration " + chosen.front()->get_name() + " --help";
    return complain(fmt::format("{}: see {}", line, help), bad_input);
}

// A value beyond the range of a scalar, with advice if the subcommand has --scalar.
int complain_of_range(const CLI::App& command, const libration::error& problem) {
    const bool chooses = command.get_option_no_throw("--scalar") != nullptr;
    return complain(fmt::format("{}{}", libration::message_of(problem), chooses ? ": use --scalar mpfr:DIGITS" : ""),
                    bad_input);
}

// An error about what an option of the command gives, with the name of the option. A problem that is valid, but not
// decided, is named as it is.
libration::error with_option(const libration::error& problem, const CLI::App& command) {
    using libration::error_subject;
    static const std::vector<std::pair<error_subject, const char*>> options{
        {error_subject::along, "--along"},
        {error_subject::before, "--before"},
        {error_subject::check, "--check"},
        {error_subject::condition, "--such-that"},
        {error_subject::condition, "--until"},
        {error_subject::conditions, "--such-that"},
        {error_subject::derivatives, "--derivatives"},
        {error_subject::integrator, "--integrator"},
        {error_subject::problem, "--problem"},
        {error_subject::unknowns, "--unknown"}};
    const bool named = !problem.is_about(error_subject::problem) || problem.kind() == libration::error_kind::argument;
    for (const auto& [subject, option] : options) {
        if (named && problem.is_about(subject) && command.get_option_no_throw(option) != nullptr) {
            return {problem.kind(), option, problem.value(), problem.reason()};
        }
    }
    return problem;
}

int complain_of_input(const libration::input_error& problem) {
    const auto offered = libration::words_offered(problem.remedy());
    return complain(problem.line_with(libration::suggestion(problem.value(), offered)), bad_input);
}

// Runs a subcommand; exceptions become a message of one line and an exit code.
int run(const libration::subcommand& command) {
    try {
        libration::check_combinations(*command.options, command.has);
        return command.run();
    } catch (const libration::input_error& problem) {
        return complain_of_input(problem);
    } catch (const libration::error& problem) {
        return problem.kind() == libration::error_kind::range
                   ? complain_of_range(*command.options, problem)
                   : complain(libration::message_of(with_option(problem, *command.options)),
                              libration::is_undefined(problem.kind()) ? bad_input : failed);
    } catch (const libration::memory_shortage& problem) {
        return complain(problem.what(), failed);
    } catch (const std::bad_alloc&) {
        return complain(out_of_memory, failed);
    } catch (const std::system_error& problem) {
        const bool of_thread = problem.code() == std::errc::resource_unavailable_try_again;
        return complain(of_thread ? "no thread can be started: memory or threads are at their limit" : problem.what(),
                        failed);
    } catch (const std::exception& problem) {
        return complain(problem.what(), failed);
    }
}

// Whether a command may take long; a study also ends by itself at a signal, with its journal.
bool has_timeout(const std::string& name) {
    constexpr std::array<std::string_view, 12> names{"reference", "trajectory",   "find",   "singularities",
                                                     "radius",    "elliptic",     "verify", "table",
                                                     "series",    "coefficients", "study",  "asymptotics"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

int run_limited(const libration::subcommand& command, const libration::timeout_option& timeout) {
    const std::string name = command.options->get_name();
    if (!has_timeout(name)) {
        return run(command);
    }
    std::unique_ptr<libration::time_limit> limit;
    const libration::subcommand limited{command.options,
                                        [&] {
                                            limit = timeout.begin(name != "study", name != "find");
                                            return command.run();
                                        },
                                        command.has};
    return run(limited);
}

// Help and version, which CLI11 writes to stdout.
int say_help(const CLI::App& program, const CLI::ParseError& problem) {
    const int code = program.exit(problem);
    std::cout.flush();
    return std::cout ? code : complain("stdout cannot be written", failed);
}

int run_words(int argc, char** argv) {
    const libration::whole_quotient_scope by_whole_sequences(libration::quotient_by_flint);
    CLI::App program(libration::program_description, "libration");
    libration::set_help_layout(program);
    program.set_version_flag("--version", libration::version_text());
    program.require_subcommand(1);
    program.set_help_all_flag("--help-all", "the options of all subcommands");
    const std::vector<libration::subcommand> commands{
        libration::period_command(program),        libration::coefficients_command(program),
        libration::trajectory_command(program),    libration::radius_command(program),
        libration::series_command(program),        libration::reference_command(program),
        libration::elliptic_command(program),      libration::table_command(program),
        libration::study_command(program),         libration::studies_command(program),
        libration::journal_command(program),       libration::figure_command(program),
        libration::claims_command(program),        libration::reproduce_command(program),
        libration::verify_command(program),        libration::cite_command(program),
        libration::find_command(program),          libration::problems_command(program),
        libration::singularities_command(program), libration::import_command(program),
        libration::asymptotics_command(program)};
    libration::timeout_option timeout;
    for (const libration::subcommand& each : commands) {
        if (has_timeout(each.options->get_name())) {
            timeout.add_to(*each.options);
        }
    }
    libration::add_examples(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return problem.get_exit_code() == 0 ? say_help(program, problem)
                                            : complain_of_usage(program, with_short_words(problem.what(), argc, argv));
    } catch (const libration::input_error& problem) {
        return complain_of_input(problem);
    }
    const auto chosen = std::find_if(commands.begin(), commands.end(),
                                     [](const libration::subcommand& each) { return each.options->parsed(); });
    return chosen != commands.end() ? run_limited(*chosen, timeout) : failed;
}

}  // namespace

void libration::prepare_for_failures() {
    set_failure_handler(end_process);
    const std::terminate_handler before = std::set_terminate(end_at_exception);
    usual_end = before == end_at_exception ? usual_end : before;
}

int libration::run_program(int argc, char** argv) {
    prepare_for_failures();
    try {
        return run_words(argc, argv);
    } catch (const std::bad_alloc&) {
        end_process(failure_kind::no_memory);
        return failed;
    }
}
