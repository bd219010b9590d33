// Which unknowns of a system influence which others, and the independent systems that it consists of.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// The graph of a system with an edge from unknown i to each unknown j that occurs, itself or by a derivative, in the
/// right side of y_i^(q_i). Indices are those of explicit_system::unknowns(). Occurrence is read from the solved form: an
/// edge may be superfluous where an unknown cancels, none is missing. Cost: linear in the size of the right sides.
class dependency_graph {
public:
    explicit dependency_graph(const explicit_system& of);

    std::size_t size() const { return direct_.size(); }
    /// The unknowns in the right side of unknown i, ascending.
    const std::vector<std::size_t>& direct(std::size_t i) const { return direct_[i]; }
    /// The strongly connected components [Tarjan1972], each ascending, in an order in which those that a component
    /// depends on come before it.
    const std::vector<std::vector<std::size_t>>& strong_components() const { return strong_; }
    /// The weakly connected components, each ascending, ordered by their first unknowns: no unknown of one influences an
    /// unknown of another.
    const std::vector<std::vector<std::size_t>>& weak_components() const { return weak_; }
    /// The strongly connected component of unknown i.
    const std::vector<std::size_t>& component_of(std::size_t i) const;
    /// Unknown i and all unknowns that it depends on, directly or not, ascending: their equations are a system of their
    /// own.
    std::vector<std::size_t> closure(std::size_t i) const;

private:
    void find_weak_components();

    std::vector<std::vector<std::size_t>> direct_, strong_, weak_;
};

/// A system of some of the unknowns of another, and where these are in it.
struct closed_subsystem {
    explicit_system system;
    /// Unknown k of `system` is unknown unknowns[k] of the whole system,
    std::vector<std::size_t> unknowns;
    /// and leaf k (unknowns with their lower derivatives, in order) is leaf leaves[k] of it.
    std::vector<std::size_t> leaves;
    /// How many leaves the whole system has.
    std::size_t leaves_of_whole = 0;
};

/// The equations of a set of unknowns that contains with each unknown those that it depends on (closure, a weak
/// component, unions of such), with their starts and with the invariants and closed forms in them alone; a singular
/// start is read anew, so that the root of its powers is that of these equations. For all unknowns it is the system
/// itself. A system without starts (explicit_system::first_order) gives one without starts. Throws error for a set that
/// is not closed.
closed_subsystem subsystem_of(const explicit_system& of, const std::vector<std::size_t>& unknowns);

/// The smallest such system that contains these unknowns. Throws error for a name that is none of them.
closed_subsystem subsystem_with(const explicit_system& of, const std::vector<std::string>& names);

/// The subsystems of the weakly connected components, in their order: one, the system itself, where it does not fall
/// apart.
std::vector<closed_subsystem> independent_subsystems(const explicit_system& of);

}  // namespace libration::ode
