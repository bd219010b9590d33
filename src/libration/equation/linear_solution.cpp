#include "linear_solution.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "libration/equation/node_values.hpp"

namespace libration::ode {

namespace {

using target_indices = std::map<std::string, std::size_t>;

/// sum coefficients[i] targets[i] + rest; coefficients that are 0 are left out.
struct linear_form {
    std::map<std::size_t, expression> coefficients;
    expression rest;

    bool is_free() const { return coefficients.empty(); }

    /// Applies an operation to each coefficient and to the rest.
    template <class Operation>
    linear_form mapped(const Operation& operation) const {
        linear_form result{{}, operation(rest)};
        for (const auto& [i, c] : coefficients) {
            result.set(i, operation(c));
        }
        return result;
    }
    void set(std::size_t i, const expression& value) {
        if (value.is(0)) {
            coefficients.erase(i);
        } else {
            coefficients.insert_or_assign(i, value);
        }
    }
    expression coefficient(std::size_t i) const {
        const auto found = coefficients.find(i);
        return found == coefficients.end() ? expression() : found->second;
    }
};

class linear_reading {
public:
    linear_reading(const std::vector<expression>& targets, const target_indices& indices, const equation& of)
        : targets_(targets), indices_(indices), of_(of) {}

    const linear_form& form(const expression& e) {
        return done_.of(e, [this](const expression& each) { return made(each); });
    }

private:
    linear_form made(const expression& e) {
        switch (e.kind()) {
            case node_kind::unknown: return leaf(e);
            case node_kind::sum: return sum(e);
            case node_kind::product: return product(e);
            case node_kind::quotient: return quotient(e);
            case node_kind::power: require_free(e.left(), "a power"); return {{}, e};
            case node_kind::function: require_free(e.left(), "a function"); return {{}, e};
            case node_kind::constant:
            case node_kind::variable:
            case node_kind::parameter: break;
        }
        return {{}, e};
    }

    linear_form leaf(const expression& e) const {
        const auto found = indices_.find(primed(e.name(), e.derivative()));
        return found == indices_.end() ? linear_form{{}, e} : linear_form{{{found->second, 1}}, {}};
    }

    linear_form sum(const expression& e) {
        const linear_form& left = done_.at(e.left());
        const linear_form& right = done_.at(e.right());
        if (left.is_free() && right.is_free()) {
            return {{}, e};
        }
        linear_form result = left;
        for (const auto& [i, c] : right.coefficients) {
            result.set(i, result.coefficient(i) + c);
        }
        result.rest = result.rest + right.rest;
        return result;
    }

    linear_form product(const expression& e) {
        const linear_form& left = done_.at(e.left());
        const linear_form& right = done_.at(e.right());
        if (left.is_free() && right.is_free()) {
            return {{}, e};
        }
        if (!left.is_free() && !right.is_free()) {
            refuse_form(e.left(), "a product with another highest derivative");
        }
        const expression& factor = left.is_free() ? e.left() : e.right();
        return (left.is_free() ? right : left).mapped([&](const expression& c) { return factor * c; });
    }

    linear_form quotient(const expression& e) {
        require_free(e.right(), "a denominator");
        const linear_form& above = done_.at(e.left());
        return above.is_free() ? linear_form{{}, e} : above.mapped([&](const expression& c) { return c / e.right(); });
    }

    void require_free(const expression& e, const std::string& where) {
        if (!done_.at(e).is_free()) {
            refuse_form(e, where);
        }
    }

    [[noreturn]] void refuse_form(const expression& e, const std::string& where) {
        const expression& t = targets_[done_.at(e).coefficients.begin()->first];
        refuse(primed(t.name(), t.derivative()), of_.at,
               "is the highest derivative and occurs in " + where +
                   ": make the equation explicit, by solving for it or by differentiating");
    }

    const std::vector<expression>& targets_;
    const target_indices& indices_;
    const equation& of_;
    node_values<linear_form> done_;
};

// Elimination: the pivot of each step is the simplest coefficient by which division is possible.
class elimination {
public:
    elimination(std::vector<linear_form> rows, const std::vector<expression>& targets, const nonzero_test& may_divide)
        : rows_(std::move(rows)),
          targets_(targets),
          may_divide_(may_divide),
          row_of_(targets.size()),
          used_(rows_.size(), false),
          rows_with_(targets.size()) {
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            for (const auto& [column, c] : rows_[row].coefficients) {
                rows_with_[column].insert(row);
            }
        }
    }

    linear_result solve() {
        linear_result result;
        const bool determined = eliminate();
        result.divisors = std::move(divisors_);
        result.doubtful = std::move(doubtful_);
        if (determined) {
            for (std::size_t i = 0; i < targets_.size(); ++i) {
                result.values.push_back(-rows_[*row_of_[i]].rest);
            }
            return result;
        }
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            if (!used_[row] && rows_[row].is_free()) {
                result.constraints.push_back({row, rows_[row].rest});
            }
        }
        if (result.constraints.empty()) {
            refuse_undetermined();
        }
        return result;
    }

private:
    struct choice {
        std::size_t row, column;
    };

    // Whether every target has a row.
    bool eliminate() {
        for (std::size_t step = 0; step < targets_.size(); ++step) {
            const auto next = pivot();
            if (!next) {
                return false;
            }
            const auto [row, column] = *next;
            used_[row] = true;
            row_of_[column] = row;
            normalize(row, column);
            const std::set<std::size_t> with_it = std::exchange(rows_with_[column], {row});
            for (const std::size_t other : with_it) {
                if (other != row) {
                    subtract(other, row, column);
                }
            }
        }
        return true;
    }

    // The first of the simplest ones: a constant without another coefficient in its row is the simplest possible.
    std::optional<choice> pivot() const {
        std::optional<choice> best;
        int least = 0;
        for (std::size_t row = 0; row < rows_.size() && (!best || least > 1); ++row) {
            if (used_[row]) {
                continue;
            }
            for (const auto& [column, c] : rows_[row].coefficients) {
                const int cost = row_of_[column] ? 0 : cost_of(row, c);
                if (cost > 0 && (!best || cost < least)) {
                    best = {row, column};
                    least = cost;
                }
            }
        }
        return best;
    }

    int cost_of(std::size_t row, const expression& c) const {
        const int kind = c.kind() == node_kind::constant ? 0 : may_divide_(c) ? 100 : 10'000;
        return kind + static_cast<int>(rows_[row].coefficients.size());
    }

    void normalize(std::size_t row, std::size_t column) {
        const expression by = rows_[row].coefficients.at(column);
        if (by.kind() != node_kind::constant) {
            divisors_.push_back({column, by});
            if (!may_divide_(by)) {
                doubtful_.push_back(by);
            }
        }
        rows_[row] = rows_[row].mapped([&](const expression& c) { return c / by; });
    }

    void subtract(std::size_t from, std::size_t row, std::size_t column) {
        const expression times = rows_[from].coefficient(column);
        if (times.is(0)) {
            return;
        }
        for (const auto& [i, c] : rows_[row].coefficients) {
            rows_with_[i].insert(from);
            rows_[from].set(i, i == column ? expression() : rows_[from].coefficient(i) - times * c);
        }
        rows_[from].rest = rows_[from].rest - times * rows_[row].rest;
    }

    [[noreturn]] void refuse_undetermined() const {
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            if (!row_of_[i]) {
                refuse(primed(targets_[i].name(), targets_[i].derivative()), {},
                       "is not determined by the equations: add one that determines it");
            }
        }
        refuse("", {}, "has equations that depend on each other: give independent ones");
    }

    std::vector<linear_form> rows_;
    const std::vector<expression>& targets_;
    const nonzero_test& may_divide_;
    std::vector<std::optional<std::size_t>> row_of_;
    std::vector<bool> used_;
    std::vector<divisor> divisors_;
    std::vector<expression> doubtful_;
    std::vector<std::set<std::size_t>> rows_with_;  // a superset of the rows with a coefficient in a column
};

}  // namespace

linear_result linear_solution(const std::vector<equation>& equations, const std::vector<expression>& targets,
                              const nonzero_test& may_divide) {
    target_indices indices;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        indices.emplace(primed(targets[i].name(), targets[i].derivative()), i);
    }
    std::vector<linear_form> rows;
    for (const equation& each : equations) {
        const expression zero = each.left - each.right;
        rows.push_back(linear_reading(targets, indices, each).form(zero));
    }
    return elimination(std::move(rows), targets, may_divide).solve();
}

}  // namespace libration::ode
