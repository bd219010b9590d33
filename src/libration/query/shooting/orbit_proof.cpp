#include "orbit_proof.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "../../equation/linear_invariance.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "multipliers.hpp"

namespace libration::ode {

namespace {

constexpr int most_runs_of_rest = 4;
constexpr long least_digits_of_proof = 15;
constexpr long more_digits_for_multipliers = 25;

ball ball_of(const proved_decimal& x) {
    const ball middle = constant_value<ball>::of(parse_constant(x.text).constant());
    const ball radius = constant_value<ball>::of(parse_constant(x.uncertainty).constant());
    return widened(middle, magnitude(radius));
}

std::vector<ball> middles_of(const std::vector<ball>& root) {
    std::vector<ball> middles;
    std::ranges::transform(root, std::back_inserter(middles), exact_midpoint);
    return middles;
}

}  // namespace

long orbit_proof::digits_of_root(bool in_family) const {
    return std::max(question_.digits, in_family ? least_digits_of_proof : 0) +
           (question_.multipliers ? more_digits_for_multipliers : 0);
}

// The unknowns of a map, proved with so many digits: at most one unit of the last one from the decimals.
std::vector<ball> orbit_proof::root_of(const orbit_map& map, const std::vector<ball>& guess, long digits,
                                       long settled_bits, std::vector<proved_decimal>& decimals) const {
    std::vector<std::string> names;
    for (const std::size_t i : map.conditions().free) {
        names.push_back(form_.names[i]);
    }
    if (map.conditions().is_period_free) {
        names.emplace_back("period");
    }
    decimals.clear();
    if (!names.empty()) {
        const auto values = proved_part_of_root(
            [&](const std::vector<ball>& x, long bits, long error_bits) { return map(x, bits, error_bits); }, guess,
            digits, names, settled_bits);
        for (const known_value& each : values) {
            decimals.push_back(each.decimal ? *each.decimal : proved_decimal{"0", each.bound});
        }
    }
    const precision_scope scope(digits + 20);
    std::vector<ball> root;
    for (const proved_decimal& each : decimals) {
        root.push_back(ball_of(each));
    }
    return root;
}

periodic_orbit orbit_proof::orbit(const orbit_map& map, const std::vector<ball>& guess, long settled_bits) const {
    const long digits = digits_of_root(!map.conditions().dropped.empty() || !map.conditions().reversal.empty());
    std::vector<proved_decimal> decimals;
    const std::vector<ball> root = root_of(map, guess, digits, settled_bits, decimals);
    periodic_orbit orbit{form_.names, {}, {}};
    {
        const precision_scope scope(digits + 20);
        const auto decimal = [&](std::size_t k) { return digits == question_.digits ? decimals[k] : printed(root[k]); };
        std::size_t k = 0;
        for (std::size_t i = 0; i < form_.starts.size(); ++i) {
            const bool is_free = std::ranges::find(map.conditions().free, i) != map.conditions().free.end();
            orbit.start.push_back(is_free ? decimal(k++) : printed(constant_value<ball>::of(form_.starts[i])));
        }
        orbit.period = map.conditions().is_period_free ? decimal(k) : printed(map.period_at({}));
    }
    prove_rest(map, root, digits, orbit);
    return orbit;
}

proved_decimal orbit_proof::printed(const ball& x) const {
    if (auto decimal = to_proved_decimal(x, question_.digits)) {
        return *std::move(decimal);
    }
    if (contains_zero(x) && certainly_less(abs(x), pow(ball(10), -question_.digits))) {
        return {"0", bound_text(x)};
    }
    throw error(error_kind::undecided, error_subject::solution, "",
                "has a value of which " + std::to_string(question_.digits) +
                    " digits are not decided: choose another number of digits");
}

// The conditions that are left out, the shortest period and the multipliers, with more digits if they need them.
void orbit_proof::prove_rest(const orbit_map& map, std::vector<ball> root, long digits, periodic_orbit& orbit) const {
    bool follow = map.conditions().dropped.empty();
    for (int run = 0; run < most_runs_of_rest; ++run, digits = digits * 3 / 2 + 10) {
        if (run > 0) {
            std::vector<proved_decimal> finer;
            root = root_of(map, middles_of(root), digits, 0, finer);
        }
        const long bits = bits_of_first_run(digits);
        const precision_scope scope(decimal_digits(bits));
        if (!follow) {
            const auto end = map.end_at(root, bits, run_bits::usual_error_bits);
            follow = end && map.all_conditions_follow(*end);
        }
        orbit.is_shortest_period = run > 0 ? orbit.is_shortest_period : map.is_shortest_period(root, bits);
        if (follow && (!question_.multipliers || add_multipliers(map, root, bits, orbit))) {
            return;
        }
    }
    if (!follow) {
        throw error(error_kind::undecided, error_subject::solution, "",
                    "is not proved to be periodic: the conditions that integrals replace do not follow from the "
                    "others: choose initial values nearer to a periodic orbit");
    }
    if (question_.multipliers && orbit.multipliers.empty()) {
        throw error(error_kind::undecided, error_subject::solution, "",
                    "has multipliers that are not enclosed with " + std::to_string(digits) +
                        " digits: leave the multipliers out");
    }
}

bool orbit_proof::add_multipliers(const orbit_map& map, const std::vector<ball>& root, long bits,
                                  periodic_orbit& orbit) const {
    const auto end = map.end_of_period(root, bits, bits);
    if (!end) {
        return false;
    }
    const auto known = known_directions(form_, integrals_).at(end->start);
    auto others = other_multipliers(end->flow, known);
    if (!others) {
        return false;
    }
    std::ranges::stable_sort(others->values, [](const auto& a, const auto& b) {
        return as_double(a.re * a.re + a.im * a.im) > as_double(b.re * b.re + b.im * b.im);
    });
    std::vector<floquet_multiplier> found;
    for (const std::string& each : known.names) {
        found.push_back({{proved_decimal{"1", "0"}, ""}, {proved_decimal{"0", "0"}, ""}, each, true});
    }
    for (const auto& each : others->values) {
        floquet_multiplier multiplier;
        multiplier.is_real = is_exact(each.im) && contains_zero(each.im);
        improve(multiplier.real, each.re, question_.digits);
        if (multiplier.is_real) {
            multiplier.imaginary.decimal = proved_decimal{"0", "0"};
        } else {
            improve(multiplier.imaginary, each.im, question_.digits);
        }
        found.push_back(multiplier);
    }
    orbit.multipliers = std::move(found);
    orbit.stability = stability_of(*others, known.names.size(), is_symplectic(form_));
    const magnitude unit(pow(ball(10), -question_.digits));
    const auto is_known = [&](const known_value& value, const ball& x) { return value.decimal || magnitude(x) < unit; };
    for (std::size_t k = 0; k < others->values.size(); ++k) {
        const auto& each = orbit.multipliers[known.names.size() + k];
        if (!is_known(each.real, others->values[k].re) || !is_known(each.imaginary, others->values[k].im)) {
            return false;
        }
    }
    return others->isolated;
}

}  // namespace libration::ode
