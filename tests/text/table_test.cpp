#include "text/table.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/temporary_folder.hpp"

namespace sweep_table_test {

using namespace libration;
using libration::tests::temporary_folder;
using libration::tests::text_of_file;

namespace {

using words = std::vector<std::string>;

const table example{{{"zeta", "a name"}, {"alpha", ""}, {"m", "metres"}},
                    {{1, "x", ""}, {number_cell("-2.50"), "longer", 3}}};

// Lets no file of this process grow beyond a few bytes, until the end of the scope.
class small_files {
public:
    explicit small_files(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    small_files(const small_files&) = delete;
    small_files& operator=(const small_files&) = delete;
    ~small_files() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, signal_);
    }

private:
    rlimit before_{};
    void (*signal_)(int);
};

}  // namespace

TEST_CASE("CSV is one header line and one line a row, cells as they are", "[sweep][table]") {
    CHECK(to_csv(example) == "zeta,alpha,m\n1,x,\n-2.50,longer,3\n");
    CHECK(to_csv(table(std::vector<column>{{"a", ""}, {"b", ""}})) == "a,b\n");
    CHECK(to_csv(table(std::vector<column>{{"a", ""}}, {{""}})) == "a\n\n");
}

TEST_CASE("CSV quotes a comma, a quote and a line end, and nothing else", "[sweep][table]") {
    const table odd{{{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}},
                    {{"x,y", "say \"no\"", "two\nlines", "plain text; 'ok'"}}};
    CHECK(to_csv(odd) == "a,b,c,d\n\"x,y\",\"say \"\"no\"\"\",\"two\nlines\",plain text; 'ok'\n");
}

TEST_CASE("JSON is an array of objects of strings or null, keys in the order of the columns", "[sweep][table]") {
    const auto json = nlohmann::ordered_json::parse(to_json(example));
    REQUIRE(json.is_array());
    REQUIRE(json.size() == 2);
    words keys;
    for (const auto& [key, value] : json[1].items()) {
        keys.push_back(key);
        CHECK(value.is_string());
    }
    CHECK(keys == words{"zeta", "alpha", "m"});
    CHECK(json[1].at("zeta") == "-2.50");  // a string, not the number -2.5
    CHECK(json[0].at("m").is_null());
    CHECK(to_json(table(std::vector<column>{{"a", ""}})) == "[]\n");
    const auto quoted = nlohmann::ordered_json::parse(to_json(table(std::vector<column>{{"a", ""}}, {{"\"\\\n"}})));
    CHECK(quoted.at(0).at("a") == "\"\\\n");
}

TEST_CASE("text has its columns below each other and no blanks at the ends of lines", "[sweep][table]") {
    CHECK(to_text(example) ==
          "zeta   alpha   m\n"
          "1      x\n"
          "-2.50  longer  3\n");
}

TEST_CASE("a file is written whole, and again over the old one", "[sweep][table]") {
    const temporary_folder folder;
    const auto path = folder.path() / "table.csv";
    const std::string content("a,b\n\0binary\r\n", 13);
    write_whole_file(path.string(), content);
    CHECK(text_of_file(path) == content);
    write_whole_file(path.string(), "short");
    CHECK(text_of_file(path) == "short");
    write_whole_file(path.string(), "");
    CHECK(text_of_file(path).empty());
    CHECK(folder.content() == words{"table.csv"});
}

TEST_CASE("whoever reads the old file keeps all of it while a new one takes its place", "[sweep][table]") {
    const temporary_folder folder;
    const auto path = folder.path() / "table.csv";
    const std::string old(100'000, 'o');
    write_whole_file(path.string(), old);
    std::ifstream reader(path, std::ios::binary);
    std::string seen(10, ' ');
    reader.read(seen.data(), 10);
    write_whole_file(path.string(), std::string(100'000, 'n'));
    std::string rest(old.size() - 10, ' ');
    reader.read(rest.data(), static_cast<std::streamsize>(rest.size()));
    CHECK(reader.gcount() == static_cast<std::streamsize>(rest.size()));
    CHECK(seen + rest == old);
    CHECK(text_of_file(path) == std::string(100'000, 'n'));
}

TEST_CASE("a file that cannot be made throws with the reason and leaves nothing", "[sweep][table]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "file") << "kept";
    std::filesystem::create_directories(folder.path() / "folder" / "inside");
    const auto before = folder.content();
    CHECK_THROWS_AS(write_whole_file((folder.path() / "missing" / "x").string(), "text"), std::runtime_error);
    CHECK_THROWS_WITH(write_whole_file((folder.path() / "missing" / "x").string(), "text"),
                      Catch::Contains("No such file"));
    CHECK_THROWS_WITH(write_whole_file((folder.path() / "file" / "x").string(), "text"), Catch::Contains("directory"));
    CHECK_THROWS_AS(write_whole_file((folder.path() / "folder").string(), "text"), std::runtime_error);  // no rename
    CHECK(folder.content() == before);
    CHECK(text_of_file(folder.path() / "file") == "kept");
}

TEST_CASE("where the disk ends in the middle the old file stays and no part is left", "[sweep][table]") {
    const temporary_folder folder;
    const auto path = folder.path() / "table.csv";
    write_whole_file(path.string(), "old");
    std::string reason = "written";
    {
        const small_files limit(4096);
        try {
            write_whole_file(path.string(), std::string(100'000, 'n'));
        } catch (const std::runtime_error& problem) {
            reason = problem.what();
        }
    }
    CHECK(reason == "File too large");
    CHECK(folder.content() == words{"table.csv"});
    CHECK(text_of_file(path) == "old");
}

TEST_CASE("a table read back from its CSV is the same table", "[sweep][table]") {
    const table data{{{"a", ""}, {"b", ""}},
                     {{"1.5", "two words"}, {"", "with, comma"}, {"\"quoted\"", "two\nlines"}, {"x", ""}, {"", ""}}};
    const table back = from_csv(to_csv(data));
    REQUIRE(back.columns().size() == 2);
    CHECK(back.columns()[1].name == "b");
    CHECK(back.rows() == data.rows());
    CHECK(from_csv("a,b\n").rows().empty());
}

TEST_CASE("a cell knows what it holds", "[text][table]") {
    CHECK(cell().is_empty());
    CHECK(cell("").is_empty());
    CHECK(cell("mpfr:40").kind() == cell_kind::text);
    CHECK(cell(12L).kind() == cell_kind::whole);
    CHECK(cell(integer("123456789012345678901234567890")).text() == "123456789012345678901234567890");
    const cell third = decimal_cell(1.0 / 3, 5);
    CHECK(third.kind() == cell_kind::number);
    CHECK(third.text() == "0.33333");
    CHECK(third.digits() == 5);
    CHECK(decimal_cell(std::optional<double>(), 5).is_empty());
    CHECK(number_cell("1.500e-30").digits() == 4);
    for (const std::string number : {"1", "-1.5", "1e400", "-1.5e-300", "inf", "-inf"}) {
        CHECK(read_cell(number).is_number());
    }
    for (const std::string text : {"3T/4", "1.2.3", "1.", ".5", "1e", "--1", "two-method", "e5"}) {
        CHECK(read_cell(text).kind() == cell_kind::text);
    }
}

TEST_CASE("a row that does not fit its table cannot be built", "[text][table]") {
    table data(std::vector<column>{{"a", ""}, {"b", ""}});
    CHECK_THROWS_AS(data.add_row({1}), std::logic_error);
    CHECK_THROWS_AS(data.add_row({1, 2, 3}), std::logic_error);
    CHECK_NOTHROW(data.add_row({1, 2}));
    CHECK(data.rows().size() == 1);
    const std::vector<column> two{{"a", ""}, {"b", ""}};
    CHECK_THROWS_AS(table(two, {{1, 2}, {3}}), std::logic_error);
    CHECK_THROWS_AS(data.append(table(std::vector<column>{{"a", ""}, {"c", ""}})), std::logic_error);
}

TEST_CASE("a column is name, meaning and value in one place, and tables stack", "[text][table]") {
    struct point {
        int x;
        double y;
    };
    const column_list<point> columns{{"x", "a count", [](const point& p) { return p.x; }},
                                     {"y", "metres", [](const point& p) { return decimal_cell(p.y, 3); }}};
    const table one = make_table(columns, std::vector<point>{{1, 0.5}});
    const table two = make_table(columns, std::vector<point>{{2, 0.25}, {3, 2}});
    CHECK(one.columns()[1].meaning == "metres");
    CHECK(to_csv(stacked(std::vector<table>{one, two})) == "x,y\n1,0.500\n2,0.250\n3,2.00\n");
    const auto both = stacked(std::vector<std::vector<table>>{{one, two}, {one, one}});
    REQUIRE(both.size() == 2);
    CHECK(both[0].rows().size() == 2);
    CHECK(both[1].rows().size() == 3);
    CHECK_THROWS_AS(stacked(std::vector<table>()), std::logic_error);
    CHECK(to_csv(two.with_columns({1})) == "y\n0.250\n2.00\n");
}

TEST_CASE("a CSV with a short row, or cut off, is refused by its line", "[sweep][table]") {
    CHECK_THROWS_WITH(from_csv("a,b\n1,2\n3\n"), Catch::Contains("line 3") && Catch::Contains("1 cells, not 2"));
    CHECK_THROWS_WITH(from_csv("a,b\n1,2"), Catch::Contains("line 2") && Catch::Contains("does not end"));
    CHECK_THROWS_WITH(from_csv("a,b\n\"1,2\n"), Catch::Contains("does not end"));
}

}  // namespace sweep_table_test
