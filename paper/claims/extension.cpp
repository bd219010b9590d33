// Claims of section III C: the series from the top on [0, T*], its extension to all times, its error, figures
// `librationfixed` to `librationseries`.
#include <algorithm>

#include "judging.hpp"
#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/singularities.hpp"

namespace libration {

using namespace series;
using namespace pendulum;

namespace {

using namespace judging;

// The series from the top in t, clockwise rotation with its own initial conditions, to so many powers that the
// remaining ones are below 1e-45 at T*.
class top_series {
public:
    explicit top_series(const char* energy, int direction = 1) : arc_(arc_of<mpfr>(of_energy(energy))) {
        const mpfr height = singularity_height(arc_.level()) / arc_.effective_period();
        const mpfr rate = log(1 + height * height) / 2;  // log(R/T*)
        const int order = nearest_integer(45 * log(mpfr(10)) / rate).convert_to<int>() + 2;
        auto start = arc_.start();
        start.state.omega *= direction;
        a_ = taylor_coefficients(start, order, arc_.effective_period(), recurrence::symmetric_squares);
    }

    const mpfr& duration() const { return arc_.effective_period(); }
    mpfr operator()(const mpfr& t) const { return evaluate(a_, mpfr(t / duration())).value; }

private:
    fundamental_arc<mpfr> arc_;
    power_series<mpfr> a_;
};

claim series_is_exact_to_the_bottom() {
    return {"series_is_exact_to_the_bottom",
            "seriesfixed",
            "From (arccos(1-E), 0) below E = 2 and (pi, +-sqrt(2E-4)) above, the series is the motion for |t| <= T*.",
            "largest |series - integrated| at t = +-T*/2 and +-T*, E = 0.5, 1.71, 2.02, 8, both directions",
            "",
            "./run trajectory --energy 1.71 --method series --order 200 --times T/8,T/4 --digits 15",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                    for (const int d : {1, -1}) {
                        const top_series series(energy, d);
                        const auto top = top_of(number(energy), d);
                        for (const int halves : {-2, -1, 1, 2}) {
                            const mpfr t = series.duration() * halves / 2;
                            const mpfr theta = by_flow(top.value, top.slope, t).value;
                            largest = std::max(largest, mpfr(abs(series(t) - theta)));
                        }
                    }
                }
                return by_error(largest);
            }};
}

claim series_passes_the_bottom() {
    return {"series_passes_the_bottom",
            "sec:sing, text",
            "From the top the series converges beyond T* at every energy.",
            "largest |sum to n = 1000 - integrated| half way between T* and R, E = 0.5, 1.71, 2.02, 8",
            "",
            "./run coefficients --energy 2.02 --order 20",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71", "2.02", "8"}) {
                    const auto arc = arc_of<mpfr>(of_energy(energy));
                    const mpfr height = singularity_height(arc.level()) / arc.effective_period();
                    const mpfr x = (1 + sqrt(1 + height * height)) / 2;
                    const mpfr sum = evaluate(arc_series(arc, 1000), x).value;
                    const auto top = top_of(number(energy));
                    const mpfr theta = by_flow(top.value, top.slope, x * arc.effective_period()).value;
                    largest = std::max(largest, mpfr(abs(sum - theta)));
                }
                return by_test(largest < pow(mpfr(10), -15), largest);  // 0.96^1000 at E = 2.02
            }};
}

// (symmetry) as printed: t-hat = t modulo T, and a branch for each T*.
mpfr printed_extension(const top_series& series, bool rotates, int direction, const mpfr& t, const mpfr& remainder) {
    const mpfr& quarter = series.duration();
    const mpfr turn = pi<mpfr>() * 2;
    if (rotates) {
        const mpfr turns = turn * direction / (quarter * 2) * (t - remainder);
        return remainder <= quarter ? mpfr(turns + series(remainder))
                                    : mpfr(turns - series(quarter * 2 - remainder) + turn * (1 + direction));
    }
    if (remainder <= quarter) {
        return series(remainder);
    }
    if (remainder <= quarter * 2) {
        return -series(quarter * 2 - remainder);
    }
    return remainder <= quarter * 3 ? mpfr(-series(remainder - quarter * 2)) : series(quarter * 4 - remainder);
}

mpfr floored_remainder(const mpfr& t, const mpfr& period) { return t - floor(t / period) * period; }

// Largest |(symmetry) - integrated| at 16 times of the periods first .. first + 1, none of them a joint.
mpfr extension_error(const char* energy, int direction, int first_period) {
    const bool rotates = number(energy) > 2;
    const top_series series(energy, direction);
    const mpfr period = series.duration() * (rotates ? 2 : 4);
    const auto top = top_of(number(energy), direction);
    flow<mpfr> along(top.value, top.slope);
    mpfr largest(0);
    for (int i = 0; i < 16; ++i) {
        const mpfr t = period * first_period + period * (2 * i + 1) / 16;
        const mpfr printed = printed_extension(series, rotates, direction, t, floored_remainder(t, period));
        largest = std::max(largest, mpfr(abs(printed - along.advance_to(t).theta.re)));
    }
    return largest;
}

claim libration_extension() {
    return {"libration_extension",
            "symmetry",
            "Below E = 2 the four branches, with signs +, -, -, +, extend the series from [0, T*] to every t >= 0.",
            "largest |extended - integrated| at 16 times of two periods, E = 0.5 and 1.71",
            "",
            "./run trajectory --energy 1.71 --method series --order 200 --times T/8:15T/8:8 --digits 15",
            [] { return by_error(std::max(extension_error("0.5", 1, 0), extension_error("1.71", 1, 0))); }};
}

claim counterclockwise_extension() {
    return {"counterclockwise_extension",
            "symmetry",
            "Above E = 2 the two branches with the upper signs, and the constant 4 pi, extend the counterclockwise "
            "series to every t >= 0.",
            "largest |extended - integrated| at 16 times of two periods, E = 2.02 and 8",
            "",
            "./run trajectory --energy 2.02 --method series --order 300 --times T/8:15T/8:8 --digits 12",
            [] { return by_error(std::max(extension_error("2.02", 1, 0), extension_error("8", 1, 0))); }};
}

claim clockwise_extension() {
    return {"clockwise_extension",
            "symmetry",
            "The lower signs, with the constant 0, do the same for clockwise rotation, which starts from pi as well.",
            "largest |extended - integrated| at 16 times of two periods, E = 2.02 and 8",
            "",
            "./run trajectory --energy 2.02 --direction - --method series --order 300 --times T/8:15T/8:8 --digits 12",
            [] { return by_error(std::max(extension_error("2.02", -1, 0), extension_error("8", -1, 0))); }};
}

claim branches_join() {
    return {
        "branches_join",
        "symmetry",
        "Neighbouring branches, both said to hold at the joints, agree there.",
        "largest jump of theta at t = T*, 2T*, 3T*, 4T*, E = 1.71, and E = 2.02 in both directions, and of |theta(T*)| "
        "against 0, 2 pi, 0",
        "",
        "./run trajectory --energy 2.02 --direction - --times T/2,T,3T/2",
        [] {
            const top_series swing("1.71");
            const top_series up("2.02", 1);
            const top_series down("2.02", -1);
            const mpfr half_turn = pi<mpfr>();
            // The joints are: series(T*) = -series(T*); -series(0) twice; 2 pi at T* for +, 0 for -; pi +- 2 pi at T.
            const mpfr middle =
                std::max({mpfr(abs(swing(swing.duration()))), mpfr(abs(up(up.duration()) * 2 - half_turn * 4)),
                          mpfr(abs(down(down.duration()) * 2))});
            const mpfr end = std::max(mpfr(abs(-up(mpfr(0)) + half_turn * 4 - (half_turn * 2 + up(mpfr(0))))),
                                      mpfr(abs(-down(mpfr(0)) - (-half_turn * 2 + down(mpfr(0))))));
            return by_error(std::max(middle, end));
        }};
}

claim remainder_of_time() {
    return {"remainder_of_time",
            "symmetry, text",
            "t modulo T is the time beyond the smallest integer multiple of T.",
            "time beyond T, the smallest positive multiple, at t = 5T/2, over T: the branches end at 1",
            "It is the time beyond the largest integer multiple of T that does not exceed t: at t = 5T/2 it is T/2, "
            "not 3T/2.",
            "./run trajectory --energy 2.02 --times T/2,5T/2",
            [] {
                const top_series series("2.02");
                const mpfr period = series.duration() * 2;
                const mpfr t = period * 5 / 2;
                const auto top = top_of(number("2.02"));
                const mpfr extended = printed_extension(series, true, 1, t, floored_remainder(t, period));
                const mpfr corrected = abs(extended - by_flow(top.value, top.slope, t).value);
                const mpfr beyond_smallest = (t - period) / period;
                return by_tests(beyond_smallest < 1, corrected < negligible(), beyond_smallest);
            }};
}

claim negative_times() {
    return {
        "negative_times",
        "sec:convergence, footnote 8",
        "The extension gives the solution at all times, with the modulo of most programming languages.",
        "time at which a remainder with the sign of t evaluates the series, over its radius R, t = -3T/8, E = 1.71",
        "Printed for t >= 0. It holds for t < 0 too with a remainder in [0, T), as MATLAB's mod; not with one of the "
        "sign of t, as fmod and % of C: at E = 1.71 and t = -3T/8 = -1.24 R the series would be asked where it "
        "diverges.",
        "./run trajectory --energy 1.71 --times -3T/8,5T/8",
        [] {
            const mpfr corrected = std::max(
                {extension_error("1.71", 1, -2), extension_error("2.02", 1, -2), extension_error("2.02", -1, -2)});
            const motion m = of_energy("1.71");
            const mpfr radius = singularities<mpfr>(m)->radius(phase_map<mpfr>::at_quarter(1));
            const mpfr asked = effective_period_of("1.71") * 3 / 2 / radius;
            return by_tests(asked < 1, corrected < negligible(), asked);
        }};
}

claim origin_shift() {
    return {"origin_shift",
            "sec:convergence, text",
            "For any initial condition the extended solution of its energy, shifted in time, is the motion.",
            "distance of theta0 = 2 pi + 1/2 (with omega0 = 1) from the largest angle of the extended solution of its "
            "energy",
            "The solution of (newseries) swings about theta = 0 (and turns the way that +- says): a state about 2 pi n "
            "also needs 2 pi n added. The state (2 pi + 1/2, 1), E = 0.622, is 5.60 beyond the largest angle.",
            "./run trajectory --theta0 6.78318530717958647692528676656 --omega0 1 --times 0,1",
            [] {
                // theta0 = 2 pi + 1/2, theta0 - 2 pi = 1/2.
                const mpfr turn = pi<mpfr>() * 2;
                const mpfr start = turn + mpfr(1) / 2;
                const mpfr energy = 1 - cos(start) + mpfr(1) / 2;
                const mpfr printed = start - acos(1 - energy);
                // The extended solution shifted by the time since the top, with the whole turn added.
                const motion m = of_state("1/2", "1");
                const auto since = phase_map<mpfr>(m).at(exact{}).offset;
                const auto o = energy_level_of<mpfr>(m);
                const auto top = top_of(energy);
                const mpfr duration = effective_period(o);
                mpfr corrected(0);
                for (const int t : {0, 1, 5}) {
                    const mpfr shifted = by_flow(top.value, top.slope, t + since - duration).value + turn;
                    corrected = std::max(corrected, mpfr(abs(shifted - by_flow(start, mpfr(1), mpfr(t)).value)));
                }
                return by_errors(printed, corrected);
            }};
}

mpfr series_norm(const char* energy, int order) {
    return arc_errors(of_energy(energy)).norm(arc_method::series, order).norm;
}

claim figure_libration_orders() {
    return {"figure_libration_orders",
            "fig:librationfixed",
            "At E = 1.71 the series that starts at the top, drawn for N = 2, 4 and 6, converges.",
            "norm of the error on [0, T*] at N = 6 over that at N = 2 (0.186 and 0.324; 0.372 at N = 4)",
            "",
            "./run study error_norm --energies 1.71 --orders 2,4,6",
            [] {
                const mpfr two = series_norm("1.71", 2);
                const mpfr six = series_norm("1.71", 6);
                return by_test(six < two && series_norm("1.71", 60) < six / 1000000, six / two);
            }};
}

// |a_N| T*^N at the top, by the recurrence without use of parity.
mpfr last_term(const char* energy, int order) {
    const mpfr duration = effective_period_of(energy);
    return abs(printed_series(top_of(number(energy)), order, duration)[order]);
}

claim figure_rotation_orders() {
    return {"figure_rotation_orders",
            "fig:rotationfixed, caption",
            "For rotation at E = 2.02 the sums up to and including the powers N = 3, 6 and 36 are drawn.",
            "largest |a_N| T*^N at N = 6 and 36",
            "Rotation from the top has odd powers only: N = 6 and 36 end with the powers 5 and 35.",
            "./run coefficients --energy 2.02 --order 6",
            [] {
                const mpfr even = std::max(last_term("2.02", 6), last_term("2.02", 36));
                const mpfr odd = std::min({last_term("2.02", 3), last_term("2.02", 5), last_term("2.02", 35)});
                return by_tests(even > negligible(), odd > negligible(), even);
            }};
}

claim figure_near_separatrix_orders() {
    return {"figure_near_separatrix_orders",
            "fig:librationseries, caption",
            "For libration at E = 1.9998 the sums up to and including the powers N = 5, 10 and 20 are drawn.",
            "|a_5| T*^5",
            "Libration from the top has even powers only: N = 5 ends with the power 4.",
            "./run coefficients --energy 1.9998 --order 5",
            [] {
                const mpfr odd = last_term("1.9998", 5);
                const mpfr even = std::min({last_term("1.9998", 4), last_term("1.9998", 10), last_term("1.9998", 20)});
                return by_tests(odd > negligible(), even > negligible(), odd);
            }};
}

claim error_grows_towards_separatrix() {
    return {"error_grows_towards_separatrix",
            "fig:error, text",
            "At a given number of terms the error grows as E approaches 2.",
            "norm of the error on [0, T*] at E = 1.4 over that at E = 0.5, N = 2",
            "As an envelope. At N = 2 it is 0.183 at E = 0.5 and 0.044 at E = 1.4; at N = 4 it is 0.379 at E = 1.8 and "
            "0.322 at E = 1.9. It dips wherever the first coefficient left out, like sin(n phi), goes through 0.",
            "./run study error_norm --energies 0.5,1.4,1.8,1.9 --orders 2,4",
            [] {
                const mpfr ratio = series_norm("1.4", 2) / series_norm("0.5", 2);
                const mpfr near = series_norm("1.9", 4) / series_norm("1.8", 4);
                const bool envelope = series_norm("1.9998", 20) > series_norm("1.9", 20) &&
                                      series_norm("1.9", 20) > series_norm("0.5", 20);
                return by_tests(ratio >= 1 && near >= 1, envelope, ratio);
            }};
}

// The first N such that |theta(T*) - sum to n| stays below a bound for all n = N .. order.
int terms_for(const char* energy, const mpfr& bound, int order) {
    const auto arc = arc_of<mpfr>(of_energy(energy));
    const auto a = arc_series(arc, order);
    mpfr sum(0);
    int needed = 0;
    for (int n = 0; n <= order; ++n) {
        sum += a[n];
        if (abs(sum - arc.bottom().value) > bound) {
            needed = n + 1;
        }
    }
    return needed;
}

claim machine_precision_is_reached() {
    return {
        "machine_precision_is_reached",
        "fig:error, text",
        "At any given energy enough terms bring the error down to machine precision.",
        "N from which on the error at T* stays below 2^-52, E = 1.9998: finite, found with N up to 1600 (E = 0.5 takes "
        "68)",
        "",
        "./run trajectory --energy 1.9998 --method series --order 958 --times T/4 --digits 20",
        [] {
            const int needed = terms_for("1.9998", ldexp(mpfr(1), -52), 1600);
            return by_test(needed < 1600 && terms_for("0.5", ldexp(mpfr(1), -52), 1600) < 100, mpfr(needed));
        }};
}

// A path around the quarter disk 0 -> T* -> i T* -> 0, its arc in eight chords.
mpfr gain_around_quarter_disk(const char* energy) {
    const mpfr duration = effective_period_of(energy);
    const auto top = top_of(number(energy));
    flow<mpfr> along(top.value, top.slope);
    for (int eighth = 0; eighth <= 8; ++eighth) {
        const mpfr angle = pi<mpfr>() * eighth / 16;
        along.advance_to(duration * cos(angle), duration * sin(angle));
    }
    const auto& back = along.advance_to(mpfr(0));
    return modulus_of(back.theta - complex_number<mpfr>{top.value, mpfr(0)});
}

claim disk_is_free_of_singularities() {
    return {"disk_is_free_of_singularities",
            "fig:error, text",
            "From the top no singularity lies in |t| < T*.",
            "largest |theta gained| on the path 0, T*, around the circle to i T*, and back, E = 0.5, 1.71, 1.9, 2.02, "
            "8 (the other quarters are mirror images)",
            "",
            "./run coefficients --energy 1.9998 --order 20",
            [] {
                mpfr largest(0);
                for (const char* energy : {"0.5", "1.71", "1.9", "2.02", "8"}) {
                    largest = std::max(largest, gain_around_quarter_disk(energy));
                }
                return by_error(largest);
            }};
}

}  // namespace

std::vector<claim> claims_of_extension() {
    return {series_is_exact_to_the_bottom(),
            series_passes_the_bottom(),
            libration_extension(),
            counterclockwise_extension(),
            clockwise_extension(),
            branches_join(),
            remainder_of_time(),
            negative_times(),
            origin_shift(),
            error_grows_towards_separatrix(),
            machine_precision_is_reached(),
            disk_is_free_of_singularities(),
            figure_libration_orders(),
            figure_rotation_orders(),
            figure_near_separatrix_orders()};
}

}  // namespace libration
