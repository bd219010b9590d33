// All summations of a list at several points, from shorter and shorter lists.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libration/approximant/borel.hpp"
#include "libration/approximant/differential.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::convergence {

/// What kind of method a summation is; methods of one kind fail together. An equation is a differential approximant that
/// the whole list satisfies.
enum class sum_kind {
    partial_sum,
    pade,
    differential,
    equation,
    euler,
    cut,
    borel_pade,
    borel_differential,
    borel_equation,
    borel_cut
};

std::string name_of(sum_kind kind);

/// The singularities that a sum uses, in the unit of the list.
struct sum_shape {
    std::optional<mpfr> inside;       ///< below this modulus partial sums are used; infinite for an entire function
    std::optional<mpfr> real;         ///< the nearest singularity if that is real
    std::optional<rational> gevrey;   ///< s > 0 of a list of radius zero
    std::optional<mpfr> real_action;  ///< the nearest singularity of its Borel transform if that is real
};

/// A value and the estimated error of its computation: of a quadrature, else 0.
struct computed_sum {
    mpfr value, error;
};

/// The values of one method at all points.
struct summation {
    sum_kind kind;
    int variant;  ///< among those of its kind
    std::vector<std::optional<computed_sum>> values = {};

    void add(const std::optional<mpfr>& value) {
        values.push_back(value ? std::optional(computed_sum{*value, mpfr(0)}) : std::nullopt);
    }

    bool is_same_method(const summation& other) const { return kind == other.kind && variant == other.variant; }
};

/// The methods for a list with this shape at points of any sign, sorted by modulus.
class summations {
public:
    summations(std::vector<mpfr> a, sum_shape shape, std::vector<mpfr> points, const task_runner& run);

    /// All methods from a_0 .. a_last, in the working precision.
    std::vector<summation> of_length(int last) const;

private:
    struct borel_list {
        laplace_rule rule;
        mpfr unit;                    ///< of the variable of the transform
        std::vector<mpfr> transform;  ///< in that unit
        std::vector<mpfr> in_cut;     ///< in the variable of the cut map; empty without a real action
    };

    std::span<const mpfr> first(const std::vector<mpfr>& list, int last) const {
        return std::span(list).first(static_cast<std::size_t>(last) + 1);
    }
    void add_partial_sums(int last, std::vector<summation>& all) const;
    void add_pade(int last, std::vector<summation>& all) const;
    void add_maps(int last, std::vector<summation>& all) const;
    template <class SumBy>
    void add_equations(const std::vector<mpfr>& a, int last, int variant, std::vector<summation>& all,
                       const SumBy& sum_by) const;
    void add_differential(int last, std::vector<summation>& all) const;
    void add_borel(int last, std::vector<summation>& all) const;
    void add_borel_differential(const borel_list& list, int variant, int last, std::vector<summation>& all) const;
    void add_borel_pade(const borel_list& list, int variant, int last, std::vector<summation>& all) const;
    void add_borel_cut(const borel_list& list, int variant, int last, std::vector<summation>& all) const;

    std::vector<mpfr> a_;
    sum_shape shape_;
    std::vector<mpfr> points_;
    const task_runner& run_;
    std::vector<mpfr> in_euler_, in_cut_;
    std::vector<borel_list> borel_;
};

}  // namespace libration::convergence
