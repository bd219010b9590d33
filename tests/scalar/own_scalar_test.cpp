// The number type of docs/scalars.md in series, integrations and closed forms: the values are those of double.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "../docs/examples/counting.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/pendulum/exact_solution.hpp"
#include "libration/query/trajectory.hpp"

namespace scalar_own_scalar_test {

using namespace libration;

namespace {

template <class Work>
long multiplications(const Work& work) {
    counting::multiplications = 0;
    work();
    return counting::multiplications;
}

std::string text_of(const std::string& file) {
    std::ifstream in(LIBRATION_SOURCE_DIR "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

const ode::explicit_system& tangent() {
    static const ode::explicit_system system(ode::parse("x' = 1 + x^2; x(0) = 0"));
    return system;
}

}  // namespace

TEST_CASE("Taylor coefficients in a user-defined number type", "[scalar][own_scalar]") {
    // tan t = t + t^3/3 + 2 t^5/15 + 17 t^7/315 + ...
    const ode::tape tape = ode::tape::about_start(tangent());
    ode::taylor_expansion<counting> series(tape, 7);
    CHECK(multiplications([&] { series.about_start(); }) > 0);
    CHECK(std::abs(series.coefficients(0)[7].value - 17.0 / 315) <= 4 * 0x1p-57);  // rounded in each of 4 recurrences
}

TEST_CASE("an integration in a user-defined number type", "[scalar][own_scalar]") {
    const std::vector<ode::number> times{ode::number(1)};
    ode::partial_states<counting> found;
    CHECK(multiplications([&] { found = ode::part_of_march<counting>(tangent(), times); }) > 100);
    // tan 1, whose error grows by tan' = 3.4 at most per rounding of some tens of steps.
    CHECK(std::abs(found.states.at(0)[0][0].value - std::tan(1.0)) <= 64 * 0x1p-52);
}

TEST_CASE("the exact solution of the pendulum in a user-defined number type", "[scalar][own_scalar]") {
    const auto swing = pendulum::motion::of_state(read_exact("2.5"), read_exact("0"));
    const pendulum::exact_solution<counting> in_double(swing);
    const pendulum::exact_solution<mpfr> exact(swing);
    for (const char* const time : {"0", "3", "-7/2", "1e6"}) {
        INFO(time);
        const double theta = exact(read_exact(time)).theta.convert_to<double>();
        CHECK(std::abs(in_double(read_exact(time)).theta.value - theta) <= 16 * 0x1p-52);
    }
}

TEST_CASE("docs/scalars.md shows the number type that is tested", "[scalar][own_scalar]") {
    const std::string type = text_of("docs/examples/counting.hpp");
    REQUIRE(!type.empty());
    CHECK(text_of("docs/scalars.md").find(type) != std::string::npos);
}

}  // namespace scalar_own_scalar_test
