// The stiff problems of the catalogue: proved values next to those in print, and invariants of proved values.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/number/exact.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/query/states.hpp"
#include "proved.hpp"

namespace problem_stiff_problems_test {

using namespace libration;
using namespace libration::ode;

namespace {

/// The unknowns at a time, by name, as they are in print, and the distance that their sources admit.
struct printed_state {
    std::string problem;
    std::string time;
    std::vector<std::pair<std::string, std::string>> values;
    std::string within;  ///< relative
};

mpfr number_in(const std::string& text) { return mpfr_from_exact(read_exact(text)); }

}  // namespace

// W. H. Enright, J. D. Pryce, Algorithm 648, printed by its routine EVALU; E5 as in E. Hairer, G. Wanner's list.
TEST_CASE("stiff problems have their printed values", "[problem][catalogue][ode][proved]") {
    const std::vector<printed_state> all{
        {"stiff_a3", "20", {{"y1", "-1.353352661867235e-3"}, {"y3", "1.503725348455117"}}, "1e-12"},
        {"stiff_b2", "20", {{"y6", "0.1353352832365270"}, {"y5", "4.539992973654118e-5"}}, "1e-8"},
        {"stiff_c1", "20", {{"y1", "4.003223925456179e-4"}, {"y4", "0.02"}}, "1e-8"},
        {"stiff_c5", "20", {{"y2", "7.999999981678634"}, {"y4", "37127.99965967762"}}, "1e-15"},
        {"stiff_d1", "400", {{"y1", "22.24222010616901"}, {"y2", "27.11071334484136"}}, "1e-12"},
        {"stiff_d2", "40", {{"y2", "9.185534764557338e-2"}, {"y3", "28.41637457458413"}}, "1e-12"},
        {"stiff_d6", "1", {{"y1", "0.8523995440749948"}, {"y3", "5.773087333950041e-8"}}, "1e-13"},
        {"stiff_e2", "10", {{"y1", "-1.158701266031984"}, {"y2", "0.4304698089780476"}}, "1e-11"},
        {"stiff_e3", "500", {{"y1", "4.253052197643089e-3"}, {"y3", "26.27647748753926"}}, "1e-9"},
        {"stiff_e5", "1000", {{"y1", "1.6180769999072942552e-3"}, {"y4", "1.2997212954915352082e-10"}}, "1e-17"},
        {"stiff_f2", "240", {{"y1", "0.3912699122292088"}, {"y2", "1.329964166084866e-3"}}, "1e-13"},
        {"stiff_f5", "100", {{"y1", "1.713564284690712e-7"}, {"y3", "6.189271785267793e-3"}}, "1e-15"},
    };
    const precision_scope scope(40);
    for (const printed_state& each : all) {
        const explicit_system system(parse(problem_text(each.problem)));
        const auto names = names_of_state(system);
        const auto state = proved_trajectory(system, {parse_constant(each.time).constant()}, 20).front();
        for (const auto& [unknown, printed] : each.values) {
            const auto i = static_cast<std::size_t>(std::ranges::find(names, unknown) - names.begin());
            INFO(each.problem << ", " << unknown << ": " << state.at(i).text);
            const mpfr truth = number_in(printed);
            CHECK(abs(mpfr(mpfr(state.at(i).text) - truth)) <= abs(truth) * number_in(each.within));
        }
    }
}

}  // namespace problem_stiff_problems_test
