// The writer of certificates makes none that the programs that check reject: names, powers and depths of the format
// (docs/certificates.md), and boxes of roots that became smaller.
#include <catch2/catch.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "certificates/checked.hpp"
#include "command/temporary_folder.hpp"
#include "libration/equation/equation_system.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/find.hpp"
#include "libration/scalar/enclose.hpp"

namespace certificates_limits_test {

using namespace libration;
using namespace libration::tests;

namespace {

// The certificate of name' = right at time 1/4, with name(0) = 1.
std::string certificate_of_equation(const std::string& name, const ode::expression& right) {
    ode::equation_system given;
    const ode::expression y = ode::unknown(name);
    given.add(ode::derivative(y), right);
    given.begin(y, ode::expression(1), ode::expression(0));
    const ode::explicit_system system(given);
    return certificate_of_states(system, {read_exact("1/4")}, {{{"1.3"}}, 2}, proved_digits(2));
}

}  // namespace

TEST_CASE("names of definitions and functions are not those of unknowns", "[certificate]") {
    for (const std::string name : {"_1", "_22", "pi", "exp", "sqrt", "y z", ""}) {
        INFO(name);
        CHECK_THROWS_WITH(certificate_of_equation(name, ode::unknown(name)),
                          Catch::Contains("does not contain '" + name + "' as a name"));
    }
    for (const std::string name : {"_", "_1a", "y_1", "e"}) {
        INFO(name);
        CHECK(certificate_of_equation(name, ode::unknown(name)).size() > 100);
    }
}

TEST_CASE("powers and depths beyond those of the format have no certificate", "[certificate]") {
    const ode::expression y = ode::unknown("y");
    CHECK_THROWS_WITH(certificate_of_equation("y", pow(y, ode::expression(101))), Catch::Contains("have ^101"));
    ode::expression deep = y;
    for (int k = 0; k < 160; ++k) {
        deep = 1 + y * deep;
    }
    CHECK_THROWS_WITH(certificate_of_equation("y", deep), Catch::Contains("nested at most 150 deep"));
}

// Of 6 digits: the box that is known first is too large, and the middle of the smaller one has to be nearer to the root.
TEST_CASE("the certificate of a periodic orbit of few digits is proved", "[certificate]") {
    const problem of("x'' = (1 - x^2)*x' - x; x(0) = 2; x'(0) = 0");
    const request how = proved_digits(6);
    const auto orbit = find_periodic_orbit(of, how);
    std::vector<std::string> values;
    for (std::size_t k = 0; k < orbit.rows.size(); ++k) {
        values.push_back(orbit.at(k, "value"));
    }
    const temporary_folder folder;
    const auto file = folder.path() / "a.cert";
    std::ofstream(file, std::ios::binary) << certificate_of_orbit(of, values, how);
    const auto proved = checked(file);
    INFO(proved.out);
    CHECK(proved.exit_code == 0);
    CHECK(contains(proved.out, "t in [6.6632868"));
    CHECK(contains(proved.out, "The variable is t."));
}

}  // namespace certificates_limits_test
