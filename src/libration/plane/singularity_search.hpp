// The double-precision search of singularity_map: points, cells, loops.
#pragma once

#include <complex>
#include <optional>
#include <queue>
#include <vector>

#include "libration/integration/plane_watch.hpp"
#include "libration/plane/local_series.hpp"

namespace libration::ode {

using plane_point = std::complex<double>;

inline complex_number<double> as_number(const plane_point& z) { return {z.real(), z.imag()}; }
inline plane_point as_point(const complex_number<double>& z) { return {z.re, z.im}; }

/// Indices of unknowns and lower derivatives that are usually singular at the same points: those of a strongly
/// connected component.
using leaf_group = std::vector<std::size_t>;

/// A singularity in double precision, in the sector of the symmetry that was searched.
struct candidate {
    plane_point at;
    /// The radius of the loop around it.
    double reach = 0;
    /// Whether all unknowns, and whether those of its group, are unchanged after the loop.
    bool single_valued = true;
    bool group_single_valued = true;
    std::vector<plane_point> path;
    /// The group whose coefficients indicate it.
    std::size_t group = 0;
};

/// Searches for the singularities of all unknowns of a system. Each group has separate candidates, found from its own
/// coefficients: a group that is regular at a singularity of another one has none there.
class singularity_search {
public:
    singularity_search(const path_system& of, std::vector<leaf_group> groups, int rotation, long most_points,
                       const plane_watch& watch);

    /// Processes every cell of smaller modulus until it is resolved or abandoned.
    void search(double within);

    const std::vector<candidate>& found() const { return found_; }
    long points() const { return static_cast<long>(points_.size()); }
    long unexplained() const { return unexplained_; }
    /// The value of a leaf at any offset in the plane, by the reflection and the point whose disc contains it best.
    std::optional<plane_point> value_at(const plane_point& offset, std::size_t leaf) const;
    double first_radius() const { return points_.front().radius; }

private:
    using complex = complex_number<double>;

    static constexpr int search_order = 44;
    // Fractions of a radius: up to which values are used, and up to which the series is taken to converge.
    static constexpr double search_step = 0.5;
    static constexpr double believed_part = 0.8;

    struct point {
        plane_point at;
        double radius;
        std::vector<std::vector<complex>> coefficients;  // of the carried unknowns
        int parent;
    };
    struct cell {
        double r1, r2, a1, a2;
        bool operator<(const cell& other) const { return r1 > other.r1; }
    };

    bool add_point(const plane_point& at);
    int best_parent(const plane_point& at) const;
    void expand(const plane_point& at, const std::vector<complex>& values, int parent);
    // Adds the point of the current series.
    void add_expanded(const plane_point& at, int parent);
    bool crosses_cut(const plane_point& from, const plane_point& to) const;
    bool is_explained(const cell& of) const;
    static std::vector<complex> values_at(const point& of, const plane_point& at);
    std::vector<plane_point> path_to(int index) const;
    plane_point folded(plane_point z, bool& mirrored, int& turns) const;

    // singularity_approach.cpp
    void look_at_last();
    bool look_at(std::size_t group);
    void return_to(const point& of);
    void approach(const plane_point& guess, std::size_t group);
    void keep(candidate made, plane_point place);
    bool is_one_pole(const candidate& loop, const plane_point& place) const;
    plane_point polished(plane_point centre, std::size_t group);
    plane_point on_axis(const plane_point& z, double reach) const;
    std::optional<candidate> loop_round(const plane_point& centre, std::size_t group);
    bool is_changed(const point& before, const point& after, const leaf_group& of) const;

    struct refusal {
        plane_point at;
        std::size_t group;
    };

    const path_system& of_;
    const plane_watch& watch_;
    std::vector<leaf_group> groups_;
    leaf_group carried_;  // all carried unknowns
    int rotation_;
    long most_points_;
    local_series<double> series_;
    std::vector<point> points_;
    std::vector<candidate> found_;
    std::vector<refusal> refused_;
    long unexplained_ = 0;
    double within_ = 0;
};

}  // namespace libration::ode
