// theta and omega at many times: the sampler compared with Jacobi's functions of GSL and of Boost.Math in double, with
// Boost.Math in quad, and with a numerical integration by Boost.odeint. All in one run on one thread, in turns, the
// sampler also with each available set of vector instructions; medians of CPU time with their spread.
// GSL, which may not be linked here, times itself in a separate program.
//
//   ./run bench trajectory
//
// Every route is compared with proved values: Libration must keep its bound of 4 units of the last place of max(1,
// |theta|), the others in double 1000 (k is rounded, and the time is ten times the period), Boost.Math in quad 10^7
// (its dn is a quotient of two cosines that vanish together at the quarters, and 2000 times come within 10^-3 of some;
// in double it computes in long double), the integration 10^-8. Exits with status 1 if one does not.
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint.hpp>

#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>

#include "libration/pendulum/proved_motion.hpp"
#include "libration/pendulum/sampler.hpp"
#include "libration/scalar/vector_instructions.hpp"
#include "ratio_table.hpp"
#include "rounds.hpp"
#include "run/child_program.hpp"

namespace {

using namespace libration;
using namespace libration::series;
using namespace libration::elliptic;
using namespace libration::pendulum;
using namespace libration::bench;

constexpr int rounds = 15;
constexpr double ours_allowed = 4;
constexpr double theirs_allowed = 1000;
constexpr double boost_allowed_in_quad = 1e7;

template <class T>
struct trajectory {
    explicit trajectory(std::vector<T> asked) : times(std::move(asked)), theta(times.size()), omega(times.size()) {}

    std::vector<T> times;
    std::vector<T> theta;
    std::vector<T> omega;
};

template <class T>
exact exact_of(const T& x) {
    rational q;
    mpfr_get_q(q.backend().data(), handle(widen(x)));
    return exactly(q);
}

template <class T>
mpfr unit_of(const mpfr& x) {
    const mpfr size = abs(x) < 1 ? mpfr(1) : mpfr(abs(x));
    return ldexp(widen(epsilon<T>()), static_cast<int>(binary_exponent(size)) - 1);
}

// The largest error of theta and omega at 200 of the times, in units of the last place of max(1, |theta|) and of max(1,
// max |omega|).
template <class T>
double worst_units(const motion& m, const trajectory<T>& found) {
    const precision_scope scope(80);
    const proved_motion proved(m);
    const mpfr fastest = sqrt(mpfr(energies<mpfr>(m).energy * 2));
    const mpfr unit_of_speed = unit_of<T>(fastest);
    mpfr worst(0);
    const std::size_t step = std::max<std::size_t>(1, found.times.size() / 200);
    for (std::size_t i = 0; i < found.times.size(); i += step) {
        const auto truth = proved.at(exact_of(found.times[i]));
        const mpfr theta = midpoint_of(truth.theta);
        const mpfr angle = abs(mpfr(widen(found.theta[i]) - theta)) / unit_of<T>(theta);
        const mpfr speed = abs(mpfr(widen(found.omega[i]) - midpoint_of(truth.omega))) / unit_of_speed;
        worst = std::max({worst, angle, speed});
    }
    return static_cast<double>(worst);
}

// Throws std::runtime_error for a route whose error exceeds the allowed one.
std::string allowed_units(const std::string& route, double units, double allowed) {
    if (!(units <= allowed)) {
        throw std::runtime_error(
            fmt::format("{} is off by {:.1f} units in the last place, more than {}", route, units, allowed));
    }
    return fmt::format("{:.1f}", units);
}

// Adds a route: runs it once, compares, and stores it for the rounds.
template <class T, class Work>
void add(std::vector<contender>& all, const std::string& name, double allowed, const motion& m, trajectory<T>& in,
         Work work) {
    std::fill(in.theta.begin(), in.theta.end(), T(0));
    work(in);
    all.push_back(
        {name, timed(in.times.size(), [&in, work] { work(in); }), allowed_units(name, worst_units(m, in), allowed)});
}

// Times in ten periods of either sign, in random order.
template <class T>
std::vector<T> random_times(const motion& m, std::size_t count) {
    const precision_scope scope(60);
    const mpfr reach = has_passages(m) ? mpfr(passage_interval(m) * 20) : mpfr(100);
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> part(-1, 1);
    std::vector<T> times(count);
    for (T& t : times) {
        t = narrow<T>(reach * part(engine));
    }
    return times;
}

// theta = 2 asin(k cd), omega = -2 k k' sn/dn from the top: one call for the three functions.
template <class T>
void by_boost(const modulus<T>& m, trajectory<T>& in) {
    using std::asin;
    for (std::size_t i = 0; i < in.times.size(); ++i) {
        T cn(0);
        T dn(0);
        const T sn = boost::math::jacobi_elliptic(m.k, in.times[i], &cn, &dn);
        in.theta[i] = asin(T(m.k * cn / dn)) * 2;
        in.omega[i] = m.k * m.complement * sn / dn * -2;
    }
}

#ifdef LIBRATION_GSL_TRAJECTORY
// GSL's own timing; the values are stored in `in`.
double by_gsl(const modulus<double>& m, const std::string& times, trajectory<double>& in) {
    const std::string input = fmt::format("{:a} {:a} 1 {}\n", m.k, m.complement, in.times.size()) + times;
    std::istringstream answer(output_of_program(LIBRATION_GSL_TRAJECTORY, input));
    double nanoseconds = 0;
    answer >> nanoseconds;
    std::string angle;
    std::string speed;
    for (std::size_t i = 0; i < in.times.size(); ++i) {
        answer >> angle >> speed;
        in.theta[i] = std::strtod(angle.c_str(), nullptr);
        in.omega[i] = std::strtod(speed.c_str(), nullptr);
    }
    return nanoseconds;
}

void add_gsl(std::vector<contender>& all, const modulus<double>& shape, const motion& m, trajectory<double>& in) {
    std::string times;
    for (const double t : in.times) {
        times += fmt::format("{:a}\n", t);
    }
    by_gsl(shape, times, in);
    const char* const name = "GSL gsl_sf_elljac, asin";
    all.push_back({name, [shape, times, &in] { return by_gsl(shape, times, in); },
                   allowed_units(name, worst_units(m, in), theirs_allowed)});
}
#endif

// One libration, double compared with GSL and Boost.Math.
void compare_in_double(const exact& energy, std::size_t count) {
    const motion m = motion::of_energy(energy.coefficient);
    const modulus<double> shape = energy_level_of<double>(m).modulus;
    trajectory<double> in(random_times<double>(m, count));
    const sampler<double> sample(m);
    std::vector<contender> all;
    add(all, "libration sampler<double>, arrays", ours_allowed, m, in,
        [&](trajectory<double>& of) { sample(of.times, of.theta, of.omega); });
    for (const std::string& instructions : vector_instructions()) {
        add(all, "libration sampler<double>, arrays, " + instructions, ours_allowed, m, in,
            [&sample, instructions](trajectory<double>& of) {
                const vector_instructions_scope by(instructions);
                sample(of.times, of.theta, of.omega);
            });
    }
    add(all, "libration sampler<double>, time by time", ours_allowed, m, in, [&](trajectory<double>& of) {
        for (std::size_t i = 0; i < of.times.size(); ++i) {
            const jet<double> state = sample(of.times[i]);
            of.theta[i] = state.value;
            of.omega[i] = state.slope;
        }
    });
#ifdef LIBRATION_GSL_TRAJECTORY
    add_gsl(all, shape, m, in);
#else
    fmt::print("(GSL was not found when this was configured)\n");
#endif
    add(all, "Boost.Math jacobi_elliptic<double>, asin", theirs_allowed, m, in,
        [&](trajectory<double>& of) { by_boost(shape, of); });
    run_rounds(all, rounds);
    print_ratios(fmt::format("theta and omega at {} times in 20 periods, E = {}, double", count, energy.text),
                 "error/ulp", all);
}

void compare_in_quad(const exact& energy, std::size_t count) {
    const motion m = motion::of_energy(energy.coefficient);
    const modulus<quad> shape = energy_level_of<quad>(m).modulus;
    trajectory<quad> in(random_times<quad>(m, count));
    const sampler<quad> sample(m);
    const exact_solution<quad> solution(m);
    std::vector<contender> all;
    add(all, "libration sampler<quad>", ours_allowed, m, in,
        [&](trajectory<quad>& of) { sample(of.times, of.theta, of.omega); });
    add(all, "Boost.Math jacobi_elliptic<float128>, asin", boost_allowed_in_quad, m, in,
        [&](trajectory<quad>& of) { by_boost(shape, of); });
    run_rounds(all, 5);
    print_ratios(fmt::format("theta and omega at {} times in 20 periods, E = {}, quad", count, energy.text),
                 "error/ulp", all);
}

using pendulum_pair = std::array<double, 2>;

// From rest at 1.3 to t = 10^4 with an output every 0.1, by Runge-Kutta-Fehlberg 7(8) with tolerance 1e-15.
void by_odeint(double theta0, trajectory<double>& in) {
    namespace odeint = boost::numeric::odeint;
    static const odeint::runge_kutta_fehlberg78<pendulum_pair>
        plain;  // static: GCC warns about the state that copies copy
    const auto stepper = odeint::make_controlled(1e-15, 1e-15, plain);
    pendulum_pair state{theta0, 0};
    std::size_t i = 0;
    odeint::integrate_times(
        stepper,
        [](const pendulum_pair& x, pendulum_pair& slope, double /*t*/) {
            slope[0] = x[1];
            slope[1] = -std::sin(x[0]);
        },
        state, in.times.begin(), in.times.end(), 0.1,
        [&](const pendulum_pair& x, double /*t*/) {
            in.theta[i] = x[0];
            in.omega[i] = x[1];
            ++i;
        });
}

void compare_with_integration() {
    constexpr double theta0 = 1.3;
    constexpr std::size_t count = 100'001;
    const motion m = motion::of_state(exactly(rational(theta0)), exactly(rational(0)));
    std::vector<double> grid(count);
    for (std::size_t i = 0; i < count; ++i) {
        grid[i] = static_cast<double>(i) / 10;
    }
    trajectory<double> in(std::move(grid));
    const sampler<double> sample(m);
    std::vector<contender> all;
    add(all, "libration sampler<double>, arrays", ours_allowed, m, in,
        [&](trajectory<double>& of) { sample(of.times, of.theta, of.omega); });
    add(all, "libration sampler<double>, with its set-up", ours_allowed, m, in,
        [&](trajectory<double>& of) { sampler<double>{m}(of.times, of.theta, of.omega); });
    add(all, "Boost.odeint RKF78, tolerance 1e-15", 1e-8 / 0x1p-52, m, in,
        [&](trajectory<double>& of) { by_odeint(theta0, of); });
    run_rounds(all, 5);
    print_ratios(fmt::format("from rest at {} to t = 10^4, {} outputs", theta0, count), "error/ulp", all);
}

// Where the others lose their digits: near E = 2, at it, above it, and 10^9 periods away.
void show_other_motions() {
    const auto near_two = [](const char* gap) { return motion::of_energy(rational(2 - read_exact(gap).coefficient)); };
    struct question {
        const char* name;
        motion m;
        int reach;
    };
    const std::vector<question> questions{
        {"E = 1.71", motion::of_energy(rational(171, 100)), 1},
        {"E = 1.71, up to 10^9 periods", motion::of_energy(rational(171, 100)), 100'000'000},
        {"2 - E = 1e-15", near_two("1e-15"), 1},
        {"2 - E = 1e-100", near_two("1e-100"), 1},
        {"E = 2, |t| < 100", motion::of_energy(rational(2)), 1},
        {"E = 2.5, rotation", motion::of_energy(rational(5, 2)), 1},
        {"E = 2.5, up to 10^9 periods", motion::of_energy(rational(5, 2)), 50'000'000},
        {"E = 0", motion::of_energy(rational(0)), 1}};
    std::vector<sampler<double>> samplers;
    std::vector<trajectory<double>> all_times;
    samplers.reserve(questions.size());
    all_times.reserve(questions.size());
    std::vector<contender> all;
    for (const question& each : questions) {
        const sampler<double>& sample = samplers.emplace_back(each.m);
        trajectory<double>& in = all_times.emplace_back(random_times<double>(each.m, 100'000));
        for (double& t : in.times) {
            t *= each.reach;
        }
        add(all, each.name, ours_allowed, each.m, in,
            [&sample](trajectory<double>& of) { sample(of.times, of.theta, of.omega); });
    }
    run_rounds(all, rounds);
    print_ratios("libration sampler<double>, arrays, at 100000 times in 20 periods", "error/ulp", all);
}

// The time for constructing a sampler, in ns; an output is a sampler here.
void show_set_up() {
    std::vector<contender> all;
    const auto make = [&all](const std::string& name, const motion& m) {
        all.push_back({"set-up of sampler<double>, " + name,
                       timed(100,
                             [m] {
                                 for (int i = 0; i < 100; ++i) {
                                     const sampler<double> made(m);
                                     static_cast<void>(made(1.0));
                                 }
                             }),
                       ""});
    };
    make("E = 1.71", motion::of_energy(rational(171, 100)));
    make("2 - E = 1e-15", motion::of_energy(rational(2 - read_exact("1e-15").coefficient)));
    make("2 - E = 1e-100", motion::of_energy(rational(2 - read_exact("1e-100").coefficient)));
    make("E = 2", motion::of_energy(rational(2)));
    make("E = 2.5", motion::of_energy(rational(5, 2)));
    make("from (1.3, 0.2)", motion::of_state(read_exact("1.3"), read_exact("0.2")));
    run_rounds(all, rounds);
    print_ratios("what is done once a motion (an output is a sampler)", "", all);
}

}  // namespace

int main() {
    return libration::bench::exit_code_of("trajectory", [] {
        compare_in_double(read_exact("1.71"), 100'000);
        compare_in_double(read_exact("0.1"), 100'000);
        compare_in_quad(read_exact("1.71"), 2000);
        compare_with_integration();
        show_other_motions();
        show_set_up();
        return 0;
    });
}
