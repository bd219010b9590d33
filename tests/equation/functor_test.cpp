// A right-hand side that is a C++ template defines the same system as text.
#include "libration/equation/functor.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace equation_functor_test {

using namespace libration;
using namespace libration::ode;

namespace {

struct driven_pendulum {
    template <class T>
    std::vector<T> operator()(const T& t, const std::vector<T>& y) const {
        using std::cos, std::sin;
        return {y[1], -sin(y[0]) + cos(t) / 3};
    }
};

}  // namespace

TEST_CASE("a functor is the equation that it computes", "[ode][functor]") {
    const explicit_system made(system_of(driven_pendulum(), {"x", "v"}, {1, 0}));
    const explicit_system typed(parse("x' = v; v' = -sin(x) + cos(t)/3; x(0) = 1; v(0) = 0"));
    const tape of_made = tape::about_start(made);
    const tape of_typed = tape::about_start(typed);
    taylor_expansion<double> a(of_made, 20);
    taylor_expansion<double> b(of_typed, 20);
    a.about_start();
    b.about_start();
    for (int n = 0; n <= 20; ++n) {
        CHECK(a.coefficients(0)[n] == b.coefficients(0)[n]);
        CHECK(a.coefficients(1)[n] == b.coefficients(1)[n]);
    }
    // It can still be evaluated with numbers.
    CHECK(driven_pendulum()(0.0, std::vector<double>{0.0, 2.0})[1] == Approx(1.0 / 3));
}

TEST_CASE("a functor with another number of right sides is refused", "[ode][functor]") {
    CHECK_THROWS_WITH(system_of(driven_pendulum(), {"x", "v"}, {1}),
                      Catch::Contains("2 unknowns, 1 initial values and 2 right-hand sides"));
}

}  // namespace equation_functor_test
