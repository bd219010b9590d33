#include "well_equation.hpp"

#include <algorithm>
#include <optional>

#include "libration/equation/identities.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

[[noreturn]] void refuse_term(const std::string& term, const std::string& reason) {
    throw error(error_kind::undecided, error_subject::problem, "", "has " + term + " " + reason);
}

// An expression in the variable as a rational function of s.
class potential_reader {
public:
    potential_reader(const expression& e, const std::string& variable) : variable_(variable) { find_rate(e); }

    bool is_exponential() const { return rate_ > 0; }
    const rational& rate() const { return rate_; }

    rational_function read(const expression& e) const {
        switch (e.kind()) {
            case node_kind::constant: {
                const auto value = e.fraction();
                if (!value) {
                    refuse_term("a number", "that is not a fraction in the potential: write it as a fraction");
                }
                return {*value};
            }
            case node_kind::variable:
                if (is_exponential()) {
                    refuse_term(
                        "the variable " + variable_,
                        "in the potential together with exponential functions of it: only polynomials, rational "
                        "functions, and rational functions of exp(k*" +
                            variable_ + ") are supported");
                }
                return rational_function::variable();
            case node_kind::sum: return read(e.left()) + read(e.right());
            case node_kind::product: return read(e.left()) * read(e.right());
            case node_kind::quotient: return read(e.left()) / read(e.right());
            case node_kind::power: return read_power(e);
            case node_kind::function: return read_function(e);
            case node_kind::unknown:
            case node_kind::parameter: break;
        }
        refuse_term("'" + e.name() + "'", "in the potential: give it a number");
    }

private:
    // k of k x; throws error for other arguments.
    rational factor_in(const expression& argument) const {
        const expression slope = partial(argument, variable());
        const auto factor = slope.fraction();
        if (!factor || !is_identically_zero(argument - slope * variable())) {
            refuse_term("a function", "of another argument than k*" + variable_ +
                                          " with a fraction k in the potential, which is not supported");
        }
        return *factor;
    }
    static bool is_exponential_function(function_kind kind) {
        return kind == function_kind::exp || kind == function_kind::sinh || kind == function_kind::cosh ||
               kind == function_kind::tanh;
    }
    // The largest r of which all k are multiples.
    void find_rate(const expression& e) {
        switch (e.kind()) {
            case node_kind::sum:
            case node_kind::product:
            case node_kind::quotient:
            case node_kind::power:
                find_rate(e.left());
                find_rate(e.right());
                return;
            case node_kind::function:
                if (is_exponential_function(e.function())) {
                    const rational k = abs(factor_in(e.left()));
                    const integer below = lcm(denominator(k), denominator(rate_));
                    rate_ = rational(gcd(integer(numerator(k) * (below / denominator(k))),
                                         integer(numerator(rate_) * (below / denominator(rate_)))),
                                     below);
                }
                return;
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter: return;
        }
    }
    rational_function read_power(const expression& e) const {
        const auto exponent = e.right().fraction();
        constexpr long most = 200;
        if (!exponent || denominator(*exponent) != 1 || abs(*exponent) > most) {
            refuse_term("a power", "in the potential whose exponent is not an integer up to 200");
        }
        return power(read(e.left()), static_cast<long>(numerator(*exponent)));
    }
    rational_function read_function(const expression& e) const {
        if (!is_exponential_function(e.function())) {
            refuse_term("a function",
                        "other than exp, sinh, cosh, tanh, sech, csch and coth in the potential, and no proof supports "
                        "it");
        }
        const rational steps = factor_in(e.left()) / rate_;
        const rational_function up = power(rational_function::variable(), static_cast<long>(numerator(steps)));
        const rational_function down = rational_function(1) / up;
        const rational half(1, 2);
        const rational_function sinh = rational_function(half) * (up + rational_function(-1) * down);
        const rational_function cosh = rational_function(half) * (up + down);
        return e.function() == function_kind::exp    ? up
               : e.function() == function_kind::sinh ? sinh
               : e.function() == function_kind::cosh ? cosh
                                                     : sinh / cosh;
    }

    std::string variable_;
    rational rate_ = 0;
};

// A psi'' + B psi' + C psi.
struct linear_form {
    std::string unknown;
    expression second, first, zeroth;
};

std::optional<linear_form> linear_form_of(const equation_system& system, const std::string& energy) {
    const auto unknowns = system.unknowns();
    if (!system.is_ordinary() || unknowns.size() != 1 || system.equations.size() != 1 ||
        system.order_of(unknowns.front()) != 2) {
        return std::nullopt;
    }
    const equation& written = system.equations.front();
    std::map<std::string, expression> open;
    if (!energy.empty()) {
        open.emplace(energy, parameter(energy));
    }
    const expression e = parameter_values(system, open).in(written.left - written.right);
    linear_form form{unknowns.front(), {}, {}, {}};
    const auto part = [&](int derivative) { return partial(e, unknown(form.unknown, derivative)); };
    form.second = part(2);
    form.first = part(1);
    form.zeroth = part(0);
    const bool linear = !form.second.has_unknowns() && !form.first.has_unknowns() && !form.zeroth.has_unknowns();
    const auto of = [&](int derivative) { return unknown(form.unknown, derivative); };
    return linear && is_identically_zero(e - form.second * of(2) - form.first * of(1) - form.zeroth * of(0))
               ? std::optional(form)
               : std::nullopt;
}

}  // namespace

well_equation well_equation::reflected() const {
    well_equation result = *this;
    result.potential = exponential ? potential.of_inverse() : potential.of_negative();
    return result;
}

damped_equation damped_equation::reflected() const {
    damped_equation result = *this;
    result.damping = rational_function(-1) * (exponential ? damping.of_inverse() : damping.of_negative());
    result.restoring = exponential ? restoring.of_inverse() : restoring.of_negative();
    return result;
}

damped_equation damped_equation::shifted(const rational& c) const {
    damped_equation result = *this;
    result.damping = damping.of_sum(c);
    result.restoring = restoring.of_sum(c);
    return result;
}

well_equation damped_equation::without_damping() const {
    const rational_function by_s =
        exponential ? rational_function(rate) * rational_function::variable() : rational_function(1);
    well_equation result;
    result.unknown = unknown;
    result.potential = restoring + rational_function(rational(1, 4)) * damping * damping +
                       rational_function(rational(1, 2)) * by_s * damping.derivative();
    result.exponential = exponential;
    result.rate = rate;
    return result;
}

bool well_equation::is_even() const { return mirrored || reflected().potential == potential; }

bool is_linear_in_time(const equation_system& system) {
    try {
        return linear_form_of(system, "").has_value() &&
               std::ranges::any_of(system.equations, [](const equation& each) {
                   return each.left.has_variable() || each.right.has_variable();
               });
    } catch (const error&) {
        return false;  // reported where the problem is solved
    }
}

namespace {

// The equations for x of one sign. Throws error for step functions of anything but a multiple of x.
equation_system on_one_side(equation_system system, int sign) {
    for (const step_function& each : system.steps) {
        const expression slope = partial(each.argument, variable());
        const auto factor = slope.fraction();
        if (each.kind != step_kind::sign || !factor || *factor == 0 ||
            !is_identically_zero(each.argument - slope * variable())) {
            refuse_term("'" + each.text + "'", "in the potential, of which only abs(" + system.variable +
                                                   ") and other functions of the sign of " + system.variable +
                                                   " are supported");
        }
        for (const definition& value : parameters_of(each, number(rational(*factor > 0 ? sign : -sign)))) {
            system.parameters.push_back(value);
        }
    }
    system.steps.clear();
    return system;
}

}  // namespace

well_equation read_well(const equation_system& system, const std::string& energy) {
    if (!system.steps.empty()) {
        well_equation right = read_well(on_one_side(system, 1), energy);
        if (!(right.reflected().potential == read_well(on_one_side(system, -1), energy).potential)) {
            throw error(error_kind::undecided, error_subject::problem, "",
                        "has a potential with " + system.steps.front().text +
                            " that is not even, and only V(-x) = V(x) is supported with it");
        }
        right.mirrored = true;
        return right;
    }
    const auto form = linear_form_of(system, energy);
    if (!form) {
        throw error(
            error_kind::argument, error_subject::problem, "",
            "is not one linear equation of order 2, without a further term: write psi'' = (V - " + energy + ")*psi");
    }
    if (!is_identically_zero(form->first)) {
        refuse_term("the term of " + primed(form->unknown, 1),
                    "and only psi'' = (V - " + energy + ")*psi without it is supported");
    }
    const expression spectral = parameter(energy);
    const expression slope = partial(form->zeroth, spectral);
    if (slope.has_parameters() || form->second.has_parameters()) {
        refuse_term("'" + energy + "'", "in another term than a constant times " + energy + "*" + form->unknown);
    }
    const expression at_zero = replaced(form->zeroth, [&](const expression& leaf) {
        return same_form(leaf, spectral) ? std::optional<expression>(0) : std::nullopt;
    });
    const potential_reader reader(form->second + at_zero + slope, system.variable);
    well_equation result;
    result.unknown = form->unknown;
    result.exponential = reader.is_exponential();
    result.rate = result.exponential ? reader.rate() : rational(1);
    const rational_function second = reader.read(form->second);
    if (second.above().is_zero()) {
        throw error(error_kind::argument, error_subject::problem, "", "has no second derivative: write psi'' = ..");
    }
    result.potential = rational_function(-1) * reader.read(at_zero) / second;
    const rational_function weight = reader.read(slope) / second;
    if (!weight.is_polynomial() || weight.above().degree() != 0 || !(weight.above()[0] > 0)) {
        refuse_term("'" + energy + "'", "with another factor than a negative number in " + form->unknown +
                                            "'' = (V - c*" + energy + ")*" + form->unknown + ", c > 0");
    }
    result.weight = weight.above()[0];
    return result;
}

damped_equation read_damped(const equation_system& system) {
    const auto form = linear_form_of(system, "");
    if (!form) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "is not one linear equation of order 2, without a further term: write y'' + p*y' = q*y");
    }
    const potential_reader reader(form->second + form->first + form->zeroth, system.variable);
    damped_equation result;
    result.unknown = form->unknown;
    result.exponential = reader.is_exponential();
    result.rate = result.exponential ? reader.rate() : rational(1);
    const rational_function second = reader.read(form->second);
    result.damping = reader.read(form->first) / second;
    result.restoring = rational_function(-1) * reader.read(form->zeroth) / second;
    return result;
}

}  // namespace libration::ode
