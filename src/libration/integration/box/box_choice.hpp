// Theorem G or theorem V: which costs less, as far as predicted. No proof depends on it.
#pragma once

#include <cstddef>

namespace libration::ode {

/// From so many unknowns on, with their lower derivatives, the steps of a proof begin with theorem G.
inline constexpr std::size_t least_unknowns_of_box = 20;
/// From so many on, theorem V is not considered: its set-up takes longer than the integration by theorem G.
inline constexpr std::size_t most_unknowns_with_columns = 120;

/// The growth of the radii of theorem G so far, and the cost that follows from it.
class box_choice {
public:
    /// For so many unknowns, and so many products of series per step.
    box_choice(std::size_t unknowns, std::size_t products) : unknowns_(unknowns), products_(products) {}

    void begin() {
        steps_ = 0;
        growth_ = way_ = 0;
    }
    /// A step over this distance, in which the radii grew by 2^growth, with the relative accuracy, in bits, at its
    /// beginning.
    void add(double growth, double distance, double accuracy);
    /// Whether the rest of the way costs less by theorem V: (1 + n) series systems with the bits that are left, and n^3
    /// operations for its error set, instead of one system with these and as many more as the radii will have grown.
    /// Infinite: as far as up to now; otherwise up to 16 times as far. Only after some steps, and if the costs differ
    /// clearly.
    bool prefers_columns(double rest) const;

private:
    std::size_t unknowns_, products_;
    long steps_ = 0;
    double growth_ = 0, way_ = 0, accuracy_ = 0;
};

}  // namespace libration::ode
