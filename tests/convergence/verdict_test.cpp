#include "libration/convergence/verdict.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <sstream>

#include "libration/convergence/coefficient_list.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/mpfr_traits.hpp"

namespace convergence_verdict_test {

using namespace libration;
using namespace libration::convergence;

namespace {

constexpr long most_digits = 400;

series_list exact_list(const std::string& name) {
    std::ifstream file(LIBRATION_LISTS + name + ".csv");
    REQUIRE(file.is_open());
    std::stringstream text;
    text << file.rdbuf();
    series_list list;
    for (const auto& number : read_coefficients(text.str())) {
        list.values.push_back(from_exact<mpfr>(number));
    }
    return list;
}

series_list head_of(const series_list& list, int order) {
    return {{list.values.begin(), list.values.begin() + order + 1}, list.noise, list.zero};
}

series_list list_of(int order, const std::function<mpfr(int)>& coefficient) {
    series_list list;
    for (int n = 0; n <= order; ++n) {
        list.values.push_back(coefficient(n));
    }
    return list;
}

// C(nu, n) (-1)^n: the coefficients of (1 - x)^nu.
mpfr binomial(const mpfr& nu, int n) {
    mpfr c(1);
    for (int k = 1; k <= n; ++k) {
        c *= (k - 1 - nu) / k;
    }
    return c;
}

bool covers(const list_verdict& found, const mpfr& radius) {
    return found.radius && abs(*found.radius - radius) <= found.uncertainty;
}

}  // namespace

TEST_CASE("the verdicts on published enumerations hold and are sharp", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    const mpfr one(1);
    struct published {
        std::string name, radius, error;
        double exponent;
        double sharpness;  // the uncertainty is at most this
    };
    // Sources: problems/series/published.csv.
    for (const auto& each :
         std::vector<published>{{"walks_square", "0.379052277755161", "5e-15", -43.0 / 32, 1e-7},
                                {"polygons_square_perimeter", "0.143680629271", "1e-12", 1.5, 1e-9},
                                {"walks_honeycomb", "0.5411961001461969843997232053663894", "0", -43.0 / 32, 1e-3},
                                {"ising_square_high", "0.41421356237309504880168872420969808", "0", -1.75, 1e-4},
                                {"ising_square_low", "0.17157287525380990239662255158060", "0", -1.75, 1e-5},
                                {"ising_triangular_high", "0.26794919243112270647255365849413", "0", -1.75, 1e-5},
                                {"ising_honeycomb_high", "0.57735026918962576450914878050196", "0", -1.75, 1e-3},
                                {"walks_triangular", "0.240917574", "2e-9", -43.0 / 32, 1e-3}}) {
        INFO(each.name);
        const auto found = verdict_on(exact_list(each.name));
        REQUIRE(found.radius);
        CHECK(abs(*found.radius - mpfr(each.radius)) <= found.uncertainty + mpfr(each.error));
        CHECK(found.uncertainty <= each.sharpness);
        REQUIRE(found.exponent);
        CHECK(abs(*found.exponent - each.exponent) <= found.exponent_uncertainty);
        CHECK_FALSE(found.suspect);
    }
}

TEST_CASE("more coefficients do not make a verdict less certain", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    const auto list = exact_list("walks_square");
    std::optional<mpfr> least;
    for (const int order : {30, 40, 50, 60, 70, 79}) {
        INFO("N = " << order);
        const auto found = verdict_on(head_of(list, order));
        REQUIRE(covers(found, mpfr("0.379052277755161")));
        CHECK((!least || found.uncertainty <= *least * 10));
        least = least ? std::min(*least, found.uncertainty) : found.uncertainty;
    }
}

TEST_CASE("a changed coefficient is found, and its true value predicted", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    const auto changed = exact_list("../../tests/reference/polygons_changed");
    const auto found = verdict_on(changed);
    REQUIRE(found.suspect);
    CHECK(found.suspect->index == 40);
    CHECK(found.suspect->confirmed);
    const auto right = exact_list("polygons_square_perimeter");
    CHECK(right.values[40] != changed.values[40]);
    CHECK(abs(found.suspect->predicted - right.values[40]) <= found.suspect->uncertainty);
    CHECK(found.suspect->deviation == Approx(1e-9).epsilon(0.01));
    // The radius is from the coefficients before it.
    CHECK(found.used < 40);
    CHECK(abs(*found.radius - mpfr("0.143680629271")) <= found.uncertainty);
}

TEST_CASE("a list of zero radius has its Gevrey order and its action", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    const auto found = verdict_on(exact_list("quartic_oscillator"));
    CHECK(found.growth == growth_class::zero);
    CHECK_FALSE(found.radius);
    REQUIRE(found.gevrey);
    CHECK(*found.gevrey == 1);
    REQUIRE(found.action);
    CHECK(abs(found.action->re + mpfr(1) / 3) <= found.action_uncertainty);
    CHECK(found.action->im == 0);
    CHECK(found.action_uncertainty < mpfr(1e-10));
}

TEST_CASE("an entire function has no radius and its order", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    mpfr factorial(1);
    const auto exponential = verdict_on(list_of(40, [&](int n) {
        factorial *= n > 0 ? n : 1;
        return mpfr(pow(mpfr(2), n) / factorial);
    }));
    CHECK(exponential.growth == growth_class::infinite);
    REQUIRE(exponential.gevrey);
    CHECK(*exponential.gevrey == -1);
    REQUIRE(exponential.action);
    CHECK(abs(exponential.action->re - mpfr(1) / 2) <= exponential.action_uncertainty);
}

TEST_CASE("a weak pole in front of a strong branch point is seen if the list is exact", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    // Catalan numbers, radius 1/4, and 10^-12/(1 - 5 x).
    for (const int order : {40, 80}) {
        mpfr catalan(1);
        const auto found = verdict_on(list_of(order, [&](int n) {
            catalan = n == 0 ? mpfr(1) : mpfr(catalan * (2 * (2 * n - 1)) / (n + 1));
            return mpfr(catalan + pow(mpfr(5), n) / pow(mpfr(10), 12));
        }));
        INFO("N = " << order);
        CHECK(covers(found, mpfr(mpfr(1) / 5)));
        CHECK(found.exact);
        CHECK(found.kind == singularity_kind::pole);
    }
}

TEST_CASE("an apparent singularity of a fitted equation is not the nearest one", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    // (1-x)^(2/3) + (1+x)^(-5/2): its second-order equation is singular at 0.5789 too, where the sum is analytic.
    const auto found = verdict_on(list_of(
        40, [](int n) { return mpfr(binomial(mpfr(2) / 3, n) + (n % 2 == 0 ? 1 : -1) * binomial(mpfr(-5) / 2, n)); }));
    REQUIRE(covers(found, mpfr(1)));
    CHECK(found.uncertainty < mpfr(1e-30));
    CHECK(found.ring.size() == 2);
    CHECK(found.count == 2);
    REQUIRE(found.exponent);
    CHECK(abs(*found.exponent + mpfr(5) / 2) <= found.exponent_uncertainty);
}

// Factors that vanish beyond the list make an apparent singularity in front of the true one, a thousandth of it away.
TEST_CASE("an apparent singularity of an exact equation close to the nearest one is not taken for it",
          "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    struct product {
        int order, zero;
        double exponent;
        mpfr radius;
        std::function<mpfr(int)> coefficient;
    };
    const auto central = [](int n) { return mpfr(binomial(mpfr(-1) / 2, n) * pow(mpfr(4), n)); };  // (1 - 4 x)^(-1/2)
    const mpfr quarter = mpfr(1) / 4;
    for (const product& each : std::vector<product>{
             {40, 81, -1.5, quarter, [&](int n) { return mpfr((2 * n - 81) * central(n)); }},
             {20, 41, -1.5, quarter, [&](int n) { return mpfr((2 * n - 41) * central(n)); }},
             {40, 100, -1.5, quarter, [&](int n) { return mpfr((n - 100) * central(n)); }},
             {40, 1000, -3, mpfr(1), [](int n) { return mpfr(n * n + 1000); }},
             {40, 600, -3, mpfr(1), [](int n) { return mpfr(n * n + n + 600); }},
             // (1 - x)^(-1/3) and 10^-6 x^41, an equation of which has a root with an integer exponent.
             {60, 41, -1.0 / 3, mpfr(1),
              [](int n) { return mpfr(binomial(mpfr(-1) / 3, n) + (n == 41 ? 1e-6 : 0)); }}}) {
        INFO("N = " << each.order << ", " << each.zero);
        const auto found = verdict_on(list_of(each.order, each.coefficient));
        REQUIRE(covers(found, each.radius));
        CHECK(found.uncertainty <= each.radius * mpfr(1e-30));
        REQUIRE(found.exponent);
        CHECK(abs(*found.exponent - mpfr(each.exponent)) <=
              found.exponent_uncertainty + mpfr(1e-15));  // -1/3 in double
    }
    // 1 - 1/10^8 and 1 are not distinguished: the radius is one of the two.
    const auto close = verdict_on(list_of(40, [](int n) { return mpfr(n * n + 100'000'000); }));
    CHECK(covers(close, mpfr(1)));
    CHECK(close.uncertainty < mpfr(1e-6));
    CHECK((close.uncertainty < mpfr(1e-30) || (close.kind == singularity_kind::unknown && !close.exponent)));
}

TEST_CASE("a wrong coefficient of a list that satisfies an equation is found", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    const auto exponential = [](int n) {
        mpfr factorial(1);
        for (int k = 2; k <= n; ++k) {
            factorial *= k;
        }
        return mpfr(1 / factorial);
    };
    const auto fibonacci = [](int n) {
        mpfr a(0);
        mpfr b(1);
        for (int k = 0; k < n; ++k) {
            a = std::exchange(b, mpfr(a + b));
        }
        return b;
    };
    const auto power = [](int n) { return binomial(mpfr(-1) / 3, n); };
    const auto catalan = [](int n) { return mpfr(binomial(mpfr(-1) / 2, n) * pow(mpfr(4), n) / (n + 1)); };
    struct changed {
        int order, at;
        std::function<mpfr(int)> right;
        mpfr factor;  // of the wrong coefficient
    };
    for (const changed& each : std::vector<changed>{{40, 25, exponential, mpfr(1) + mpfr(1) / 1000},
                                                    {25, 15, exponential, mpfr(11) / 10},
                                                    {60, 40, power, mpfr(11) / 10},
                                                    {60, 40, catalan, mpfr(0)},
                                                    {60, 40, fibonacci, mpfr(1) + 1 / fibonacci(40)}}) {
        auto list = list_of(each.order, each.right);
        INFO("N = " << each.order << ", n = " << each.at);
        CHECK_FALSE(verdict_on(list).suspect);
        const mpfr right = list.values[static_cast<std::size_t>(each.at)];
        list.values[static_cast<std::size_t>(each.at)] *= each.factor;
        const auto found = verdict_on(list);
        REQUIRE(found.suspect);
        CHECK(found.suspect->index == each.at);
        CHECK(found.suspect->confirmed);
        CHECK(abs(found.suspect->predicted - right) <= found.suspect->uncertainty + abs(right) * mpfr(1e-100));
    }
}

TEST_CASE("a pattern of zeros multiplies the singularities", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    // log(1 - x^2/4)/(1 + x^2/9): only even powers, singular at +-2.
    const auto found = verdict_on(list_of(80, [](int n) {
        mpfr sum(0);
        for (int k = 1; 2 * k <= n && n % 2 == 0; ++k) {
            sum -= pow(mpfr(-1) / 9, n / 2 - k) / (pow(mpfr(4), k) * k);
        }
        return sum;
    }));
    CHECK(found.pattern.stride == 2);
    CHECK(covers(found, mpfr(2)));
    CHECK(found.count == 2);
    CHECK(found.kind == singularity_kind::logarithm);
}

TEST_CASE("the damped Duffing oscillator, a psi series, gets no kind", "[convergence][verdict]") {
    const precision_scope scope(100);
    for (const auto& [damping, order] : std::vector<std::pair<std::string, int>>{
             {"0.01", 40}, {"0.01", 60}, {"0.05", 60}, {"0.1", 40}, {"0.2", 60}, {"0.4", 40}}) {
        std::vector<mpfr> x{mpfr("1.5"), mpfr(0)};
        const mpfr c(damping);
        std::vector<mpfr> square;
        for (int n = 0; n + 2 <= order; ++n) {
            mpfr of_square(0);
            for (int k = 0; k <= n; ++k) {
                of_square += x[static_cast<std::size_t>(k)] * x[static_cast<std::size_t>(n - k)];
            }
            square.push_back(of_square);
            mpfr cube(0);
            for (int k = 0; k <= n; ++k) {
                cube += square[static_cast<std::size_t>(k)] * x[static_cast<std::size_t>(n - k)];
            }
            const auto at = static_cast<std::size_t>(n);
            x.push_back((-c * (n + 1) * x[at + 1] - x[at] - cube) / ((n + 1) * (n + 2)));
        }
        const auto found = verdict_on({x, 1e-98, 1e-98});
        INFO("c = " << damping << ", N = " << order << ": " << name_of(found.kind));
        CHECK(found.radius);
        CHECK(found.kind != singularity_kind::pole);
    }
}

TEST_CASE("an equation that only the first coefficients satisfy is not one of the list", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    for (const unsigned seed : {4U, 17U}) {
        INFO(seed);
        std::mt19937 random(seed);
        const auto signs = list_of(59, [&](int) { return mpfr(random() % 2 == 0 ? 1 : -1); });
        const auto found = verdict_on(signs);
        CHECK_FALSE(found.exact);
        CHECK((!found.radius || covers(found, mpfr(1))));
    }
}

TEST_CASE("degenerate lists get a reason instead of a radius", "[convergence][verdict]") {
    const precision_scope scope(most_digits);
    for (int order = 0; order <= 11; ++order) {
        const auto found = verdict_on(list_of(order, [](int n) { return pow(mpfr(2), n); }));
        INFO("N = " << order);
        CHECK((!found.radius || covers(found, mpfr(mpfr(1) / 2))));
        CHECK_FALSE(found.note.empty());
    }
    CHECK_FALSE(verdict_on(list_of(20, [](int) { return mpfr(0); })).radius);
    const auto polynomial = verdict_on(list_of(20, [](int n) { return mpfr(n == 3 ? 1 : 0); }));
    CHECK_FALSE(polynomial.radius);
    CHECK(polynomial.note == "all coefficients after n = 3 are 0");
    const auto gaps = verdict_on(list_of(100, [](int n) { return mpfr((n & (n - 1)) == 0 ? 1 : 0); }));
    CHECK(covers(gaps, mpfr(1)));
    CHECK(gaps.kind == singularity_kind::boundary);
}

}  // namespace convergence_verdict_test
