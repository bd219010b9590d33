// The engine of studies: which cells are computed, and that the tables follow from the cells alone.
#include "sweep/cell_engine.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/temporary_folder.hpp"
#include "libration/problem/known/pendulum.hpp"

namespace sweep_cell_engine_test {

using namespace libration;
using libration::tests::temporary_folder;

namespace {

// What a study of squares has computed so far.
struct tally {
    std::atomic<int> cells{0};
    std::atomic<int> groups{0};
    std::set<int> failing;  // orders without an answer
};

struct square_row {
    int group, order;
};

column_list<square_row> square_columns() {
    return {{"group", "", [](const square_row& r) { return r.group; }},
            {"order", "", [](const square_row& r) { return r.order; }},
            {"square", "", [](const square_row& r) { return r.order * r.order; }}};
}

// Groups 0, 1, 2, each with the orders that are asked for.
study squares(const std::shared_ptr<tally>& seen) {
    study result{.name = "squares",
                 .title = "Squares",
                 .label = "",
                 .question = "What is the square?",
                 .reading = "",
                 .of = &pendulum_problem(),
                 .parameters = {{"--orders", "1", "orders"}, {"--times", "0", "no axis of the cells"}},
                 .quick = {},
                 .seconds = 1,
                 .excluded = {},
                 .plan = {}};
    result.plan = [seen](const study_request& request) {
        const auto orders = request.orders();
        const auto group = [seen, orders](std::size_t i) {
            cell_group cells;
            for (const int order : orders) {
                cells.cells.push_back({{"group", std::to_string(i)}, {"order", std::to_string(order)}});
            }
            cells.compute = [seen, orders, i](const std::vector<std::size_t>& which) {
                ++seen->groups;
                std::vector<cell_rows> rows;
                for (const std::size_t each : which) {
                    ++seen->cells;
                    if (seen->failing.contains(orders[each])) {
                        throw std::runtime_error("has no square");
                    }
                    rows.push_back(rows_of(
                        {make_table(square_columns(), std::vector<square_row>{{static_cast<int>(i), orders[each]}})}));
                }
                return rows;
            };
            return cells;
        };
        return study_plan{{head_of("", read_scalar("double"), square_columns())}, {"order"}, 3, group, {}, {}};
    };
    return result;
}

// Computes what is missing in a store and gives the CSV.
std::string csv_of(const study& what, const study_words& words, cell_store& store, int jobs = 2) {
    const study_order order = order_of(what, words, jobs);
    const study_cells of(order);
    compute_missing(of, store, missing_cells(of, store, {}));
    return to_csv(gather(of, store).tables.front().data);
}

const std::string csv_of_1_3 = "group,order,square\n0,1,1\n0,3,9\n1,1,1\n1,3,9\n2,1,1\n2,3,9\n";

}  // namespace

TEST_CASE("tables do not follow from threads, nor from the order in which values were typed", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    const study what = squares(seen);
    for (const int jobs : {1, 2, 7}) {
        for (const std::string orders : {"1,3", "3,1", "3,1,3"}) {
            CHECK(to_csv(tables_of(order_of(what, {{"--orders", orders}}, jobs)).front().data) == csv_of_1_3);
        }
    }
}

TEST_CASE("only the missing cells are computed, together", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    const study what = squares(seen);
    const temporary_folder folder;
    {
        journal cells(folder.path() / "squares.journal", journal::access::write);
        journal_store store(cells);
        CHECK(csv_of(what, {{"--orders", "1,3"}}, store) == csv_of_1_3);
        CHECK(seen->cells == 6);
        CHECK(seen->groups == 3);
    }
    journal cells(folder.path() / "squares.journal", journal::access::write);
    journal_store store(cells);
    CHECK(csv_of(what, {{"--orders", "1,3"}}, store) == csv_of_1_3);
    CHECK(seen->cells == 6);
    const std::string more = csv_of(what, {{"--orders", "1,2,3,4"}}, store);
    CHECK(seen->cells == 12);
    CHECK(seen->groups == 6);
    CHECK(more.find("\n0,1,1\n0,2,4\n0,3,9\n0,4,16\n1,1,1\n") != std::string::npos);
    // The journal holds more than this command asks for.
    CHECK(csv_of(what, {{"--orders", "1,3"}}, store) == csv_of_1_3);
    // The values of an axis that cells do not split belong to all of them.
    csv_of(what, {{"--orders", "1,3"}, {"--times", "1"}}, store);
    CHECK(seen->cells == 18);
}

TEST_CASE("a cell that fails keeps its reason and its attempts and does not stop the others", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    seen->failing = {2};
    const study what = squares(seen);
    memory_store store;
    const study_words words{{"--orders", "1,2,3"}};
    CHECK(csv_of(what, words, store) == csv_of_1_3);
    const study_order order = order_of(what, words, 2);
    const study_cells of(order);
    auto failures = gather(of, store).failures;
    CHECK(failures.count == 3);
    CHECK(message_of(failures) ==
          "3 cells failed: group=0 order=2 (has no square); group=1 order=2 (has no square); group=2 order=2 (has no "
          "square)");
    csv_of(what, words, store);
    failures = gather(of, store).failures;
    REQUIRE(failures.count == 3);
    CHECK(failures.first.front().attempts == 2);
    seen->failing.clear();
    csv_of(what, words, store);
    CHECK(gather(of, store).failures.count == 0);
    CHECK(gather(of, store).finished == 9);
}

TEST_CASE("where no cell has an answer, what the first of them threw is thrown", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    seen->failing = {1};
    const study what = squares(seen);
    CHECK_THROWS_WITH(answers_of(order_of(what, {{"--orders", "1"}}, 2)), "has no square");
    CHECK_THROWS_WITH(tables_of(order_of(what, {{"--orders", "1,2"}}, 2)), "has no square");
    CHECK(answers_of(order_of(what, {{"--orders", "1,2"}}, 2)).failures.count == 3);
}

TEST_CASE("shards together are all cells, each once", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    const study what = squares(seen);
    const study_order order = order_of(what, {{"--orders", "1,2,3,4"}}, 2);
    const study_cells of(order);
    for (const std::size_t count : {1U, 2U, 3U, 5U}) {
        memory_store store;
        std::size_t cells = 0;
        seen->cells = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const cells_found found = missing_cells(of, store, {i, count});
            CHECK(found.to_compute == found.cells);
            cells += found.cells;
            compute_missing(of, store, found);
        }
        CHECK(cells == 12);
        CHECK(seen->cells == 12);
        CHECK(missing_cells(of, store, {}).to_compute == 0);
    }
}

TEST_CASE("tables too long for memory are given row by row", "[sweep][journal]") {
    const auto seen = std::make_shared<tally>();
    const study what = squares(seen);
    const study_order order = order_of(what, {{"--orders", "1,3"}}, 2);
    const study_cells of(order);
    memory_store store;
    compute_missing(of, store, missing_cells(of, store, {}));
    const gathered_tables gathered = gather(of, store, 4);
    CHECK(gathered.too_long);
    CHECK(gathered.tables.front().data.rows().empty());
    CHECK(gathered.tables.front().rows == 6);
    std::string squares_seen;
    gathered.each_row([&](std::size_t place, const table_row_cells& row) {
        CHECK(place == 0);
        squares_seen += row.back().text() + " ";
    });
    CHECK(squares_seen == "1 9 1 9 1 9 ");
}

TEST_CASE("another version of the study has other keys", "[sweep][journal]") {
    study what = squares(std::make_shared<tally>());
    const study_order order = order_of(what, {}, 1);
    const cell_inputs inputs{{"order", "1"}};
    const cell_key before = study_cells(order).key(inputs);
    CHECK(study_cells(order).key(inputs) == before);
    what.version = 2;
    CHECK(study_cells(order).key(inputs) != before);
    what.version = 1;
    CHECK(study_cells(order).key({{"order", "2"}}) != before);
}

}  // namespace sweep_cell_engine_test
