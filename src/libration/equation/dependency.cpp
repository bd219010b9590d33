#include "libration/equation/dependency.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t no_number = std::numeric_limits<std::size_t>::max();

// The indices of the unknowns in an expression, ascending.
std::vector<std::size_t> unknowns_in(const expression& e, const std::map<std::string, std::size_t>& index_of) {
    std::vector<std::size_t> found;
    each_leaf(e, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown) {
            found.push_back(index_of.at(leaf.name()));
        }
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Tarjan's algorithm with an explicit stack: chains of unknowns may be long. A component is complete when the search
// leaves its first unknown, after all components that it depends on.
class depth_first_search {
public:
    explicit depth_first_search(const std::vector<std::vector<std::size_t>>& edges)
        : edges_(edges),
          number_(edges.size(), no_number),
          least_(edges.size(), no_number),
          is_open_(edges.size(), false) {}

    std::vector<std::vector<std::size_t>> result() {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (number_[i] == no_number) {
                search_from(i);
            }
        }
        return std::move(found_);
    }

private:
    struct visit {
        std::size_t at, next_edge;
    };

    void search_from(std::size_t root) {
        enter(root);
        while (!way_.empty()) {
            const std::size_t at = way_.back().at;
            if (way_.back().next_edge == edges_[at].size()) {
                leave(at);
                continue;
            }
            const std::size_t to = edges_[at][way_.back().next_edge++];
            if (number_[to] == no_number) {
                enter(to);
            } else if (is_open_[to]) {
                least_[at] = std::min(least_[at], number_[to]);
            }
        }
    }

    void enter(std::size_t at) {
        number_[at] = least_[at] = count_++;
        is_open_[at] = true;
        open_.push_back(at);
        way_.push_back({at, 0});
    }

    void leave(std::size_t at) {
        way_.pop_back();
        if (!way_.empty()) {
            least_[way_.back().at] = std::min(least_[way_.back().at], least_[at]);
        }
        if (least_[at] != number_[at]) {
            return;
        }
        auto& component = found_.emplace_back();
        do {
            component.push_back(open_.back());
            is_open_[open_.back()] = false;
            open_.pop_back();
        } while (component.back() != at);
        std::ranges::sort(component);
    }

    const std::vector<std::vector<std::size_t>>& edges_;
    std::vector<std::size_t> number_, least_, open_;
    std::vector<bool> is_open_;
    std::vector<visit> way_;
    std::vector<std::vector<std::size_t>> found_;
    std::size_t count_ = 0;
};

// All reachable unknowns, ascending.
std::vector<std::size_t> reached_from(std::size_t first, const std::vector<std::vector<std::size_t>>& edges) {
    std::vector<bool> seen(edges.size(), false);
    std::vector<std::size_t> reached{first};
    seen[first] = true;
    for (std::size_t k = 0; k < reached.size(); ++k) {
        for (const std::size_t to : edges[reached[k]]) {
            if (!seen[to]) {
                seen[to] = true;
                reached.push_back(to);
            }
        }
    }
    std::ranges::sort(reached);
    return reached;
}

[[noreturn]] void refuse_open_set(const unknown_function& of, const unknown_function& missing) {
    throw error(error_kind::argument, error_subject::problem, of.name,
                "depends on " + missing.name + ", which is not in the set of unknowns: add it");
}

explicit_system restricted(const explicit_system& of, const std::vector<std::size_t>& unknowns,
                           const dependency_graph& graph) {
    std::vector<expression> leaves;
    std::vector<expression> right;
    for (const std::size_t i : unknowns) {
        for (const std::size_t j : graph.direct(i)) {
            if (!std::ranges::binary_search(unknowns, j)) {
                refuse_open_set(of.unknowns()[i], of.unknowns()[j]);
            }
        }
        leaves.push_back(unknown(of.unknowns()[i].name));
        right.push_back(of.right()[i]);
    }
    if (of.starts().empty()) {
        return explicit_system::first_order(leaves, std::move(right), of.point());
    }
    equation_system given;
    given.variable = of.variable();
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        const auto& starts = of.starts()[unknowns[k]];
        given.add(derivative(leaves[k], static_cast<int>(starts.size())), right[k]);
        for (std::size_t j = 0; j < starts.size(); ++j) {
            given.begin(unknown(leaves[k].name(), static_cast<int>(j)), expression(starts[j]), expression(of.point()));
        }
    }
    const auto index_of = places_of(of.unknowns());
    const auto is_inside = [&](const expression& e) {
        return std::ranges::includes(unknowns, unknowns_in(e, index_of));
    };
    for (const expression& each : of.invariants()) {
        if (is_inside(each)) {
            given.invariants.push_back({each, 0, {}});
        }
    }
    for (const definition& each : of.exact()) {
        if (is_inside(unknown(each.name)) && is_inside(each.value)) {
            given.exact.push_back(each);
        }
    }
    return explicit_system(given);
}

}  // namespace

dependency_graph::dependency_graph(const explicit_system& of) {
    const auto index_of = places_of(of.unknowns());
    for (const expression& each : of.right()) {
        direct_.push_back(unknowns_in(each, index_of));
    }
    strong_ = depth_first_search(direct_).result();
    find_weak_components();
}

void dependency_graph::find_weak_components() {
    std::vector<std::vector<std::size_t>> both = direct_;
    for (std::size_t i = 0; i < size(); ++i) {
        for (const std::size_t j : direct_[i]) {
            both[j].push_back(i);
        }
    }
    std::vector<bool> known(size(), false);
    for (std::size_t i = 0; i < size(); ++i) {
        if (!known[i]) {
            weak_.push_back(reached_from(i, both));
            for (const std::size_t each : weak_.back()) {
                known[each] = true;
            }
        }
    }
}

const std::vector<std::size_t>& dependency_graph::component_of(std::size_t i) const {
    return *std::ranges::find_if(strong_, [&](const auto& each) { return std::ranges::binary_search(each, i); });
}

std::vector<std::size_t> dependency_graph::closure(std::size_t i) const { return reached_from(i, direct_); }

closed_subsystem subsystem_of(const explicit_system& of, const std::vector<std::size_t>& unknowns) {
    std::vector<std::size_t> first_leaf{0};
    for (const unknown_function& each : of.unknowns()) {
        first_leaf.push_back(first_leaf.back() + static_cast<std::size_t>(each.order));
    }
    std::vector<std::size_t> sorted = unknowns;
    std::ranges::sort(sorted);
    const bool whole = sorted.size() == of.unknowns().size();
    closed_subsystem result{whole ? of : restricted(of, sorted, dependency_graph(of)), {}, {}, first_leaf.back()};
    const auto index_of = places_of(of.unknowns());
    for (const unknown_function& each : result.system.unknowns()) {
        const std::size_t i = index_of.at(each.name);
        result.unknowns.push_back(i);
        for (std::size_t leaf = first_leaf[i]; leaf < first_leaf[i + 1]; ++leaf) {
            result.leaves.push_back(leaf);
        }
    }
    return result;
}

closed_subsystem subsystem_with(const explicit_system& of, const std::vector<std::string>& names) {
    const dependency_graph graph(of);
    const auto index_of = places_of(of.unknowns());
    std::set<std::size_t> closed;
    for (const std::string& name : names) {
        const auto found = index_of.find(name);
        if (found == index_of.end()) {
            throw error(error_kind::argument, error_subject::problem, name,
                        "is none of the unknowns: choose one of them");
        }
        const auto closure = graph.closure(found->second);
        closed.insert(closure.begin(), closure.end());
    }
    return subsystem_of(of, {closed.begin(), closed.end()});
}

std::vector<closed_subsystem> independent_subsystems(const explicit_system& of) {
    std::vector<closed_subsystem> result;
    const dependency_graph graph(of);
    for (const auto& each : graph.weak_components()) {
        result.push_back(subsystem_of(of, each));
    }
    return result;
}

}  // namespace libration::ode
