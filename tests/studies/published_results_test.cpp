// What is committed in results/ is what the program computes: the quick studies again, byte for byte. (The slow ones
// are compared by hand with `./run reproduce`.) Tables of fixed scalars are left out: libm may move their last digit.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "sweep/cell_engine.hpp"
#include "sweep/study_order.hpp"

namespace studies_published_results_test {

using namespace libration;

namespace {

constexpr double quick_seconds = 1;

std::string published(const std::string& path) {
    std::ifstream file(std::string(LIBRATION_SOURCE_DIR "/results/") + path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the published tables of the quick studies are computed again byte for byte", "[studies][results]") {
    int compared = 0;
    for (const study* each : studies_of_own_problems()) {
        if (each->seconds > quick_seconds) {
            continue;
        }
        for (const study_table& part : tables_of(order_of(*each, {}, 2))) {
            if (part.timed || part.scalar.kind != scalar_kind::arbitrary) {
                continue;
            }
            const std::string stem = part.suffix.empty() ? each->name : each->name + "_" + part.suffix;
            INFO(stem);
            CHECK(to_csv(part.data) == published(each->name + "/" + stem + ".csv"));
            ++compared;
        }
    }
    CHECK(compared > 0);
}

// Those of the sets `problems` and `proved` are made on demand: results/ holds the paper's.
TEST_CASE("every study of the paper is published, with its figure", "[studies][results]") {
    const std::set<std::string> of_problems{
        "approximants", "complex_plane", "problems", "published", "reference_problems",
        "scenarios",    "sir_radius",    "solvers",  "stiff",     "stiff_solvers"};
    for (const study* each : studies_of_own_problems()) {
        if (of_problems.contains(each->name)) {
            continue;
        }
        INFO(each->name);
        for (const std::string extension : {".csv", ".tex", ".json", ".svg", ".png", ".pdf"}) {
            CHECK(
                std::filesystem::exists(LIBRATION_SOURCE_DIR "/results/" + each->name + "/" + each->name + extension));
        }
    }
}

}  // namespace studies_published_results_test
