// The sets of Taylor models against closed forms at points of the box.
#include "libration/integration/model/model_rule.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/query/sets/set_problem.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_model_model_march_test {

using namespace libration;
using namespace libration::ode;
using tests::text_of;

namespace {

constexpr long digits_of_values = 60;

integration along_models(const explicit_system& system, const state_set& start, std::size_t variables,
                         int direction = 1) {
    auto rule = std::make_shared<model_rule>(system, variables);
    flow_state begin = rule->start_from(start);
    return integration(std::move(begin), std::move(rule), infinite_distance(direction), model_rule::working_bits);
}

// At the time reached.
model_set set_of(const integration& along) { return model_state::of(along.last())->set; }

// p_i(a) and its errors.
ball value_at(const model_set& of, std::size_t i, const std::vector<ball>& a) {
    const taylor_model& model = of.models[i];
    ball sum(0);
    for (std::size_t k = 0; k < model.in().size(); ++k) {
        ball term;
        arf_set_d(arb_midref(term.handle()), model.coefficient(k));
        for (std::size_t j = 0; j < a.size(); ++j) {
            term *= pow(a[j], static_cast<long>(model.in().exponents(k)[j]));
        }
        sum += term;
    }
    return widened(sum, of.reach(i));
}

// y_i(t; p) for the numbers p of the box.
using closed_form = std::function<ball(const ball& time, const std::vector<ball>& numbers)>;

struct known_problem {
    std::string text;
    closed_form first;  // of the first unknown
    double until;
    long log2_of_errors;  // at that time
};

void check_steps(const known_problem& known, const std::vector<ball>& a) {
    const equation_system given = parse(known.text);
    const set_problem problem(given);
    const number_box box = problem.box();
    std::vector<ball> numbers;
    for (std::size_t j = 0; j < box.size(); ++j) {
        numbers.push_back(middle_of(box[j]) + radius_of(box[j]).exact() * a[j]);
    }
    integration along = along_models(problem.system(), problem.states_of(box), box.size());
    const std::size_t place = problem.own().front();
    ball end;
    arf_set_d(arb_midref(end.handle()), known.until);
    for (std::size_t k = 0; exactly_less(along.reached(), end); ++k) {
        const ball begin = along.reached();
        INFO(known.text << " at " << text_of(begin));
        const ball there = known.first(begin, numbers);
        const model_set set = set_of(along);
        const ball here = value_at(set, place, a);
        INFO(text_of(here) << " should contain " << text_of(there));
        CHECK(contains(here, there));
        CHECK(contains(set.range(place), there));
        CHECK(set.reach(place) <= magnitude::of(1, known.log2_of_errors));
        const step* const next = along[k];
        REQUIRE(next != nullptr);
        const ball half = exact_multiple(next->length(), 1, -1);
        const ball in_the_middle = known.first(exact_sum(begin, half), numbers);
        CHECK(contains(next->values(half)[place], in_the_middle));
        CHECK(contains(next->narrow_values(half)[place], in_the_middle));
        const ball whole = next->values(hull(ball(0), next->length()))[place];
        CHECK(contains(whole, in_the_middle));
        CHECK(contains(whole, there));
    }
}

}  // namespace

TEST_CASE("Taylor models contain the solutions from every point of a box", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    const std::vector<known_problem> problems = {
        {"x' = x^2; x(0) = [1/2, 1]",
         [](const ball& t, const std::vector<ball>& p) { return ball(p[0] / (ball(1) - p[0] * t)); }, 0.7, -18},
        {"x' = b*x*(1 - x); x(0) = [1/10, 1/5]; b = [1, 3]",
         [](const ball& t, const std::vector<ball>& p) {
             return ball(p[0] / (p[0] + (ball(1) - p[0]) * exp(-(p[1] * t))));
         },
         2, -7},
        {"x' = -y*(x^2 + y^2); y' = x*(x^2 + y^2); x(0) = [1/2, 1]; y(0) = 0",
         [](const ball& t, const std::vector<ball>& p) { return ball(p[0] * cos(p[0] * p[0] * t)); }, 3, -8},
        {"x' = exp(-x); x(0) = [0, 1]",
         [](const ball& t, const std::vector<ball>& p) { return ball(log(exp(p[0]) + t)); }, 4, -12},
    };
    tests::corner_numbers from(4);
    for (const known_problem& each : problems) {
        for (int trial = 0; trial < 4; ++trial) {
            std::vector<ball> a;
            for (std::size_t j = 0; j < 2; ++j) {
                a.push_back(from.half([&] { return ball(from.one_in(2) ? 1 : -1); },
                                      [&] { return exact_multiple(ball(from.between(-1024, 1024)), 1, -10); }));
            }
            a.resize(set_problem(parse(each.text)).box().size(), ball(0));
            check_steps(each, a);
        }
    }
}

TEST_CASE("the errors of a set of Taylor models move with the solutions of the whole set",
          "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    // x(0) = 1/2 + a/4 + e, |e| <= 1/8: the largest one is 7/8, where the derivative is larger than at 3/4.
    const explicit_system system(parse("x' = x^2; x(0) = 1/2"));
    const auto part = [](long eighths) { return ball(ball(eighths) / 8); };
    const state_set start{
        {part(4)}, lohner_set({{part(2)}, {ball(1)}}, {1, 1}, {magnitude(1U), magnitude()}, {magnitude::of(1, -3)})};
    integration along = along_models(system, start, 1);
    for (std::size_t k = 0; exactly_less(along.reached(), part(5)); ++k) {
        const ball largest = part(7) / (ball(1) - part(7) * along.reached());
        INFO(text_of(along.reached()));
        CHECK_FALSE(certainly_less(upper_bound(value_at(set_of(along), 0, {ball(1)})), largest));
        REQUIRE(along[k] != nullptr);
    }
}

TEST_CASE("a step of Taylor models is within the radius of its bounds", "[ode][proved][sets][models]") {
    const precision_scope scope(digits_of_values);
    // 1/(1 - t), without a width, beside unknowns that have one or not.
    for (const std::string more : {"", "; y' = b; y(0) = 0", "; y' = y; y(0) = b", "; y' = -y; y(0) = b - b"}) {
        INFO(more);
        const set_problem problem(parse("x' = x^2; x(0) = 1 + 0*b; b = [1, 2]" + more));
        integration along = along_models(problem.system(), problem.states_of(problem.box()), 1);
        for (std::size_t k = 0; along[k] != nullptr; ++k) {
            REQUIRE(exactly_less(along.reached(), ball(1)));
        }
        CHECK(along.cost() > 0);
    }
    // From a box from which no solution reaches 3.
    const set_problem wide(parse("x' = x^2 + y; y' = y; x(0) = [1/2, 1]; y(0) = [0, 1]"));
    integration along = along_models(wide.system(), wide.states_of(wide.box()), 2);
    for (std::size_t k = 0; along[k] != nullptr; ++k) {
        REQUIRE(exactly_less(along.reached(), ball(1)));
    }
}

namespace {

// A polynomial of at most degree 3 in the first `unknowns` of x, y, z, and sometimes the time or a function.
std::string right_side(tests::corner_numbers& from, std::size_t unknowns) {
    const std::vector<std::string> names = {"x", "y", "z"};
    const std::vector<std::string> others = {"sin(x)", "exp(-x)/2", "1/(4 + x^2)", "cos(t)", "t/2"};
    std::string text;
    for (long terms = from.between(1, 3); terms > 0; --terms) {
        text += (from.one_in(2) ? " + " : " - ") + std::to_string(from.between(1, 8)) + "/4";
        for (long factors = from.between(0, 3); factors > 0; --factors) {
            text += "*" + names[from.below(unknowns)];
        }
    }
    return from.one_in(3) ? text + " + " + others[from.below(others.size())] : text;
}

}  // namespace

TEST_CASE("solutions of random problems are in the sets of Taylor models", "[ode][proved][sets][models]") {
    tests::corner_numbers from(5);
    const std::vector<std::string> names = {"x", "y", "z"};
    int compared = 0;
    for (int trial = 0; trial < 30; ++trial) {
        const auto unknowns = static_cast<std::size_t>(from.between(1, 3));
        std::string text;
        for (std::size_t i = 0; i < unknowns; ++i) {
            const long centre = from.between(-8, 8);
            const long width = from.between(1, 3);
            text += names[i] + "' =" + right_side(from, unknowns) + "; " + names[i] + "(0) = [(" +
                    std::to_string(centre - width) + ")/8, (" + std::to_string(centre + width) + ")/8]; ";
        }
        const int direction = from.one_in(4) ? -1 : 1;
        INFO(text << direction);
        const precision_scope scope(digits_of_values);
        const set_problem problem(parse(text));
        const number_box box = problem.box();
        integration along = along_models(problem.system(), problem.states_of(box), unknowns, direction);
        std::optional<flow_state> reached;
        for (std::size_t k = 0; k < 12; ++k) {
            const step* const next = along[k];
            if (next == nullptr || next->reaches(ball(8))) {
                break;
            }
            reached = next->end();
        }
        for (int corner = 0; reached && corner < 3; ++corner) {
            std::vector<ball> a;
            for (std::size_t j = 0; j < unknowns; ++j) {
                a.emplace_back(from.between(-1, 1));
            }
            std::vector<ball> start;
            for (const std::string& name : problem.names()) {
                const auto j =
                    static_cast<std::size_t>(std::ranges::find(problem.sets(), name + "(0)") - problem.sets().begin());
                start.push_back(middle_of(box[j]) + radius_of(box[j]).exact() * a[j]);
            }
            proved_march single(problem.system(), start, 120);
            const auto there = single.at(reached->time);
            REQUIRE(there);  // all solutions from the box exist
            for (std::size_t i = 0; i < unknowns; ++i) {
                INFO(text_of(value_at(model_state::of(*reached)->set, i, a))
                     << " should contain " << text_of((*there)[i]));
                CHECK(contains(value_at(model_state::of(*reached)->set, i, a), (*there)[i]));
                ++compared;
            }
        }
    }
    CHECK(compared > 100);
}

}  // namespace integration_model_model_march_test
