#include "option/exclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "text/input_error.hpp"

namespace libration {

namespace {

using rules = std::vector<option_rule>;

constexpr const char* options_of_motion = "--energy --gap --theta0 --omega0 --direction --length --gravity";
constexpr const char* motions_of_table = "--energies --gaps --theta0 --omega0 --direction --length --gravity";
constexpr const char* arguments_of_table = "--u --phi --x --z --n --k --m --m1 --alpha --q";
constexpr const char* without_problem = "has no meaning without --problem";
constexpr const char* not_with_sets = "is not supported with sets of initial values and parameters";
constexpr const char* not_with_delays = "is not supported for a problem with delays";
constexpr const char* not_with_events = "is not supported for a problem with events or a piecewise right-hand side";
constexpr const char* not_with_limits = "is not supported with conditions at infinity";
constexpr const char* add_problem = "add --problem P";
constexpr const char* add_until = "add --until \"x = 0\"";
constexpr const char* one_of_two = "give one of the two";
constexpr const char* leave_one = "leave one of them out";
constexpr const char* not_for_proof = "has no meaning for a proof about the initial point";
constexpr const char* not_certified =
    "contains a periodic orbit, or one solution of conditions such as y(1) = 2, and no branches, several guesses or "
    "limits";

const rules rules_of_all{{"--set --general --show", "!--problem", "requires --problem", add_problem}};

// Of a command whose solution is that of a problem, or a motion of the pendulum.
const rules problem_rules{
    {options_of_motion, "--problem", "applies to motions of the pendulum, not to a --problem", leave_one},
    {options_of_motion, "--coefficients", "is given together with --coefficients", "give a list or a motion, not both"},
};

// An energy or a state; the rows of a file complete what the options give.
const rules energy_rules{
    {"--gap", "--energy !--motions", "is given together with --energy '{}'", one_of_two},
    {"--omega0", "--energy|--gap !--motions", "is given together with an energy",
     "give --energy or --gap, or --theta0 and --omega0, not both"},
    {"--direction", "--theta0 --omega0 !--motions", "applies to --energy or --gap",
     "write the sign of the motion in --omega0"},
};

const rules motion_rules{
    {"", "!--energy|--gap|--theta0|--omega0 !--problem|--motions|--coefficients", "no motion is given",
     "add --energy E, --gap G, or --theta0 A with --omega0 W"},
    {"--theta0", "!--omega0|--energy|--gap|--motions", "alone does not determine a motion",
     "add --omega0 W or --energy E"},
    {"--omega0", "!--theta0|--motions", "alone does not determine a motion", "add --theta0 A"},
};

const rules reference_rules{
    {"--until --over --derivatives --trace --certificate --integrator --general", "limits", not_with_limits},
    {"--set", "limits list", "has a list of values, which is not supported with conditions at infinity",
     "give one value"},
    {"--integrator --derivatives --trace --certificate", "!--problem", without_problem},
    {"--until", "!--problem", "requires --problem", "leave it out, or write --problem pendulum"},
    {"--count --crossing --before --horizon --from-start --how-many", "!--until", "requires --until", add_until},
    {"--over --parts", "!--problem", "requires --problem", add_problem},
    {"--motions --rename --jobs", "--problem", "does not apply to --problem"},
    {"--rename", "!--motions", "requires --motions"},
    {"--times", "--until", "is given together with --until, which finds the times", "leave one out"},
    {"--over", "--times|--until", "is given together with --times or --until", "leave one out"},
    {"--derivatives --trace", "--until", "has no meaning for --until, which finds the times itself"},
    {"--how-many", "!--before", "requires a time", "add --before TIME"},
    {"--count --horizon --from-start --certificate --check --plot", "--how-many", "is not supported with --how-many"},
    {"--certificate", "--from-start", "contains the times after the initial point, and not that of --from-start"},
    {"--derivatives --trace --certificate --check --plot", "--over", "is not supported with --over"},
    {"--integrator --derivatives --trace", "--times=inf", "has no meaning for --time inf"},
    {"--certificate", "--times=inf", "does not contain --time inf"},
    {"--check", "--times=inf", "compares two proofs, and --time inf has only one"},
    {"", "!--times|--until|--over|--motions !--problem", "no times are given", "add --times LIST"},
    {"--parts", "!sets", "applies to sets of initial values and parameters",
     "leave it out, or write one as x(0) = [0.9, 1.1]"},
    {"--derivatives --trace --certificate --check --plot --from-start", "sets", not_with_sets},
    {"--times", "--times=inf sets", not_with_sets, "write finite times"},
    {"--set", "sets family", "has a list of values, which is not supported with sets of initial values and parameters",
     "give one value or one interval"},
    {"--set", "--over family", "has a list of values, which is not supported with --over", "give one value"},
    {"", "!--times|--until|--over sets", "no times are given",
     "add --times LIST, or --over A:B for all times of a span"},
    {"", "!--times|--until|--over|--motions", "no times are given", "add --times LIST, or --until \"x = 0\""},
    {"--certificate", "family", "is of one solution, and --set chooses several"},
    {"--certificate --trace --derivatives", "delays", not_with_delays},
    {"--certificate --trace", "events", not_with_events},
};

const rules trajectory_rules{
    {"--via --step --scale --integrator --general", "limits", not_with_limits},
    {"--order", "limits !--method", not_with_limits, "leave it out, or add --method asymptotic"},
    {"--set", "limits list", "has a list of values, which is not supported with conditions at infinity",
     "give one value"},
    {"--manifold", "!--problem", "is about an equilibrium of a --problem", add_problem},
    {"--manifold", "!--equilibrium", "is given without an equilibrium", "add --equilibrium \"x=0,y=0\""},
    {"--equilibrium", "!--manifold", "is given without --manifold", "add --manifold both"},
    {"--times --unknown --guess --method --order --via --step --scale --scalar --integrator --general", "--manifold",
     "has no meaning for --manifold"},
    {"", "!--times|limits|--manifold", "no times are given", "add --times LIST"},
    {"--integrator", "!--problem", without_problem},
    {"--via", "!--problem", "is a path in the complex t-plane of a --problem",
     "leave it out, or give the motion as --problem \"x'' = -sin(x); x(0) = 2; x'(0) = 0\""},
    {"--integrator", "--method=series|pade|endpoint|euler|gauge|asymptotic", "has no meaning for --method {}"},
    {"--method", "--method=series|pade|endpoint|euler|gauge|asymptotic --problem --via|complex",
     "is limited to real times", "leave --method out for complex ones"},
};

// Of a command with an expansion point.
const rules point_rules{
    {"--via", "!--problem", "is a path in the complex t-plane of a --problem"},
    {"--via", "!--at", "requires --at", "add --at POINT"},
};

const rules coefficients_rules{
    {"--method --recurrence", "--problem", "is about motions of the pendulum, not about a --problem"},
    {"--method", "--recurrence", "is given together with --recurrence", one_of_two},
    {"--at --via", "--method", "is not supported with --method {}, which is about the top"},
    {"--via --check", "--recurrence", "is not supported with --recurrence"},
    {"--check", "--method", "is not supported with --method"},
    {"--check", "!--problem", "requires --problem", "add one, or leave it out"},
    {"--check", "!--scalar=ball:*", "compares two proofs of the coefficients of a --problem",
     "add --scalar ball:DIGITS"},
    {"--at", "--scalar=rational --problem",
     "is not a point for fractions, which a solution has at its initial point only"},
    {"--at", "--scalar=ball:* --via|complex",
     "is reached by a path in the complex plane, which --scalar {} cannot prove", "use --scalar mpfr:DIGITS"},
};

const rules radius_rules{
    {"--prove", "!--problem", "is for differential equations", add_problem},
    {"--order --at --coefficients --scalar", "--prove", not_for_proof},
    {"--plot", "--prove", "draws coefficients, which --prove does not use", leave_one},
    {"--exact --rounded --audit --predict", "!--coefficients", "is about the numbers of a file",
     "add --coefficients FILE, or leave it out"},
    {"--exact", "--rounded", "contradicts --rounded {}", leave_one},
    {"--audit --predict", "--plot", "prints a table without a figure", leave_one},
    {"--audit", "--predict", "prints another table than --predict", leave_one},
    {"--biased", "--prove", not_for_proof},
    {"--check", "!--prove", "compares two proofs and requires --prove", "add it, or leave --check out"},
    {"--coefficients", "--problem", "is given together with --problem", "give one of them"},
    {"--at", "--coefficients", "is a point of a motion, which --coefficients do not have"},
    {"", "!--coefficients|--problem|--energy|--gap|--theta0|--omega0", "no coefficients are given",
     "add a motion (--energy E, --gap G, or --theta0 A with --omega0 W) and --order N, or --coefficients FILE"},
    {"", "!--order|--problem|--coefficients", "no --order is given", "add --order N, the last power of the series"},
};

const rules singularities_rules{
    {"", "!--problem", "no problem is given", add_problem},
    {"--check", "!--prove", "compares two proofs and requires --prove", "add it, or leave --check out"},
};

const rules asymptotics_rules{{"", "!--problem", "no problem is given", add_problem}};

const rules find_rules{
    {"", "!--problem", "no problem is given", add_problem},
    {"--periodic", "--unknown", "is given together with --unknown", leave_one},
    {"--eigenvalue", "--periodic|--unknown", "is given together with --periodic or --unknown", leave_one},
    {"--count", "!--eigenvalue", "requires --eigenvalue", "add --eigenvalue E, or leave it out"},
    {"--along --guess --certificate", "--eigenvalue", "is not supported with --eigenvalue", "leave it out"},
    {"", "!--periodic|--unknown|--eigenvalue|--homoclinic|limits", "nothing to find is given",
     "add --unknown S --such-that \"f'(5) = 1\", --eigenvalue E, or --periodic"},
    {"--homoclinic", "--such-that|--along|--certificate",
     "is given together with --such-that, --along or --certificate", leave_one},
    {"--along", "!--unknown", "is given without --unknown", "add --unknown S --such-that \"f'(5) = 1\""},
    {"--guess", "!--unknown", "is given without --unknown", "use --set for the initial point of --periodic"},
    {"--period --multipliers", "!--periodic", "is about a periodic orbit", "add --periodic"},
    {"--such-that", "--periodic", "is given together with --periodic", leave_one},
    {"--certificate", "--along|--guess|limits", not_certified},
};

const rules verify_rules{
    {"--certificate", "!--problem", "is of the solution of a --problem", add_problem},
    {"--problem --columns --tolerance --relative --ulp --rounding --inputs", "--coefficients",
     "is about the rows of a table, not about --coefficients"},
    {"FILE", "--coefficients", "is given together with --coefficients", leave_one},
    {"--modulo-2pi", "--problem", "has no meaning for --problem"},
    {"--ulp", "--tolerance|--relative", "is given together with --tolerance or --relative", one_of_two},
    {"--tolerance --relative --ulp", "--rounding", "is given together with --rounding, which is another tolerance",
     one_of_two},
};

const rules series_rules{
    {"--endpoint", "!--endpoint-values", "belongs to --endpoint-values",
     "add --endpoint-values f,f',... at that point"},
    {"--endpoint-values", "!--endpoint", "belongs to --endpoint", "add --endpoint X"},
    {"--method", "--method=endpoint !--endpoint", "matches values at another point",
     "add --endpoint X and --endpoint-values f,f',..."},
    {"--reference", "!--times", "has nothing to be compared with", "add --times LIST"},
    {"--exact", "--rounded", "contradicts --rounded {}", leave_one},
};

const rules study_rules{{"--fresh --shard", "!--out", "requires a directory for the journal", "add --out DIR"}};

const rules table_rules{
    {"--problem", "what", "comes together with the table {}", "give one of them"},
    {arguments_of_table, "what=pendulum", "has no meaning for the table {}"},
    {motions_of_table, "what !what=pendulum", "has no meaning for the table {}"},
    {"--times", "what !what=pendulum", "has no meaning for the table {}"},
    {arguments_of_table, "--problem", "has no meaning for the table of a problem"},
    {motions_of_table, "--problem", "has no meaning for the table of a problem"},
    {"--points --columns", "--problem", "has no meaning for the table of a problem"},
    {"--columns", "!--points", "is given without --points"},
    {arguments_of_table, "--points", "comes together with --points '{}'", "give it as a column of the file"},
    {motions_of_table, "--points", "comes together with --points '{}'", "give it as a column of the file"},
    {"", "what=pendulum !--energies|--gaps|--omega0|--points", "no motions are given",
     "add --energies LIST, --gaps LIST, or --theta0 LIST with --omega0 LIST"},
    {"--omega0", "--energies|--gaps", "comes together with --energies or --gaps",
     "give energies, or --theta0 and --omega0, not both"},
    {"--omega0", "!--theta0", "alone does not determine a motion", "add --theta0 LIST"},
    {"--direction", "--omega0", "goes with --energies or --gaps", "give the sign of the motion to --omega0"},
    {"", "what=pendulum !--times|--points", "no times are given", "add --times LIST"},
    {"", "--problem !--times", "no --times are given", "add --times such as 0,1.5,sqrt(2) or 0:20:201"},
};

const rules journal_rules{
    {"--check", "--export|--drop", "is given together with --export or --drop", "give one of them"},
    {"--export", "--drop", "is given together with --drop", "give one of them"}};

// The tables of a command, in the order in which they are checked.
const std::map<std::string, std::vector<rules>>& tables() {
    static const std::map<std::string, std::vector<rules>> all{
        {"period", {energy_rules, motion_rules}},
        {"trajectory", {problem_rules, trajectory_rules, energy_rules, motion_rules}},
        {"reference", {problem_rules, reference_rules, energy_rules, motion_rules}},
        {"radius", {problem_rules, radius_rules, point_rules, energy_rules, motion_rules}},
        {"coefficients", {problem_rules, point_rules, coefficients_rules, energy_rules, motion_rules}},
        {"singularities", {singularities_rules}},
        {"asymptotics", {asymptotics_rules}},
        {"find", {find_rules}},
        {"verify", {problem_rules, energy_rules, verify_rules}},
        {"series", {series_rules}},
        {"study", {study_rules}},
        {"table", {table_rules}},
        {"journal", {journal_rules}},
    };
    return all;
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool is_option(const std::string& word) { return word.starts_with("--"); }

std::string name_before_value(const std::string& term) { return term.substr(0, term.find('=')); }

// The argument of an option; std::nullopt if it is not given.
std::optional<std::string> value_of(const CLI::App& command, const std::string& option) {
    const CLI::Option* const found = command.get_option_no_throw(option);
    return found != nullptr && found->count() > 0 ? std::optional(found->results().front()) : std::nullopt;
}

bool fits(const std::string& value, const std::string& pattern) {
    return pattern.ends_with('*') ? value.starts_with(pattern.substr(0, pattern.size() - 1)) : value == pattern;
}

// One term without its `!`.
bool holds_plainly(const CLI::App& command, const std::string& term, const argument_property& has) {
    const auto equals = term.find('=');
    if (equals != std::string::npos) {
        const auto value = value_of(command, name_before_value(term));
        return value && std::ranges::any_of(parts_of(term.substr(equals + 1), '|'),
                                            [&](const std::string& each) { return fits(*value, each); });
    }
    return std::ranges::any_of(parts_of(term, '|'), [&](const std::string& each) {
        return value_of(command, each) || (!is_option(each) && has && has(each));
    });
}

bool holds(const CLI::App& command, const char* when, const argument_property& has) {
    return std::ranges::all_of(parts_of(when, ' '), [&](const std::string& term) {
        return term.starts_with('!') ? !holds_plainly(command, term.substr(1), has) : holds_plainly(command, term, has);
    });
}

[[noreturn]] void refuse(const CLI::App& command, const option_rule& rule, const std::string& option) {
    const std::string first = parts_of(rule.when, ' ').front();
    const std::string reason =
        fmt::format(fmt::runtime(rule.reason), value_of(command, name_before_value(first)).value_or(""));
    if (option.empty()) {
        throw input_error(reason + ": " + rule.remedy);
    }
    const bool has_value = command.get_option(option)->get_items_expected_max() > 0;
    if (!has_value) {
        throw input_error(option + " " + reason + ": " + rule.remedy);
    }
    throw input_error(option, *value_of(command, option), reason, rule.remedy);
}

void check(const CLI::App& command, const rules& all, const argument_property& has) {
    for (const option_rule& rule : all) {
        auto options = parts_of(rule.options, ' ');
        std::erase_if(options, [&](const std::string& each) { return !value_of(command, each); });
        const bool concerned = !options.empty() || *rule.options == '\0';
        if (concerned && holds(command, rule.when, has)) {
            refuse(command, rule, options.empty() ? "" : options.front());
        }
    }
}

}  // namespace

void check_combinations(const CLI::App& command, const argument_property& has) {
    check(command, rules_of_all, has);
    const auto found = tables().find(command.get_name());
    for (const rules& each : found == tables().end() ? std::vector<rules>() : found->second) {
        check(command, each, has);
    }
}

std::vector<std::string> options_in_tables() {
    std::vector<std::string> options;
    for (const auto& [name, all] : tables()) {
        for (const rules& table : all) {
            for (const option_rule& rule : table) {
                for (const std::string& each : parts_of(std::string(rule.options) + ' ' + rule.when, ' ')) {
                    const auto terms = parts_of(
                        name_before_value(each.substr(std::min(each.size(), each.find_first_not_of('!')))), '|');
                    std::ranges::copy_if(terms, std::back_inserter(options), is_option);
                }
            }
        }
    }
    return options;
}

}  // namespace libration
