// The right-hand sides of a system as a scalar-independent list of elementary operations, which taylor_expansion
// executes.
#pragma once

#include <bit>
#include <optional>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The operation of a step of a tape, coefficient by coefficient; a and b are its operands.
enum class operation {
    constant,     ///< one of the constants of the tape
    variable,     ///< t = t0 + s; on a singular tape s itself, a power of the series' variable
    state,        ///< an unknown or one of its lower derivatives
    sum,          ///< a + b
    difference,   ///< a - b
    scaled,       ///< a constant times a, or a numerator / denominator
    raised,       ///< a plus a constant
    by_variable,  ///< t a
    delayed,      ///< a multiplied by the power `shift` of the series' variable
    product,      ///< a b
    square,       ///< a^2
    quotient,     ///< a / b
    slope,        ///< the derivative of a by the series' variable, one degree behind
    square_root,  ///< sqrt a
    power,        ///< a^r, r a constant, b the slope of a
    function,     ///< f(a) by a separate recurrence (function/NAME.hpp), b the slope of a
    primitive,    ///< f(a) as the primitive of its derivative, a later step, times b, the slope of a
    companion     ///< filled by an earlier step
};

/// The kernels that an operation needs.
enum class operation_group {
    linear,        ///< one field operation per coefficient
    convolution,   ///< sums of products of coefficients, or the slope
    function,      ///< a function whose value at the expansion point is computed separately
    odd_function,  ///< a function that is computed together with an even one
    none           ///< filled by an earlier step
};

constexpr operation_group group_of(operation kind) {
    switch (kind) {
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::sum:
        case operation::difference:
        case operation::scaled:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed: return operation_group::linear;
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::slope: return operation_group::convolution;
        case operation::square_root:
        case operation::power:
        case operation::function:
        case operation::primitive: return operation_group::function;
        case operation::companion: break;
    }
    return operation_group::none;
}

constexpr bool is_linear(operation kind) { return group_of(kind) == operation_group::linear; }
constexpr bool is_function(operation kind) { return group_of(kind) == operation_group::function; }

/// One operation; operands are indices of steps.
struct tape_step {
    operation kind = operation::constant;
    int left = -1;
    int right = -1;
    int constant = -1;  ///< index of a constant: a factor, an exponent or the order of a function
    int numerator = 1;  ///< of scaled without a constant
    int denominator = 1;
    int shift = 0;
    function_kind function = function_kind::exp;  ///< of functions, companions and square roots
    int derivative = -1;                          ///< of a primitive: the step of f'(a), which is after this one
    bool odd = false;                             ///< whether an odd function is computed together with an even one
    /// At step n of the recurrence coefficient n - lag is computed.
    int lag = 0;
    /// Whether that coefficient depends on the newest coefficients of the unknowns.
    bool newest = false;
    /// Coefficients may be nonzero only for degrees = residue modulo the stride of the tape.
    int residue = 0;
    /// The value at the initial point if it is known exactly.
    std::optional<number> centre = {};

    /// Of scaled: whether a product with one number in binary rounds like that with the numerator and the division.
    bool has_one_factor() const {
        return constant >= 0 || denominator == 1 ||
               ((numerator == 1 || numerator == -1) && std::has_single_bit(static_cast<unsigned>(denominator)));
    }
};

/// The step of a derivative of an unknown on the tape.
struct tape_state {
    int unknown = 0;
    int derivative = 0;
    int step = 0;
};

/// The steps in an order in which operands come first; common subexpressions and constants occur once, products of
/// constants are folded exactly, integer and half-integer powers are products and roots.
class tape {
public:
    /// For expansions about any point where the right-hand sides have values, including a nonsingular initial point.
    /// Expressions in the variable, the unknowns and their lower derivatives may be computed in addition (watched()).
    static tape about_points(const explicit_system& of, const std::vector<expression>& watched = {});
    /// For the expansion about the initial point. A symmetry of the initial values under t -> t exp(2 pi i/p), found
    /// from their exact zeros, leaves only every p-th coefficient (stride). At a singular initial point s^q y^(q)
    /// replaces y^(q). Throws error if the equation has no power series there or does not determine it.
    static tape about_start(const explicit_system& of);

    const std::vector<tape_step>& steps() const { return steps_; }
    const std::vector<number>& constants() const { return constants_; }
    const std::vector<tape_state>& states() const { return states_; }
    /// The step of the highest derivative of each unknown.
    const std::vector<int>& outputs() const { return outputs_; }
    /// The steps of the observed expressions.
    const std::vector<int>& watched() const { return watched_; }
    /// The orders of the unknowns.
    const std::vector<int>& orders() const { return orders_; }
    /// The modulus of the residues of the unknowns, and the residue of an unknown.
    int stride() const { return stride_; }
    int residue_of(int unknown) const { return residues_[static_cast<std::size_t>(unknown)]; }
    /// t0 and the initial values of explicit_system.
    const number& point() const { return point_; }
    const std::vector<std::vector<number>>& starts() const { return starts_; }
    /// Whether s^q y^(q) replaces y^(q).
    bool is_singular() const { return singular_; }
    /// Series are in powers of s^(1/root).
    int root() const { return root_; }
    /// weights()[i][k][l] as in scaled_right_side.
    const std::vector<std::vector<std::vector<number>>>& weights() const { return weights_; }

private:
    friend class tape_builder;

    std::vector<tape_step> steps_;
    std::vector<number> constants_;
    std::vector<tape_state> states_;
    std::vector<int> outputs_;
    std::vector<int> watched_;
    std::vector<int> orders_;
    std::vector<int> residues_;
    int stride_ = 1;
    number point_;
    std::vector<std::vector<number>> starts_;
    bool singular_ = false;
    int root_ = 1;
    std::vector<std::vector<std::vector<number>>> weights_;
};

}  // namespace libration::ode
