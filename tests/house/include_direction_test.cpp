// The order of the modules (CONTRIBUTING.md): an #include refers to the file's module or to one further left. And
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
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace house_include_direction_test {

namespace {

namespace fs = std::filesystem;

using house = std::map<std::string, std::string>;  // path relative to the top, with slashes -> text
using complaints = std::vector<std::string>;

// The modules in their order, those of the library and of the programs: a file includes its own module and those to the
// left; a|b do not include each other.
const std::string order_of_modules =
    "scalar digits series algebra function number elliptic|approximant convergence equation expansion integration "
    "event hybrid plane manifold asymptotics query pendulum problem verification library interface|import|text run "
    "option "
    "problem_tables sweep studies|plot table verify paper verb command";
// These include nothing of the pendulum itself, although it comes before them; of the tables of a problem those named
// pendulum_tables do.
const std::set<std::string> general{"interface", "text", "run", "option", "problem_tables", "sweep", "verb"};
const std::set<std::string> pendulum_tables{"motion_cells", "motion_coefficients", "motion_options",
                                            "period_table", "solution_options",    "trajectory_points"};
// Subfolders include the plain files of their module; of their sisters only these.
const std::set<std::pair<std::string, std::string>> sisters{{"integration/box", "integration/taylor"},
                                                            {"integration/collocation", "integration/taylor"},
                                                            {"integration/delay", "integration/taylor"},
                                                            {"integration/model", "integration/taylor"},
                                                            {"integration/root", "integration/taylor"},
                                                            {"integration/root", "integration/singular"},
                                                            {"paper/report", "paper/claims"},
                                                            {"query/connection", "query/well"},
                                                            {"studies/pendulum", "studies/shared"},
                                                            {"studies/proved", "studies/shared"}};

// A path without its extension and the folders of the library: integration/taylor/step_length.
std::string place(const std::string& path) {
    const auto without = fs::path(path).replace_extension().generic_string();
    for (const std::string half : {"include/libration/", "src/libration/", "tests/"})
        if (without.starts_with(half)) return without.substr(half.size());
    return without;
}
std::string folder(const std::string& path) { return fs::path(place(path)).parent_path().generic_string(); }

std::string module_of(const std::string& path) {
    const std::string here = folder(path);
    if (here.empty()) return "library";  // the umbrella headers
    if (here == "src/command") return "command";
    if (here == "src/command/problem") return "problem_tables";
    for (const std::string outer : {"src/command/", "src/"})
        if (here.starts_with(outer)) return here.substr(outer.size(), here.find('/', outer.size()) - outer.size());
    return here.substr(0, here.find('/'));
}

// The position of a module in the order, if it has one.
std::optional<int> rank(const std::string& module) {
    std::istringstream words(order_of_modules);
    int position = 0;
    for (std::string word; words >> word; ++position)
        if (("|" + word + "|").find("|" + module + "|") != std::string::npos) return position;
    return std::nullopt;
}

bool may_include(const std::string& from, const std::string& to) {
    const std::string here = module_of(from), there = module_of(to);
    if (here == there) {
        const std::string a = folder(from), b = folder(to);
        const bool nested = a.starts_with(b) || b.starts_with(a);
        return here == "library" || nested || sisters.contains({a, b});
    }
    const bool of_pendulum =
        here == "problem_tables" && pendulum_tables.contains(fs::path(from).stem().generic_string());
    if (general.contains(here) && !of_pendulum && (there == "pendulum" || there == "library")) return false;
    if (general.contains(here) && !of_pendulum && here != "interface" && here != "verb" &&
        to.starts_with("include/libration/problem/known/"))
        return false;
    return rank(there) < rank(here);
}

bool is_source(const std::string& path) { return path.ends_with(".hpp") || path.ends_with(".cpp"); }

// The file of the repository that an #include in `from` means, or "" for an external one. <...> and "..." are both
// looked up as by the compiler: in the directory of the file, then in include/, src/, src/command/ and the top.
std::string included_file(const house& all, const std::string& from, const std::string& name) {
    const auto beside = (fs::path(from).parent_path() / name).lexically_normal().generic_string();
    for (const auto& candidate : {beside, "include/" + name, "src/" + name, "src/command/" + name, name})
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
        if (!rank(module_of(path))) {
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
            else if (!target.empty() && !may_include(path, target))
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
            if ((*match)[group].str().starts_with("numeric_limits") && module_of(path) == "scalar") continue;
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

// The headers that a header reaches, itself included, and the first of them that needs FLINT.
std::string first_with_flint(const house& all, const std::string& header) {
    static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])", std::regex::multiline);
    static const std::regex flint("(flint/.*|arb|arf|mag|acb|fmpz|fmpq)\\.?.*\\.h");
    std::set<std::string> reached{header};
    for (std::vector<std::string> open{header}; !open.empty();) {
        const std::string path = open.back();
        open.pop_back();
        const std::string& text = all.at(path);
        for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator();
             ++match) {
            const std::string name = (*match)[1];
            if (std::regex_match(name, flint)) return path;
            const auto target = included_file(all, path, name);
            if (!target.empty() && reached.insert(target).second) open.push_back(target);
        }
    }
    return {};
}

// include/libration/X/y.hpp, src/libration/X/y.cpp and tests/X/y_test.cpp share X: of a source or test the header or
// source of this name, if its module has one, is in the same folder.
complaints separated(const house& all, const house& tests) {
    std::map<std::string, std::set<std::string>> headers, sources;  // the folders of module/stem
    const auto in_library = [](const std::string& path) { return path.find("/libration/") != std::string::npos; };
    for (const auto& [path, text] : all) {
        if (!in_library(path)) continue;
        const std::string name = module_of(path) + "/" + fs::path(path).stem().generic_string();
        sources[name].insert(folder(path));
        if (path.ends_with(".hpp")) headers[name].insert(folder(path));
    }
    complaints found;
    const auto require_beside = [&](const std::string& path, const auto& others, const std::string& stem) {
        const auto of = others.find(module_of(path) + "/" + stem);
        if (of != others.end() && !of->second.contains(folder(path)))
            found.push_back(path + " is not in " + *of->second.begin());
    };
    for (const auto& [path, text] : all)
        if (in_library(path)) require_beside(path, headers, fs::path(path).stem().generic_string());
    for (const auto& [path, text] : tests) {
        const auto stem = fs::path(path).stem().generic_string();
        if (path.ends_with("_test.cpp")) require_beside(path, sources, stem.substr(0, stem.size() - 5));
    }
    return found;
}

// Two classes of one name in a namespace, outside of unnamed ones, are undefined behaviour, which no linker reports. Those of
// *_vectors.cpp are compiled for each processor, with all their functions inline.
complaints repeated_classes(const house& all) {
    static const std::regex space(R"(^namespace ([\w:]+) \{)");
    static const std::regex defined(R"(^(?:struct|class) (\w+)(?: final)?(?: :[^;]*)? \{)");
    std::map<std::string, std::string> first;
    complaints found;
    for (const auto& [path, text] : all) {
        if (!path.starts_with("include/libration/") && !path.starts_with("src/libration/")) continue;
        if (path.ends_with("_vectors.cpp")) continue;
        std::istringstream rest(text);
        std::string around;
        bool unnamed = false;
        for (std::string line; std::getline(rest, line);) {
            std::smatch match;
            if (std::regex_search(line, match, space)) around = match[1];
            unnamed = (unnamed || line == "namespace {") && line != "}  // namespace";
            if (unnamed || !std::regex_search(line, match, defined)) continue;
            const auto [place, is_new] = first.emplace(around + "::" + std::string(match[1]), path);
            if (!is_new && place->second != path)
                found.push_back(path + " defines " + place->first + ", as does " + place->second);
        }
    }
    return found;
}

house files_of(const std::vector<std::string>& folders) {
    const fs::path top = LIBRATION_SOURCE_DIR;
    house all;
    for (const auto& each : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(top / each)) {
            const auto path = entry.path().lexically_relative(top).generic_string();
            if (!entry.is_regular_file() || !is_source(path)) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            all[path] = std::string(std::istreambuf_iterator<char>(file), {});
        }
    }
    return all;
}

house this_house() { return files_of({"include", "src", "studies", "paper"}); }

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

TEST_CASE("no class has two definitions", "[house]") {
    const auto found = repeated_classes(this_house());
    INFO(lines(found));
    CHECK(found.empty());
    CHECK(repeated_classes(
              {{"include/libration/a.hpp", "namespace n {\nstruct one {\n"},
               {"src/libration/b.cpp", "namespace n {\nnamespace {\nstruct one {\n}  // namespace\nclass two {\n"},
               {"src/libration/c.hpp", "namespace n {\nclass two : x {\n"}})
              .size() == 1);
}

TEST_CASE("a program that stops at mpfr needs no FLINT", "[house]") {
    CHECK(first_with_flint(this_house(), "include/libration/libration.hpp").empty());
    const std::string ball = "include/libration/scalar/ball/ball.hpp",
                      value = "include/libration/scalar/ball/value.hpp",
                      elliptic = "include/libration/elliptic/jacobi.hpp";
    house with_flint{{ball, "#include \"libration/scalar/ball/value.hpp\"\n"},
                     {value, "#include <flint/arb.h>\n"},
                     {elliptic, "#include <array>\n"}};
    CHECK(first_with_flint(with_flint, elliptic).empty());
    CHECK(first_with_flint(with_flint, ball) == value);
    with_flint[elliptic] = "#include \"libration/scalar/ball/ball.hpp\"\n";
    CHECK(first_with_flint(with_flint, elliptic) == value);
    with_flint[elliptic] = "#include <array>\n#include <arb.h>\n";
    CHECK(first_with_flint(with_flint, elliptic) == elliptic);
}

TEST_CASE("header, source and test of a name share their folder", "[house]") {
    const auto found = separated(this_house(), files_of({"tests"}));
    INFO(lines(found));
    CHECK(found.empty());
    const std::string header = "include/libration/event/zero.hpp", source = "src/libration/event/zero.cpp",
                      test = "tests/event/zero_test.cpp";
    CHECK(separated({{header, ""}, {source, ""}}, {{test, ""}}).empty());
    CHECK(separated({{header, ""}, {"src/libration/event/search/zero.cpp", ""}}, {}).size() == 1);
    CHECK(separated({{header, ""}}, {{"tests/event/search/zero_test.cpp", ""}}).size() == 1);
}

TEST_CASE("each switch over kinds names all of them", "[house]") {
    const auto found = unnamed_kinds(this_house());
    INFO(lines(found));
    CHECK(found.empty());
    const std::string path = "src/libration/expansion/tape.cpp";
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
                      convergence = "include/libration/convergence/radius_report.hpp",
                      elliptic = "include/libration/elliptic/jacobi.hpp",
                      pendulum = "include/libration/pendulum/period.hpp", sweep = "src/command/sweep/study.hpp",
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
                                       {approximant, elliptic},
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
        CHECK(complaints_if("src/command/verb/period.cpp", include(pendulum)).size() == 1);
        CHECK(complaints_if("src/command/problem/problem_options.cpp", include(pendulum)).size() == 1);
        CHECK(complaints_if("src/command/problem/motion_options.cpp", include(pendulum)).empty());
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
