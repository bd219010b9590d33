// Dependencies between the unknowns of a system, and the independent systems that it consists of.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The graph of a system with an edge from unknown i to each unknown j that occurs, itself or through a derivative, in
/// the right-hand side of y_i^(q_i). Indices are those of explicit_system::unknowns(). Occurrence is read from the
/// solved form: an edge may be superfluous if an unknown cancels, but no edge is missing. Cost: linear in the size of
/// the right-hand sides.
class dependency_graph {
public:
    explicit dependency_graph(const explicit_system& of);

    std::size_t size() const { return direct_.size(); }
    /// The unknowns in the right-hand side of unknown i, ascending.
    const std::vector<std::size_t>& direct(std::size_t i) const { return direct_[i]; }
    /// The strongly connected components [Tarjan1972], each ascending, ordered so that the components that a component
    /// depends on precede it.
    const std::vector<std::vector<std::size_t>>& strong_components() const { return strong_; }
    /// The weakly connected components, each ascending, ordered by their first unknowns: no unknown of one influences
    /// an unknown of another one.
    const std::vector<std::vector<std::size_t>>& weak_components() const { return weak_; }
    /// The strongly connected component of unknown i.
    const std::vector<std::size_t>& component_of(std::size_t i) const;
    /// Unknown i and all unknowns that it depends on, directly or indirectly, ascending: their equations form a closed
    /// system.
    std::vector<std::size_t> closure(std::size_t i) const;

private:
    void find_weak_components();

    std::vector<std::vector<std::size_t>> direct_, strong_, weak_;
};

/// A system of some of the unknowns of another, and the indices of these in it.
struct closed_subsystem {
    explicit_system system;
    /// Unknown k of `system` is unknown unknowns[k] of the whole system,
    std::vector<std::size_t> unknowns;
    /// and leaf k (unknowns with their lower derivatives, in order) is leaf leaves[k] of the whole system.
    std::vector<std::size_t> leaves;
    /// Number of leaves of the whole system.
    std::size_t leaves_of_whole = 0;
};

/// The equations of a set of unknowns that contains with each unknown those that it depends on (closure, a weak
/// component, unions of such), with their initial values and with the invariants and closed forms in these unknowns
/// only; a singular initial point is analysed again, so that the root of its powers is that of these equations. For all
/// unknowns it is the system itself. A system without initial values (explicit_system::first_order) gives one without
/// initial values. Throws error for a set that is not closed.
closed_subsystem subsystem_of(const explicit_system& of, const std::vector<std::size_t>& unknowns);

/// The smallest such system that contains these unknowns. Throws error for a name that is not an unknown.
closed_subsystem subsystem_with(const explicit_system& of, const std::vector<std::string>& names);

/// The subsystems of the weakly connected components, in their order: only the system itself if it is connected.
std::vector<closed_subsystem> independent_subsystems(const explicit_system& of);

}  // namespace libration::ode
