// The order of the modules (CONTRIBUTING.md): an #include refers to the file's directory or to one further left. And
// mathematics written once for every scalar contains no double: no floating literal, no numeric_limits<T>.
//
// The rules work on a house, a map from path to text, so that the tests can also construct one that violates them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace house_include_direction_test {

namespace {

namespace fs = std::filesystem;

using house = std::map<std::string, std::string>;  // path relative to the top, with slashes -> text
using complaints = std::vector<std::string>;

// The module of a file: its directory, without include/libration/ or src/libration/ if it belongs to the library.
// "library" contains the umbrella headers.
std::string room(const std::string& path) {
    const auto folder = fs::path(path).parent_path().generic_string();
    if (folder == "include/libration") return "library";
    for (const std::string half : {"include/libration/", "src/libration/"})
        if (folder.starts_with(half)) return folder.substr(half.size());
    return folder;
}

using rooms = std::set<std::string>;

rooms operator+(rooms some, const rooms& more) {
    some.insert(more.begin(), more.end());
    return some;
}

// Verbs and interfaces use solutions and tables of motions, and include nothing of the pendulum itself.
rooms without_pendulum(rooms some) {
    std::erase_if(some, [](const std::string& name) { return name.starts_with("pendulum"); });
    return some;
}

// Each module with the modules that it may include besides itself.
std::map<std::string, rooms> order_of_rooms() {
    const rooms scalar{"scalar"},
        numbers = scalar + rooms{"scalar/text"}, digits = numbers + rooms{"digits"},
        balls = digits + rooms{"scalar/ball", "digits/proved"}, series = digits + rooms{"series"},
        functions{"function", "function/elementary", "function/special"}, algebra = series + rooms{"algebra"},
        approximant = algebra + rooms{"approximant"}, estimate = algebra + rooms{"convergence/estimate"},
        list = estimate + rooms{"convergence/list"}, test = list + rooms{"convergence/test"},
        convergence = test + rooms{"convergence"},
        ode = convergence + approximant + functions + rooms{"convergence/known", "ode", "ode/domain"},
        elliptic = digits + rooms{"elliptic"},
        // The pendulum: motion -> energy -> time -> solution -> singularity -> taylor, and the modules above them.
        motion = ode + elliptic + rooms{"pendulum/motion"}, energy = motion + rooms{"pendulum/energy"},
        time = energy + rooms{"pendulum/time"}, solution = time + rooms{"pendulum/solution"},
        singularity = solution + rooms{"pendulum/singularity"}, taylor = singularity + rooms{"pendulum/taylor"},
        arc = taylor + rooms{"pendulum/arc"},
        proofs = balls + functions +
                 rooms{"function/ball",
                       "approximant/proved",
                       "elliptic/proved",
                       "ode/ball",
                       "ode/singularity",
                       "ode/rigorous/control",
                       "ode/rigorous/matrix",
                       "ode/rigorous",
                       "ode/rigorous/nodes",
                       "ode/rigorous/certificate",
                       "ode/rigorous/coordinates",
                       "ode/stiff",
                       "ode/proved",
                       "ode/proved/equilibrium",
                       "ode/proved/sets",
                       "ode/hybrid",
                       "ode/hybrid/proved",
                       "ode/delay",
                       "ode/delay/proved"},
        numerical = arc + rooms{"pendulum/numerical"},
        pendulum = numerical + proofs +
                   rooms{"pendulum", "pendulum/proved", "pendulum/sampler", "pendulum/error", "pendulum/error/proved"},
        problem = ode + proofs + rooms{"approximant/asymptotic", "ode/batch", "problem"},
        library =
            pendulum + problem + rooms{"problem/known", "problem/known/proved", "problem/solution", "verify/proved"},
        // The basis of every study and command does not depend on the pendulum.
        text = problem + rooms{"src/command/text"}, run = text + rooms{"src/command/run"},
        option = run + rooms{"src/command/option"}, equation = option + rooms{"src/command/equation"},
        journal = equation + rooms{"src/command/journal"}, sweep = journal + rooms{"src/command/sweep"},
        study = sweep + library, list_command = study + rooms{"src/command/list"},
        command = list_command + rooms{"src/command/motion"};
    return {
        {"scalar", {}},
        {"scalar/text", scalar},
        {"scalar/number", scalar + functions},
        {"function", series + functions},
        {"function/elementary", rooms{"function"}},
        {"function/special", rooms{"function"}},
        {"function/ball", balls + functions},
        {"scalar/vector", scalar},
        {"scalar/ball", numbers},
        {"digits", numbers},
        {"digits/proved", balls},
        {"series", digits},
        {"algebra", series},
        {"approximant", algebra},
        {"approximant/asymptotic", approximant},
        {"approximant/proved", approximant + balls},
        {"convergence/estimate", algebra},
        {"convergence/list", estimate},
        {"convergence/test", list},
        {"convergence", test},
        {"convergence/known", convergence + approximant + rooms{"ode"}},
        {"ode", convergence + approximant + functions + rooms{"ode/domain"}},
        {"ode/domain", convergence + approximant + functions + rooms{"ode"}},
        {"ode/text", ode + rooms{"ode/hybrid"}},
        {"ode/implicit", ode},
        {"ode/batch", ode},
        {"ode/ball", ode + balls + rooms{"function/ball"}},
        {"ode/singularity", ode},
        {"ode/rigorous/matrix", balls},
        {"ode/rigorous/control", {}},
        {"ode/rigorous", ode + balls + rooms{"ode/ball", "ode/rigorous/control", "ode/rigorous/matrix"}},
        {"ode/rigorous/nodes", ode + balls + rooms{"ode/ball", "ode/rigorous/matrix", "ode/rigorous"}},
        {"ode/rigorous/sets", ode + balls + rooms{"ode/ball", "ode/rigorous"}},
        {"ode/rigorous/certificate", ode + balls + rooms{"ode/ball", "ode/rigorous"}},
        {"ode/rigorous/coordinates", ode + balls + rooms{"ode/ball", "ode/rigorous"}},
        {"ode/stiff", ode + balls + rooms{"ode/rigorous/control", "ode/rigorous/matrix", "ode/rigorous"}},
        {"ode/proved", ode + balls +
                           rooms{"ode/ball", "ode/rigorous/matrix", "ode/rigorous", "ode/rigorous/coordinates",
                                 "ode/singularity", "ode/hybrid"}},
        {"ode/proved/events", ode + balls + rooms{"ode/ball", "ode/rigorous", "ode/proved"}},
        {"ode/hybrid", ode},
        {"ode/delay", ode},
        {"ode/delay/proved",
         ode + balls + rooms{"ode/ball", "ode/rigorous", "ode/proved", "ode/proved/events", "ode/delay"}},
        {"ode/hybrid/proved",
         ode + balls + rooms{"ode/ball", "ode/rigorous", "ode/proved", "ode/proved/events", "ode/hybrid"}},
        {"ode/proved/equilibrium",
         ode + balls + rooms{"ode/ball", "ode/rigorous/matrix", "ode/rigorous", "ode/proved"}},
        {"ode/proved/sets", ode + balls + rooms{"ode/ball", "ode/rigorous", "ode/proved", "ode/proved/sets/models"}},
        {"ode/proved/sets/models", ode + balls + rooms{"ode/ball", "ode/rigorous", "ode/proved"}},
        {"ode/proved/shooting", ode + balls + rooms{"ode/ball", "ode/rigorous/matrix", "ode/rigorous", "ode/proved"}},
        {"elliptic", digits},
        {"elliptic/proved", elliptic + balls},
        {"pendulum/motion", ode + elliptic},
        {"pendulum/energy", motion},
        {"pendulum/time", energy},
        {"pendulum/solution", time},
        {"pendulum/singularity", solution},
        {"pendulum/taylor", singularity},
        {"pendulum/arc", taylor},
        {"pendulum/proved", numerical + proofs + rooms{"pendulum", "pendulum/error", "pendulum/error/proved"}},
        {"pendulum/sampler", taylor},
        {"pendulum/numerical", ode},
        {"pendulum/error", numerical},
        {"pendulum/error/proved", numerical + proofs + rooms{"pendulum/error"}},
        {"pendulum", numerical + rooms{"pendulum/error", "pendulum/sampler"}},
        {"problem", ode + proofs + rooms{"approximant/asymptotic", "ode/batch"}},
        {"problem/known", pendulum + problem + rooms{"problem/known/proved", "problem/solution"}},
        {"problem/known/proved", ode + proofs},
        {"problem/solution", problem},
        {"verify/proved", pendulum + problem},
        {"library", library},
        {"src/interface/c", without_pendulum(library)},
        {"src/interface", {}},
        {"src/interface/python", rooms{"src/interface"}},
        {"src/libration", {}},
        {"src/import", {}},
        {"src/command/text", problem},
        {"src/command/run", text + rooms{"scalar/vector"}},
        {"src/command/option", run},
        {"src/command/equation", option},
        {"src/command/journal", equation},
        {"src/command/sweep", journal},
        {"src/command/claims", study},
        {"src/command/list", study},
        {"src/command/plot", list_command},
        {"src/command/motion", list_command},
        {"src/command/table", command},
        {"src/command/verify", command + rooms{"src/command/table"}},
        {"src/command/find", command},
        {"src/command/report", command + rooms{"src/command/claims", "src/command/table"}},
        {"src/command/verb",
         without_pendulum(command) + rooms{"src/command/claims", "src/command/plot", "src/command/table",
                                           "src/command/verify", "src/command/report", "src/command/find"}},
        {"src/command", command + rooms{"src/command/claims", "src/command/plot", "src/command/table",
                                        "src/command/verify", "src/command/report"}},
        {"src/command/mpi", study + rooms{"src/command"}},
        {"studies/shared", study},
        {"studies", study + rooms{"studies/shared"}},
        {"studies/pendulum", study + rooms{"studies/shared"}},
        {"studies/proved", study + rooms{"studies/shared"}},
    };
}

const std::map<std::string, rooms>& order() {
    static const std::map<std::string, rooms> allowed = [] {
        auto all = order_of_rooms();
        for (auto& [name, others] : all) others.insert(name);
        return all;
    }();
    return allowed;
}

bool is_source(const std::string& path) { return path.ends_with(".hpp") || path.ends_with(".cpp"); }

// The file of the repository that an #include in `from` means, or "" for an external one. <...> and "..." are both
// looked up as by the compiler: in the directory of the file, then in include/, src/ and src/command/.
std::string included_file(const house& all, const std::string& from, const std::string& name) {
    const auto beside = (fs::path(from).parent_path() / name).lexically_normal().generic_string();
    for (const auto& candidate : {beside, "include/" + name, "src/" + name, "src/command/" + name})
        if (all.contains(candidate)) return candidate;
    return {};
}

complaints backward_includes(const house& all) {
    static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])", std::regex::multiline);
    // Not linked by libration::libration. The public headers need only the standard library, Boost, MPFR and GMP.
    static const std::regex only_for_the_command("(fmt|CLI|nlohmann)/.*|precompiled.hpp|version.hpp");
    complaints found;
    for (const auto& [path, text] : all) {
        if (!is_source(path)) continue;
        const auto here = order().find(room(path));
        if (here == order().end()) {
            found.push_back(path + " is in a folder without a place in the order");
            continue;
        }
        for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator();
             ++match) {
            const std::string name = (*match)[1];
            const auto target = included_file(all, path, name);
            if (target.empty() && name.starts_with("libration/"))
                found.push_back(path + " includes " + name + ", which does not exist");
            else if (path.starts_with("include/") && std::regex_match(name, only_for_the_command))
                found.push_back(path + " includes " + name + ", which a user of the headers does not have");
            else if (!target.empty() && !here->second.contains(room(target)))
                found.push_back(path + " includes " + target + ", which comes later in the order");
        }
    }
    return found;
}

// The code alone: comments, strings and characters are replaced by spaces, line breaks stay.
std::string without_comments_and_strings(const std::string& text) {
    std::string code = text;
    const auto blank = [&code](std::size_t begin, std::size_t end) {
        for (end = std::min(end, code.size()); begin < end; ++begin)
            if (code[begin] != '\n') code[begin] = ' ';
        return end;
    };
    const auto behind = [&text](const std::string& what, std::size_t from) {
        const auto at = text.find(what, from);
        return at == std::string::npos ? text.size() : at + what.size();
    };
    for (std::size_t i = 0; i < text.size();) {
        const auto two = text.substr(i, 2);
        const bool after_word =
            i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
        if (two == "//") {
            i = blank(i, std::min(text.find('\n', i), text.size()));
        } else if (two == "/*") {
            i = blank(i, behind("*/", i + 2));
        } else if (two == "R\"" && !after_word) {
            const auto open = text.find('(', i);
            i = blank(i, behind(")" + text.substr(i + 2, open - i - 2) + "\"", open));
        } else if (text[i] == '"' || (text[i] == '\'' && !after_word)) {  // a quote after a digit separates digits
            auto end = i + 1;
            while (end < text.size() && text[end] != text[i]) end += text[end] == '\\' ? 2 : 1;
            i = blank(i, end + 1);
        } else {
            ++i;
        }
    }
    return code;
}

// Doubles in templated code: literals like 0.5 or 1e-3, and conversions through double. numeric_limits<T> is
// specialized for some scalars only, so only scalar/ may use it, where it defines digits<T>() and epsilon<T>().
complaints doubles(const house& all) {
    static const std::string hexadecimal = R"re(0[xX][\da-fA-F']*\.?[\da-fA-F']*[pP][-+]?\d+)re",  // 0x1p-3
        point = R"re((?:\d[\d']*\.[\d']*|\.\d[\d']*)(?:[eE][-+]?\d+)?)re",                         // 0.1, 2., .5, 1.5e3
        exponent = R"re(\d[\d']*[eE][-+]?\d+)re",                                                  // 1e-3
        calls = R"re(std::(?:sto(?:f|d|ld)|strto(?:f|d|ld)|atof)\b|\bnumeric_limits\s*<\s*T\s*>)re",
                             not_inside_a_name = R"re((?:^|[^\w.']))re";
    static const std::regex suspect(not_inside_a_name + "(" + hexadecimal + "|" + point + "|" + exponent + ")|(" +
                                    calls + ")");
    complaints found;
    for (const auto& [path, text] : all) {
        if (!path.starts_with("include/") || !is_source(path)) continue;
        const auto code = without_comments_and_strings(text);
        for (auto match = std::sregex_iterator(code.begin(), code.end(), suspect); match != std::sregex_iterator();
             ++match) {
            const auto group = (*match)[1].matched ? 1U : 2U;
            if ((*match)[group].str().starts_with("numeric_limits") && room(path) == "scalar") continue;
            const auto line = 1 + std::count(code.begin(), code.begin() + match->position(group), '\n');
            found.push_back(path + ":" + std::to_string(line) + ": " + (*match)[group].str());
        }
    }
    return found;
}

// Switches over an enumeration of the library that do not name all of it, and kinds that are compared by their order: a
// new kind of node, function or operation would silently be taken for another. `default:` is for numbers and
// characters. In the library the compiler checks the same by -Wswitch-enum, which also detects a missing branch.
complaints unnamed_kinds(const house& all) {
    static const std::regex named_case(R"(\bcase\s+[A-Za-z_])"),
        order(R"(\s[<>]=?\s(?:\w+::)*(?:node_kind|operation|function_kind|atom_kind)::\w)");
    complaints found;
    for (const auto& [path, text] : all) {
        if (!path.starts_with("include/") && !path.starts_with("src/libration/")) continue;
        const auto code = without_comments_and_strings(text);
        const auto complain = [&](std::size_t at, const std::string& about) {
            const auto line = 1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n');
            found.push_back(path + ":" + std::to_string(line) + ": " + about);
        };
        for (auto at = code.find("default:"); at != std::string::npos; at = code.find("default:", at + 1)) {
            const auto opened = code.rfind("switch", at);
            if (opened != std::string::npos && std::regex_search(code.substr(opened, at - opened), named_case))
                complain(at, "a default of named kinds");
        }
        for (auto match = std::sregex_iterator(code.begin(), code.end(), order); match != std::sregex_iterator();
             ++match)
            complain(static_cast<std::size_t>(match->position()), "kinds compared by their order");
    }
    return found;
}

// Headers that compile only with FLINT are in separate modules, and no other header includes them; the umbrella header
// proved.hpp includes all of them.
bool needs_flint(const std::string& path) {
    const auto folder = fs::path(path).parent_path().filename();
    return path == "include/libration/proved.hpp" ||
           (path.starts_with("include/") && (folder == "ball" || folder == "rigorous" || folder == "certificate" ||
                                             path.find("/proved/") != std::string::npos));
}

complaints flint_includes(const house& all) {
    static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])", std::regex::multiline);
    static const std::regex flint("(flint/.*|arb|arf|mag|acb|fmpz|fmpq)\\.?.*\\.h");
    complaints found;
    for (const auto& [path, text] : all) {
        if (!path.starts_with("include/") || needs_flint(path)) continue;
        for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator();
             ++match) {
            const std::string name = (*match)[1];
            if (needs_flint(included_file(all, path, name)) || std::regex_match(name, flint))
                found.push_back(path + " includes " + name + ", which needs FLINT");
        }
    }
    return found;
}

house this_house() {
    const fs::path top = LIBRATION_SOURCE_DIR;
    house all;
    for (const auto* folder : {"include", "src", "studies"}) {
        if (!fs::exists(top / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
            const auto path = entry.path().lexically_relative(top).generic_string();
            if (!entry.is_regular_file() || !is_source(path)) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            all[path] = std::string(std::istreambuf_iterator<char>(file), {});
        }
    }
    return all;
}

std::string lines(const complaints& found) {
    std::ostringstream out;
    for (const auto& complaint : found) out << complaint << '\n';
    return out.str();
}

}  // namespace

TEST_CASE("no #include points backwards", "[house]") {
    const auto all = this_house();
    REQUIRE_FALSE(all.empty());
    const auto found = backward_includes(all);
    INFO(lines(found));
    CHECK(found.empty());
}

TEST_CASE("a program that stops at mpfr needs no FLINT", "[house]") {
    const auto found = flint_includes(this_house());
    INFO(lines(found));
    CHECK(found.empty());
    const std::string ball = "include/libration/scalar/ball/ball.hpp",
                      value = "include/libration/scalar/ball/value.hpp",
                      elliptic = "include/libration/elliptic/jacobi.hpp";
    CHECK(flint_includes({{ball, "#include \"libration/scalar/ball/value.hpp\"\n"}, {value, "#include <arb.h>\n"}})
              .empty());
    CHECK(flint_includes({{ball, ""}, {elliptic, "#include \"libration/scalar/ball/ball.hpp\"\n"}}).size() == 1);
    CHECK(flint_includes({{elliptic, "#include <flint/arb.h>\n#include <arb.h>\n#include <array>\n"}}).size() == 2);
}

TEST_CASE("no room holds more than 25 sources", "[house]") {
    std::map<std::string, int> sources;
    for (const auto& [path, text] : this_house()) ++sources[fs::path(path).parent_path().generic_string()];
    for (const auto& [folder, count] : sources) {
        INFO(folder);
        CHECK(count <= 25);
    }
}

TEST_CASE("each switch over kinds names all of them", "[house]") {
    const auto found = unnamed_kinds(this_house());
    INFO(lines(found));
    CHECK(found.empty());
    const std::string path = "src/libration/ode/tape.cpp";
    CHECK(unnamed_kinds({{path, "switch (k) { case operation::sum: return 1; default: return 0; }"}}).size() == 1);
    CHECK(unnamed_kinds({{path, "switch (k) { case sum: return 1; default: return 0; }"}}).size() == 1);
    CHECK(unnamed_kinds({{path, "switch (c) { case 'a': case 1: return 1; default: return 0; }"}}).empty());
    CHECK(unnamed_kinds({{path, "return a.kind < operation::product || b >= node_kind::sum;"}}).size() == 2);
}

TEST_CASE("no double hides in the templated headers", "[house]") {
    const auto found = doubles(this_house());
    INFO(lines(found));
    CHECK(found.empty());
}

TEST_CASE("a crooked house is noticed", "[house]") {
    const std::string scalar = "include/libration/scalar/quad.hpp",
                      series = "include/libration/series/power_series.hpp",
                      approximant = "include/libration/approximant/pade.hpp",
                      convergence = "include/libration/convergence/radius_verdict.hpp",
                      elliptic = "include/libration/elliptic/jacobi.hpp",
                      pendulum = "include/libration/pendulum/energy/period.hpp", sweep = "src/command/sweep/study.hpp",
                      problem = "include/libration/problem/problem_family.hpp",
                      known = "include/libration/problem/known/pendulum.hpp", study = "studies/error_norm.cpp",
                      command = "src/command/main.cpp";
    const house straight{{scalar, ""},   {series, ""},   {approximant, ""}, {convergence, ""},
                         {elliptic, ""}, {pendulum, ""}, {problem, ""},     {known, ""},
                         {sweep, ""},    {study, ""},    {command, ""}};
    const auto complaints_if = [&](const std::string& from, const std::string& line) {
        auto crooked = straight;
        crooked[from] = "#pragma once\n" + line + "\n";
        return backward_includes(crooked);
    };
    const auto include = [](const std::string& to) {
        const std::string searched = "src/command/";
        return to.starts_with("include/") ? "#include <" + to.substr(8) + ">"
               : to.starts_with(searched) ? "#include \"" + to.substr(searched.size()) + "\""
                                          : "#include \"../" + to + "\"";
    };

    SECTION("straight") {
        for (const auto& [from, to] : {std::pair{series, scalar},
                                       {approximant, series},
                                       {convergence, series},
                                       {elliptic, scalar},
                                       {pendulum, elliptic},
                                       {pendulum, convergence},
                                       {sweep, problem},
                                       {problem, convergence},
                                       {known, pendulum},
                                       {study, sweep},
                                       {study, pendulum},
                                       {command, sweep},
                                       {command, pendulum}}) {
            INFO(from << " -> " << to);
            CHECK(complaints_if(from, include(to)).empty());
        }
        CHECK(complaints_if(sweep, "#include \"sweep/study.hpp\"").empty());
        CHECK(complaints_if(scalar, "#include <cmath>\n#include <boost/multiprecision/mpfr.hpp>").empty());
    }
    SECTION("backward") {
        for (const auto& [from, to] : {std::pair{scalar, series},
                                       {series, elliptic},
                                       {series, approximant},
                                       {approximant, convergence},
                                       {convergence, approximant},
                                       {approximant, elliptic},
                                       {elliptic, series},
                                       {elliptic, pendulum}}) {
            INFO(from << " -> " << to);
            CHECK(complaints_if(from, include(to)).size() == 1);
        }
        for (const std::string& general :
             {std::string("src/command/text/table.hpp"), std::string("src/command/run/progress.hpp"),
              std::string("src/command/option/options.hpp"), sweep}) {
            INFO(general);
            CHECK(complaints_if(general, include(pendulum)).size() == 1);
            CHECK(complaints_if(general, include(known)).size() == 1);
        }
        CHECK(complaints_if(problem, include(pendulum)).size() == 1);
        CHECK(complaints_if("src/command/verb/period.cpp", include(pendulum)).size() == 1);
        CHECK(complaints_if("src/interface/c/motions.cpp", include(pendulum)).size() == 1);
        CHECK(complaints_if("src/interface/python/module.cpp", include(pendulum)).size() == 1);
        CHECK(complaints_if(sweep, "  #  include \"../main.cpp\" // indented").size() == 1);
        CHECK(complaints_if(sweep, include(study).replace(10, 3, "../../../")).size() == 1);
        CHECK(complaints_if(study, "#include \"../src/command/main.cpp\"").size() == 1);
        CHECK(complaints_if(scalar, "#include \"../series/power_series.hpp\"").size() == 1);
        CHECK(complaints_if(pendulum, "#include \"sweep/study.hpp\"").size() == 1);
    }
    SECTION("unknown") {
        CHECK(complaints_if("include/libration/utils/all.hpp", "").size() == 1);
        CHECK(complaints_if(scalar, "#include <libration/scalar/gone.hpp>").size() == 1);
        CHECK(complaints_if(scalar, "#include <fmt/format.h>").size() == 1);
    }
}

TEST_CASE("a double is noticed in code, and in code only", "[house]") {
    const auto found_in = [](const std::string& code) {
        return doubles({{"include/libration/scalar/x.hpp", code}}).size();
    };
    for (const std::string code :
         {"x = 0.1;", "x=2.0*y", "x = 1e-3", "x = 1E5;", "f(.5)", "x = 2.;", "x = 1'000.5;", "x = 0x1p-3;", "x = 1.5f",
          "x = -3.25L", "auto y = T(0.5);", "std::stod(text)", "R\"(text)\" + 0.5", "'\"' + 0.5"}) {
        INFO(code);
        CHECK(found_in(code) == 1);
    }
    for (const std::string code : {"x = 1;", "x = 1'000'000;", "x = 0xE5;", "x = 12ull;", "// 0.1", "/* 1e-3\n 0.5 */",
                                   "f(\"0.1\")", "R\"(0.1 \" 0.2)\"", "c = '.'; d = '\\''; e = \"0.5\";", "a1e5",
                                   "v2.size()", "x_1e3", "pack...", "std::numeric_limits<double>::digits", "f(1, 2)"}) {
        INFO(code);
        CHECK(found_in(code) == 0);
    }
    CHECK(doubles({{"src/command/main.cpp", "x = 0.1;"}}).empty());
    CHECK(doubles({{"include/libration/series/x.hpp", "std::numeric_limits<T>::digits"}}).size() == 1);
    CHECK(found_in("std::numeric_limits<T>::digits") == 0);
    CHECK(doubles({{"include/libration/scalar/x.hpp", "//\n\nx = 0.1;"}}) ==
          complaints{"include/libration/scalar/x.hpp:3: 0.1"});
}

}  // namespace house_include_direction_test
