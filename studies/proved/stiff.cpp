// How long are stiff problems followed with proved digits, and how many explicit steps would take their place?
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "../shared/named_choice.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/problem/problem_family.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "sweep/study.hpp"
#include "test_problems.hpp"
#include "text/members.hpp"

namespace libration::studies {

namespace stiff_study {

namespace {

// A problem of the set with the end of its interval in the literature, and its name in this study.
struct stiff_problem {
    std::string name;
    std::string in_set;
};

// Autonomous ones.
const std::vector<stiff_problem>& stiff_problems() {
    static const std::vector<stiff_problem> all{{"robertson", "robertson_1e11"},
                                                {"stiff_e5", "stiff_e5_1e13"},
                                                {"oregonator", "oregonator_360"},
                                                {"hires", "hires_421"},
                                                {"van_der_pol_1000", "van_der_pol_1000_2000"},
                                                {"stiff_d4", "stiff_d4"}};
    return all;
}

constexpr int times_of_each = 12;
// Beyond the digits that are asked for.
constexpr long guard_bits = 64;

// A time that a run has passed.
struct stiff_row {
    std::string problem;
    std::string time;
    double digits = 0;
    long steps = 0;
    double explicit_steps = 0;
    double seconds = 0;
};

const column_list<stiff_row>& columns() {
    using row = stiff_row;
    static const column_list<row> all{
        {"problem", "name in the set", [](const row& r) { return r.problem; }},
        {"time", "up to which it is followed", [](const row& r) { return number_cell(r.time); }},
        {"digits", "decimal digits of the least accurate unknown, relative to itself, by the width of its enclosure",
         [](const row& r) { return decimal_cell(mpfr(r.digits), 4); }},
        {"steps", "of both integrators up to there", [](const row& r) { return r.steps; }},
        {"log10_explicit_steps",
         "log10 of the number of steps of Taylor series alone, from the length of one at the beginning of each step: "
         "an estimate",
         [](const row& r) { return decimal_cell(mpfr(std::log10(r.explicit_steps)), 4); }},
        {"log10_ratio", "log10 of the quotient of both numbers",
         [](const row& r) {
             return decimal_cell(mpfr(std::log10(r.explicit_steps / static_cast<double>(r.steps))), 4);
         }},
        {"rigour", "of digits", [](const row&) { return "proved"; }},
    };
    return all;
}

const column_list<stiff_row>& time_columns() {
    using row = stiff_row;
    static const column_list<row> all{
        {"problem", "name in the set", [](const row& r) { return r.problem; }},
        {"time", "up to which it is followed", [](const row& r) { return number_cell(r.time); }},
        {"seconds", "on one core of this machine, from the initial time on",
         [](const row& r) { return decimal_cell(mpfr(r.seconds), 3); }},
    };
    return all;
}

double rounded(const ball& x) { return midpoint_of(x).convert_to<double>(); }

// The digits of the least accurate of the values; 0 if one of them may be 0.
double digits_of(const std::vector<ball>& values) {
    double least = 1e9;
    for (const ball& each : values) {
        const double bits = log_of(magnitude::below(each)) - log_of(magnitude::radius_of(each));
        least = std::min(least, bits * std::log10(2.));
    }
    return std::max(least, 0.);
}

// Follows one solution and counts steps.
class stiff_run {
public:
    stiff_run(const ode::explicit_system& system, long bits)
        : system_(system),
          bits_(bits),
          along_(ode::start_of(system, bits), ode::rule_for(system, {bits}), ode::infinite_distance(1), bits) {
        explicit_route_.integrator = ode::integrator_choice::taylor;
    }

    // The unknowns at a time after the previous one. Throws error if the run does not reach it.
    std::vector<ball> at(const ode::number& time) {
        const precision_scope scope(decimal_digits(bits_) + 20);
        const ball target = ode::constant_value<ball>::of(time);
        for (;;) {
            const auto begin = clock::now();
            const ode::step* const here = along_[number_];
            if (here == nullptr) {
                throw error(error_kind::undecided, error_subject::time, as_text(time),
                            "is not reached with these digits");
            }
            const ball rest = target - here->from().time;
            const bool last = here->reaches(rest);
            const ball way = last ? rest : here->length();
            auto values = last ? here->values(rest) : std::vector<ball>();
            const double passed = length_of_explicit_step(here->values(ball(0)), begin);
            if (last) {
                part_ = rounded(way) / passed;
                return values;
            }
            along_.forget_before(number_++);
            explicit_steps_ += rounded(way) / passed;
        }
    }

    long steps() const { return static_cast<long>(number_) + 1; }
    double explicit_steps() const { return std::max(explicit_steps_ + part_, static_cast<double>(steps())); }
    double seconds() const { return seconds_; }

private:
    using clock = std::chrono::steady_clock;

    static double seconds_since(clock::time_point begin) {
        return std::chrono::duration<double>(clock::now() - begin).count();
    }

    static std::string as_text(const ode::number& time) { return to_decimal(ode::constant_value<mpfr>::of(time), 6); }

    // From a state; the time that this takes is not that of the run.
    double length_of_explicit_step(const std::vector<ball>& state, clock::time_point begin) {
        seconds_ += seconds_since(begin);
        std::vector<ball> centre;
        for (const ball& each : state) {
            centre.push_back(ode::exact_midpoint(each));
        }
        ode::flow_state start = ode::start_of(system_, bits_);
        start.set = ode::box_around(centre, bits_);
        ode::integration there(std::move(start), ode::rule_for(system_, {bits_}, explicit_route_),
                               ode::infinite_distance(1), bits_);
        const ode::step* const step = there[0];
        if (step == nullptr) {
            throw error(error_kind::undecided, error_subject::time, "", "has no step of Taylor series to compare with");
        }
        return rounded(step->length());
    }

    const ode::explicit_system& system_;
    long bits_;
    ode::proof_route explicit_route_;
    ode::integration along_;
    std::size_t number_ = 0;
    double explicit_steps_ = 0, part_ = 0, seconds_ = 0;
};

std::vector<table> tables_of(const stiff_problem& asked, long digits) {
    const proved::test_problem& of = named(proved::test_problems(), asked.in_set);
    const ode::explicit_system system(of.equations());
    const precision_scope scope(digits);
    stiff_run run(system, ball::working_bits() + guard_bits);
    std::vector<stiff_row> rows;
    for (const ode::number& time : of.times(times_of_each)) {
        const auto values = run.at(time);
        rows.push_back({asked.name, decimal_of(rational(*time.fraction()), 20), digits_of(values), run.steps(),
                        run.explicit_steps(), run.seconds()});
    }
    return {make_table(columns(), rows), make_table(time_columns(), rows)};
}

const named_choice& problems_to_choose() {
    static const named_choice result{.axis = "problem",
                                     .option = "--problems",
                                     .help = "stiff problems",
                                     .forms = "LIST, or all",
                                     .remedy = "write names such as robertson,hires, or all",
                                     .what = "not a problem of this set",
                                     .names = members_of(stiff_problems(), &stiff_problem::name)};
    return result;
}

// One after the other, whatever the number of jobs: concurrent runs would disturb the times.
study_plan plan(const study_request& request) {
    std::vector<stiff_problem> problems;
    for (const std::string& name : chosen_names(problems_to_choose(), request.values)) {
        problems.push_back(named(stiff_problems(), name));
    }
    const scalar_spec scalar = request.scalar.value_or(read_scalar("ball:30", arithmetics::proved_too));
    study_table times = head_of("time", scalar, time_columns());
    times.timed = true;
    return plan_of_cells(
        {head_of("", scalar, columns()), std::move(times)}, {"problem"}, problems.size(),
        [problems](std::size_t i) {
            return cell_inputs{{"problem", problems[i].name}};
        },
        [problems, digits = scalar.digits](std::size_t i) { return tables_of(problems[i], digits); });
}

const problem_family& problems_of_study() {
    static const problem_family result{.name = "stiff problems", .axes = {axis_of(problems_to_choose())}};
    return result;
}

}  // namespace
}  // namespace stiff_study

const study& stiff() {
    using namespace stiff_study;
    static const study result{
        .name = "stiff",
        .title = "Stiff problems",
        .question = "How far are stiff problems followed with proved digits, and in place of how many explicit steps?",
        .reading =
            "Left: the proved digits of the least accurate unknown against the time that is reached. Middle: the "
            "seconds from the initial time on. Right: how many steps Taylor series alone would "
            "take, in units of the steps that are taken. Steps grow with the time scale of the solution, so that the "
            "cost of Robertson's equations grows with the logarithm of the time, while explicit steps remain as short "
            "as the fastest decay; relaxation oscillations, such as van der Pol's, need new short steps in each jump.",
        .of = &problems_of_study(),
        .parameters = {{"--problems", "all", "stiff problems"}, {"--scalar", "ball:30", "digits that are asked for"}},
        .quick = {{"--problems", "stiff_d4", ""}, {"--scalar", "ball:15", ""}},
        .seconds = 30,
        .plan = plan,
        .offers = arithmetics::proved_too,
        .alone = true};
    return result;
}

}  // namespace libration::studies
