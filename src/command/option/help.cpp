#include "option/help.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace libration {

namespace {

constexpr std::size_t widest_column = 100;
constexpr std::size_t narrowest_column = 50;
constexpr std::size_t help_column = 30;

// The last column of a line: that of the terminal, or of COLUMNS, if it is narrower than the usual one.
std::size_t last_column() {
    winsize window{};
    std::size_t columns = widest_column;
    if (const char* const given = std::getenv("COLUMNS"); given != nullptr) {
        columns = std::strtoul(given, nullptr, 10);
    } else if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0) {
        columns = window.ws_col;
    }
    return columns == 0 ? widest_column : std::clamp(columns, narrowest_column, widest_column);
}

// CLI11's layout with wrapped lines.
class wrapped_layout : public CLI::Formatter {
public:
    wrapped_layout() { column_width(help_column); }

    // CLI11 ends the last group that is shown with a blank line of its own if hidden options follow.
    std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override {
        std::string text = Formatter::make_help(command, std::move(name), mode);
        for (auto at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n", at)) {
            text.erase(at, 1);
        }
        return text;
    }
    // Defaults are in the descriptions, all in one form.
    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text = Formatter::make_option_opts(option);
        const std::string usual = "=" + option->get_default_str();
        if (const auto at = text.find(usual); usual.size() > 1 && at != std::string::npos) {
            text.erase(at, usual.size());
        }
        return text;
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        const std::string usual = option->get_default_str();
        return Formatter::make_option_desc(option) + (usual.empty() ? "" : " (default: " + usual + ")");
    }
    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        return wrapped(Formatter::make_option(option, is_positional), help_column);
    }
    std::string make_subcommand(const CLI::App* command) const override {
        return wrapped(Formatter::make_subcommand(command), help_column);
    }
    std::string make_description(const CLI::App* command) const override {
        return wrapped(Formatter::make_description(command), 0);
    }
};

// The examples by subcommand; the first may make the files that the second reads. tests/command/help_test.cpp runs
// them.
using example_pair = std::pair<std::string, std::string>;
const std::map<std::string, example_pair>& examples() {
    static const std::map<std::string, example_pair> all{
        {"libration",
         {"reference --theta0 150deg --omega0 0 --time 1e12 --digits 50",
          "radius --problem \"x' = 1 + x^2; x(0) = 0\" --prove --digits 12"}},
        {"period", {"period --theta0 90deg --omega0 0 --digits 50", "period --gap 1e-30 --digits 50"}},
        {"coefficients",
         {"coefficients --energy 1.37 --method resummed --order 13 --digits 40",
          "coefficients --problem lorenz --order 8 --digits 20"}},
        {"trajectory",
         {"trajectory --energy 2.02 --times 0:20:5 --scalar mpfr:30",
          "trajectory --problem \"x'' = -x^3; x(0)=1; x'(0)=0\" --times 0:2:5 --digits 20"}},
        {"radius",
         {"radius --energy 1.71 --order 100 --scalar mpfr:60",
          "radius --problem \"x' = 1 + x^2; x(0) = 0\" --prove --digits 12"}},
        {"series",
         {"coefficients --problem \"y' = y; y(0) = 1\" --order 30 --format csv --out list.csv",
          "series --coefficients list.csv --times 0:2:5"}},
        {"reference",
         {"reference --energy 1.71 --time 0.7,T/8 --digits 30", "reference --problem lorenz --time 1 --digits 20"}},
        {"elliptic", {"elliptic sn --u 3/2 --m 1/3 --digits 40", "elliptic K --m1 1e-30 --digits 40"}},
        {"table",
         {"table pendulum --gaps=1e-3,-1e-30 --times 1,T/8 --digits 20", "table sn,cn --u 0:2:5 --m 1/2 --digits 20"}},
        {"study",
         {"study error_norm --energies 0.5 --orders 5,10 --scalar double",
          "study error_norm --problem logistic --times 0:1:5 --orders 2,4,8"}},
        {"studies", {"studies", "studies error_norm"}},
        {"journal", {"study terms --energies 0.5 --digits 10 --out out", "journal out"}},
        {"figure", {"study terms --energies 0.5,1 --digits 5,10 --out out", "figure terms --out out"}},
        {"claims", {"claims pendulum_recurrence", "claims harmonic_limit --format csv --out claims.csv"}},
        {"reproduce",
         {"reproduce --only reference --out first", "reproduce --only reference --results first --out second"}},
        {"verify",
         {"table pendulum --energies 1/2 --times 1,2,3 --digits 20 --out mine.csv",
          "verify mine.csv --tolerance 1e-18"}},
        {"cite", {"cite", "cite | grep title"}},
        {"find",
         {"find --problem \"y' = k*y; y(0) = 1; k = 1\" --unknown k --such-that \"y(1) = 3\"",
          "find --problem \"y''=-e^y; y(0)=0; y'(0)=1/2\" --unknown \"y'(0)\" --such-that \"y(0)=y(1)\""}},
        {"problems", {"problems", "problems lorenz"}},
        {"import", {"import model.xml", "import model.xml | grep when"}},
        {"asymptotics",
         {"asymptotics --problem \"y' = 1 + y^2; y(0) = 0\" --order 1000001 --digits 30",
          "asymptotics --problem \"y' = y^3 + t; y(0) = 1\" --order 100,10000"}},
        {"singularities",
         {"singularities --problem \"x' = 1 + x^2; x(0) = 0\"", "singularities --problem painleve_1 --within 3"}}};
    return all;
}

// Where a line that is too long ends: before a blank, else after a comma; npos if neither is between `begin` and the
// last column.
std::size_t end_of_line(const std::string& line, std::size_t begin) {
    const std::size_t blank = line.rfind(' ', last_column());
    if (blank != std::string::npos && blank > begin) {
        return blank;
    }
    const std::size_t comma = line.rfind(',', last_column() - 1);
    return comma != std::string::npos && comma > begin ? comma + 1 : std::string::npos;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent) {
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(' ');
        while (line.size() > last_column()) {
            const std::size_t end = end_of_line(line, std::max(indent, first));
            if (end == std::string::npos) {
                break;
            }
            result += line.substr(0, end) + '\n';
            line = std::string(indent, ' ') + line.substr(line[end] == ' ' ? end + 1 : end);
        }
        result += line + '\n';
    }
    return result;
}

void set_help_layout(CLI::App& program) { program.formatter(std::make_shared<wrapped_layout>()); }

void add_examples(CLI::App& program) {
    const auto add = [](CLI::App& app) {
        const auto found = examples().find(app.get_name());
        if (found == examples().end()) {
            throw std::logic_error("no examples of " + app.get_name());
        }
        const auto& [first, second] = found->second;
        app.footer("Examples:\n    libration " + first + "\n    libration " + second);
    };
    add(program);
    for (CLI::App* const command : program.get_subcommands([](const CLI::App* /*all*/) { return true; })) {
        add(*command);
    }
}

}  // namespace libration
