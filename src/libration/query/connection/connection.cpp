#include "libration/query/connection/connection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../../algebra/dense_matrix.hpp"
#include "../../equation/bound_text.hpp"
#include "amplitude_connection.hpp"
#include "candidate.hpp"
#include "carried_connection.hpp"
#include "combined_guesses.hpp"
#include "connection_orbit.hpp"
#include "enclosed_decimal.hpp"
#include "first_guesses.hpp"
#include "layer_connection.hpp"
#include "leaving_side.hpp"
#include "libration/algebra/krawczyk.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "linear_decay.hpp"
#include "nearer_guess.hpp"
#include "orbit_symmetry.hpp"
#include "power_connection.hpp"
#include "radial_connection.hpp"
#include "searched_connection.hpp"
#include "unknown_count.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_tried = 12;
constexpr std::size_t most_moved = 4;  // first guesses, nearer to the equilibrium
constexpr double first_part_beside = 1. / 64;
constexpr double near_part_beside = 1. / 8;
constexpr long digits_beside = 30;
constexpr long least_digits_beside = 3;
constexpr long digits_of_numbers = 10;

class connection_search {
public:
    connection_search(const connection_question& question, const start_rule& begins, bool may_rest,
                      const proof_route& route, const march_watch& watch)
        : question_(question),
          map_(is_two_sided(question.limits) ? with_idle_starts(question.system) : question.system, question.unknowns,
               question.limits, route, watch) {
        map_.begins = begins;
        map_.may_rest = may_rest;
    }

    connection result() {
        const auto x = found();
        if (!x) {
            refuse_guess(
                "is not found: Newton's method does not lead to a solution with these limits from the first guess");
        }
        map_.degree = 0;
        std::vector<ball> guess;
        for (const double each : *x) {
            guess.push_back(exactly_of(each));
        }
        const auto names = map_.names(question_.unknowns);
        const auto roots = proved_part_of_root(
            [&](const std::vector<ball>& at, long bits, long error_bits) { return map_(at, bits, error_bits); }, guess,
            question_.digits, names);
        return described(roots);
    }

private:
    [[noreturn]] void refuse_guess(const std::string& reason) const {
        throw error(error_kind::undecided, error_subject::first_guess, "", reason + ": try a better initial guess");
    }

    static ball exactly_of(double x) {
        const precision_scope scope(decimal_digits(bits_of_first_iterate));
        return ball(mpfr(x));
    }

    struct attempt {
        std::vector<double> numbers;
        int side;
        double distance;
    };

    // The first guesses whose solutions come near to the equilibrium, nearest first.
    std::vector<attempt> attempts() {
        std::vector<attempt> all;
        std::optional<error> wrong_number;  // at the first of several guesses,
                                            // others may have other dimensions
        const bool is_fixed = !map_.depends_on_numbers();
        std::optional<std::vector<double>> chosen_at;  // the coordinates at the end
        for (const auto& numbers : combined_guesses(map_, question_)) {
            for (const int side : {1, -1}) {
                if (side < 0 && !map_.has_two_ends()) {
                    continue;
                }
                map_.degree = 12;
                const std::vector<double> now(numbers.begin() + static_cast<std::ptrdiff_t>(map_.numbers()),
                                              numbers.end());
                if (!is_fixed || chosen_at != now) {
                    chosen_at.reset();
                    if (!map_.choose(numbers, side)) {
                        continue;
                    }
                    chosen_at = now;
                }
                if (map_.coordinates() > 0 && map_.right().variables() == 0) {
                    continue;  // on the other side of the line of equilibria
                }
                try {
                    require_square(map_, question_.unknowns.size());
                } catch (const error& problem) {
                    wrong_number = wrong_number ? wrong_number : problem;
                    continue;
                }
                auto x = numbers;
                x.resize(map_.size());
                if (const auto approach = approach_from(map_, x)) {
                    all.push_back({numbers, side, approach->distance});
                }
            }
        }
        if (all.empty() && wrong_number) {
            throw error(*wrong_number);
        }
        std::ranges::stable_sort(all, {}, &attempt::distance);
        if (all.size() > most_tried) {
            all.resize(most_tried);
        }
        return all;
    }

    // Values between two sides, from those around the guess that is given, or from the usual ones; nearest to the guess first.
    std::vector<double> guesses_by_side(int side, double farthest) {
        if (question_.unknowns.size() != 1) {
            return {};
        }
        const double given = nearest_doubles(map_.open().values).front();
        auto found = changes_of_side(
            map_, question_.open.empty() ? guesses_around(given, first_part_beside, farthest) : signed_first_guesses(),
            side);
        std::ranges::stable_sort(found, {}, [&](double x) { return std::fabs(x - given); });
        return found;
    }

    std::optional<std::vector<double>> found_by_side(double farthest) {
        for (const int side : {1, -1}) {
            if (side < 0 && !map_.has_two_ends()) {
                continue;
            }
            for (const double x : guesses_by_side(side, farthest)) {
                if (auto found = candidate_from(map_, {x}, side)) {
                    return found;
                }
            }
        }
        return std::nullopt;
    }

    std::optional<std::vector<double>> found_nearer(const std::vector<attempt>& all) {
        for (std::size_t i = 0; i < std::min(all.size(), most_moved); ++i) {
            map_.degree = 12;
            if (!map_.choose(all[i].numbers, all[i].side)) {
                continue;
            }
            if (auto x = candidate_from(map_, nearer_guess(map_, all[i].numbers), all[i].side)) {
                return x;
            }
        }
        return std::nullopt;
    }

    std::optional<std::vector<double>> found() {
        if (auto x = found_by_side(near_part_beside)) {
            return x;
        }
        const auto all = attempts();
        if (all.empty()) {
            refuse_guess("is not found: at the first guess, the equilibrium has no invariant manifold that is proved");
        }
        if (question_.open.size() > 1) {
            if (auto x = found_nearer(all)) {
                return x;
            }
        }
        for (const attempt& each : all) {
            if (auto x = candidate_from(map_, each.numbers, each.side)) {
                return x;
            }
        }
        return question_.open.empty() ? found_by_side(1) : std::nullopt;
    }

    connection described(const std::vector<known_value>& roots) const {
        connection result;
        const std::size_t first = map_.size() - map_.right().variables();
        bool moves = false;
        for (std::size_t i = 0; i < roots.size(); ++i) {
            if (i < question_.unknowns.size() && !roots[i].decimal) {
                throw error(error_kind::undecided, error_subject::solution, "",
                            "has " + question_.unknowns[i] + " between -" + roots[i].bound + " and " + roots[i].bound +
                                ", which is not distinguished from 0");
            }
            if (i < question_.unknowns.size()) {
                result.values.push_back(*roots[i].decimal);
            }
            moves = moves || (i >= first && roots[i].decimal.has_value());
        }
        if (!moves && !map_.may_rest) {
            refuse_guess("is the constant solution");
        }
        const precision_scope scope(question_.digits + digits_beside);
        std::vector<ball> x;
        for (const known_value& each : roots) {
            x.push_back(each.decimal ? enclosed(*each.decimal) : widened(ball(0), magnitude(ball_of_text(each.bound))));
        }
        // The decay to a solution at rest is searched in other equations: their states are not those of the question.
        const auto orbit =
            map_.may_rest ? nullptr : std::make_shared<connection_orbit>(map_, question_.unknowns, question_.limits, x);
        result.time = orbit ? as_double(orbit->joining_time()) : map_.direction() * map_.time;
        const std::string names = joined(question_.unknowns);
        const std::string which = names.empty() ? ""
                                  : question_.unknowns.size() == 1
                                      ? "exactly one " + names + " near this value for which "
                                      : "exactly one set " + names + " near these values for which ";
        result.proved = which + "the solution" + (map_.has_two_ends() ? " from the unstable manifold at -inf" : "") +
                        " is on the " + std::to_string(map_.right().variables()) + "-dimensional " +
                        (map_.is_fast() ? "strong " : "") + "stable manifold at t = " + text_of(result.time) +
                        ", from where it tends to the limits exponentially";
        result.not_claimed = names.empty() ? "that there is no other orbit with these limits"
                                           : "that there are no other values of " + names +
                                                 ", or that solutions that tend to the limits in another way are "
                                                 "excluded";
        add_numbers(result, roots, x);
        if (orbit) {
            add_orbit(result, *orbit);
        }
        result.orbit = orbit;
        return result;
    }

    void add_numbers(connection& result, const std::vector<known_value>& roots, const std::vector<ball>& x) const {
        const auto names = map_.names(question_.unknowns);
        for (std::size_t i = map_.numbers(); i < map_.numbers() + map_.coordinates(); ++i) {
            if (roots[i].decimal) {
                result.more.push_back({names[i], *roots[i].decimal, "limit"});
            }
        }
        const auto decay = map_.right().decay_at(map_.numbers_of_right(x));
        if (!decay) {
            return;
        }
        std::vector<std::size_t> order(decay->rates.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t j) { return -as_double(decay->rates[j].re); });
        for (std::size_t k = 0; k < order.size(); ++k) {
            add_number(result, "rate", "rate " + std::to_string(k + 1), -decay->rates[order[k]].re);
        }
    }

    void add_orbit(connection& result, const connection_orbit& orbit) const {
        for (const auto& [name, value] : orbit.rates_at_start()) {
            add_number(result, "rate", name, value);
        }
        for (const auto& [name, value] : orbit.amplitudes()) {
            add_number(result, "amplitude", name, value);
        }
        if (const auto angle = orbit.angle(bits_of_first_run(question_.digits))) {
            add_number(result, "angle", "angle of intersection", *angle);
        }
        result.phase = orbit.phase();
    }

    void add_number(connection& result, const std::string& kind, const std::string& name, const ball& value) const {
        const long digits = proved_digits(value, question_.digits);
        if (digits >= least_digits_beside && !contains_zero(value)) {
            result.more.push_back({name, *to_proved_decimal(value, digits), kind});
        }
    }

    static std::string text_of(double time) {
        const precision_scope scope(decimal_digits(bits_of_first_iterate));
        return to_decimal(mpfr(time), 6);
    }

    static std::string joined(const std::vector<std::string>& names) {
        std::string all;
        for (const std::string& each : names) {
            all += (all.empty() ? "" : ", ") + each;
        }
        return all;
    }

    const connection_question& question_;
    connection_map map_;
};

// With the unknowns of a finer proof, since other numbers that follow from them lose digits.
connection proved_orbit(const connection_question& question, const proof_route& route, const march_watch& watch) {
    connection_question finer = question;
    finer.digits += digits_of_numbers;
    connection result = connection_search(finer, {}, false, route, watch).result();
    const precision_scope scope(finer.digits + digits_beside);
    const auto shorten = [&](proved_decimal& each) {
        const ball value = enclosed(each);
        if (const auto shorter =
                to_proved_decimal(value, std::min(question.digits, proved_digits(value, finer.digits)))) {
            each = *shorter;
        }
    };
    std::ranges::for_each(result.values, shorten);
    std::ranges::for_each(result.more, shorten, &connection_number::value);
    return result;
}

// By the half of the orbit that ends at inf.
connection proved_symmetric(const connection_question& question, const orbit_symmetry& symmetry,
                            const proof_route& route, const march_watch& watch) {
    connection_question half = question;
    std::erase_if(half.limits, [](const limit_condition& each) { return each.direction < 0; });
    half.system = with_idle_starts(half.system);
    connection result = proved_connection(half, route, watch);
    const std::string reversal = symmetry.text();
    result.proved += ", and, since " + reversal + ", to those at -inf";
    result.phase = reversal + ", which fixes t = " + text_of_time(symmetry.point);
    if (result.orbit) {
        auto whole = std::make_shared<connection_orbit>(*result.orbit);
        whole->reflect(symmetry);
        result.orbit = std::move(whole);
    }
    return result;
}

}  // namespace

connection searched_decay(const connection_question& question, const start_rule& begins, const proof_route& route,
                          const march_watch& watch) {
    return connection_search(question, begins, true, route, watch).result();
}

connection proved_connection(const connection_question& question, const proof_route& route, const march_watch& watch) {
    if (has_amplitude(question)) {
        return proved_by_amplitude(question, route, watch);
    }
    if (const auto symmetry = symmetry_of(question)) {
        return proved_symmetric(question, *symmetry, route, watch);
    }
    if (is_layer(question)) {
        return proved_layer(question, route, watch);
    }
    if (is_carried(question)) {
        return proved_carried(question, route, watch);
    }
    if (is_power_decay(question)) {
        return proved_power_decay(question, route, watch);
    }
    if (is_radial(question)) {
        return proved_radial(question, route, watch);
    }
    return is_linear_decay(question) ? proved_linear_decay(question, watch) : proved_orbit(question, route, watch);
}

}  // namespace libration::ode
