// The right-hand sides of a polynomial form and their derivatives, for values in any ring.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/tape.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// f and f_y of y' = f(t, y), f polynomial, as one list of sums, products and multiples by constants.
class polynomial_map {
public:
    explicit polynomial_map(const polynomial_form& of);

    std::size_t size() const { return count_; }
    /// The number of given unknowns, the first ones; the others are functions of them.
    std::size_t given() const { return given_; }
    /// The rows and columns of the entries of f_y that are not identically 0.
    const std::vector<std::pair<std::size_t, std::size_t>>& places() const { return places_; }
    const std::vector<number>& constants() const { return tape_.constants(); }
    /// The same as balls of so many bits.
    std::vector<ball> enclosed_constants(long bits) const;

    template <class Value>
    struct result {
        std::vector<Value> slopes;   ///< f
        std::vector<Value> entries;  ///< of f_y, if requested
    };

    /// `Ring` has constant(k), variable(), sum, difference, product of two values and multiple(k, a), ratio(p, q, a),
    /// p/q times a.
    template <class Value, class Ring>
    result<Value> in(const Ring& ring, const std::vector<Value>& state, bool with_entries) const {
        std::vector<Value> done(tape_.steps().size());
        for (const tape_state& each : tape_.states()) {
            done[static_cast<std::size_t>(each.step)] = state[static_cast<std::size_t>(each.unknown)];
        }
        for (std::size_t k = 0; k < done.size(); ++k) {
            if ((with_entries || of_slopes_[k]) && tape_.steps()[k].kind != operation::state) {
                done[k] = computed<Value>(ring, tape_.steps()[k], done);
            }
        }
        result<Value> all;
        for (const int step : tape_.outputs()) {
            all.slopes.push_back(done[static_cast<std::size_t>(step)]);
        }
        for (std::size_t k = 0; with_entries && k < places_.size(); ++k) {
            all.entries.push_back(done[static_cast<std::size_t>(tape_.watched()[k])]);
        }
        return all;
    }

private:
    template <class Value, class Ring>
    static Value computed(const Ring& ring, const tape_step& step, const std::vector<Value>& done) {
        const auto left = [&]() -> const Value& { return done[static_cast<std::size_t>(step.left)]; };
        const auto right = [&]() -> const Value& { return done[static_cast<std::size_t>(step.right)]; };
        switch (step.kind) {
            case operation::constant: return ring.constant(step.constant);
            case operation::variable: return ring.variable();
            case operation::sum: return ring.sum(left(), right());
            case operation::difference: return ring.difference(left(), right());
            case operation::scaled:
                return step.constant >= 0 ? ring.multiple(step.constant, left())
                                          : ring.ratio(step.numerator, step.denominator, left());
            case operation::raised: return ring.sum(left(), ring.constant(step.constant));
            case operation::by_variable: return ring.product(ring.variable(), left());
            case operation::square: return ring.product(left(), left());
            case operation::product: return ring.product(left(), right());
            case operation::state:
            case operation::delayed:
            case operation::quotient:
            case operation::slope:
            case operation::square_root:
            case operation::power:
            case operation::function:
            case operation::primitive:
            case operation::companion: break;
        }
        throw std::logic_error("a polynomial form has an operation that is neither a product nor linear");
    }

    std::size_t count_, given_;
    std::vector<std::pair<std::size_t, std::size_t>> places_;
    tape tape_;
    std::vector<bool> of_slopes_;
};

/// The ring of numbers that have operators, with the constants and the variable in it.
template <class Value>
struct number_ring {
    const std::vector<Value>& constants;
    Value time;

    Value constant(int k) const { return constants[static_cast<std::size_t>(k)]; }
    Value variable() const { return time; }
    static Value sum(const Value& a, const Value& b) { return a + b; }
    static Value difference(const Value& a, const Value& b) { return a - b; }
    static Value product(const Value& a, const Value& b) { return a * b; }
    Value multiple(int k, const Value& a) const { return constants[static_cast<std::size_t>(k)] * a; }
    static Value ratio(int p, int q, const Value& a) { return a * p / q; }
};

/// Of a value a: a bound of |a| on a set, and of |a(y) - a(p)| there.
struct bounded_change {
    magnitude size, change;
};

/// The ring of such bounds: |ab - a'b'| <= |a'| |b - b'| + |b'| |a - a'| + |a - a'| |b - b'|.
struct change_ring {
    const std::vector<magnitude>& constants;
    magnitude time;

    bounded_change constant(int k) const { return {constants[static_cast<std::size_t>(k)], {}}; }
    bounded_change variable() const { return {time, {}}; }
    static bounded_change sum(const bounded_change& a, const bounded_change& b) {
        return {a.size + b.size, a.change + b.change};
    }
    static bounded_change difference(const bounded_change& a, const bounded_change& b) { return sum(a, b); }
    static bounded_change product(const bounded_change& a, const bounded_change& b) {
        return {a.size * b.size, a.size * b.change + b.size * a.change + a.change * b.change};
    }
    bounded_change multiple(int k, const bounded_change& a) const { return product(constant(k), a); }
    static bounded_change ratio(int p, int q, const bounded_change& a) {
        const magnitude above(static_cast<unsigned long>(p < 0 ? -static_cast<long>(p) : p));
        const auto below = static_cast<unsigned long>(q < 0 ? -static_cast<long>(q) : q);
        return {a.size * above / below, a.change * above / below};
    }
};

}  // namespace libration::ode
