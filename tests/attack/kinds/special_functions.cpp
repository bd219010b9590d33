// Solutions by special functions, whose values mpmath computed: tests/reference/special_solutions.csv.
#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "attack/question.hpp"
#include "libration/number/exact.hpp"

namespace libration::attack {

namespace {

// The digits of the table, less those by which a value is judged.
constexpr long most_digits = 215;

struct tabulated_value {
    std::string problem;
    rational from, at;  // the initial time, and that of the value
    rational value;     // of the first unknown
};

// The initial time of a text: that of its last initial value, name(time) = value.
rational initial_time(const std::string& problem) {
    const std::size_t end = problem.rfind(") = ");
    const std::size_t begin = problem.rfind('(', end) + 1;
    return read_exact(problem.substr(begin, end - begin)).coefficient;
}

std::vector<tabulated_value> read_table() {
    const std::string path = LIBRATION_REFERENCE_DIR "/special_solutions.csv";
    std::ifstream file(path);
    std::vector<tabulated_value> table;
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(" | ");
        const std::size_t second = line.find(" | ", first + 3);
        const std::string problem = line.substr(0, first);
        table.push_back({problem, initial_time(problem), typed_fraction(line.substr(first + 3, second - first - 3)),
                         typed_fraction(line.substr(second + 3))});
    }
    if (table.empty()) {
        throw std::runtime_error(path + " has no rows");
    }
    return table;
}

const tabulated_value& any_row(choices& next) {
    static const std::vector<tabulated_value> table = read_table();
    return table[next.below(table.size())];
}

bool reaches(const component& u, const rational& since) {
    constexpr double part = 0.9;
    const auto time = since.convert_to<double>();
    return -part * u.backward < time && time < part * u.forward;
}

// The unknown of the table, and u before it if u exists until then.
solved_problem with_component(const tabulated_value& row, const component& u) {
    const rational since = row.at - row.from;
    solved_problem made;
    made.origin = row.from;
    made.text = row.problem;
    if (reaches(u, since)) {
        made.text = fmt::format("u' = {}; u({}) = {}; {}", u.slope("u", "(t-(" + row.from.str() + "))"), row.from.str(),
                                u.start.text, row.problem);
        made.columns = {"u"};
        made.values = {u.value};
    }
    made.columns.push_back(row.problem.substr(0, 1));
    made.values.emplace_back([&row](const mpfr&) { return real(row.value); });
    return made;
}

}  // namespace

outcome ask_special_function(choices& next) {
    const tabulated_value& row = any_row(next);
    component beside = any_component(next);
    beside.forward = next.one_in(2) ? beside.forward : 0;  // half of them alone
    const long digits = std::min(any_digits(next), most_digits);
    return asked_values(with_component(row, beside), row.at - row.from, digits,
                        [](const std::string&) { return verdict::refused; });
}

}  // namespace libration::attack
