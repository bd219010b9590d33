#include "linear_solution.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace libration::ode {

namespace {

/// sum coefficients[i] targets[i] + rest.
struct linear_form {
    std::vector<expression> coefficients;
    expression rest;

    bool is_free() const {
        return std::ranges::all_of(coefficients, [](const expression& c) { return c.is(0); });
    }
};

class linear_reading {
public:
    linear_reading(const std::vector<expression>& targets, const equation& of) : targets_(targets), of_(of) {}

    const linear_form& form(const expression& e) {
        const auto found = done_.find(e.identity());
        if (found != done_.end()) {
            return found->second;
        }
        return done_.emplace(e.identity(), made(e)).first->second;
    }

private:
    linear_form free(const expression& e) const { return {std::vector<expression>(targets_.size()), e}; }

    linear_form made(const expression& e) {
        switch (e.kind()) {
            case node_kind::unknown: return leaf(e);
            case node_kind::sum: return sum(e);
            case node_kind::product: return product(e);
            case node_kind::quotient: return quotient(e);
            case node_kind::power: require_free(e.left(), "a power"); return free(e);
            case node_kind::function: require_free(e.left(), "a function"); return free(e);
            default: return free(e);
        }
    }

    linear_form leaf(const expression& e) const {
        const auto found = std::ranges::find_if(targets_, [&](const expression& t) { return same_form(t, e); });
        linear_form result = free(found == targets_.end() ? e : expression());
        if (found != targets_.end()) {
            result.coefficients[static_cast<std::size_t>(found - targets_.begin())] = 1;
        }
        return result;
    }

    linear_form sum(const expression& e) {
        linear_form result = form(e.left());
        const linear_form& more = form(e.right());
        if (result.is_free() && more.is_free()) {
            return free(e);
        }
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            result.coefficients[i] = result.coefficients[i] + more.coefficients[i];
        }
        result.rest = result.rest + more.rest;
        return result;
    }

    linear_form product(const expression& e) {
        const linear_form& left = form(e.left());
        const linear_form& right = form(e.right());
        if (left.is_free() && right.is_free()) {
            return free(e);
        }
        if (!left.is_free() && !right.is_free()) {
            refuse_form(e.left(), "a product with another highest derivative");
        }
        const expression& factor = left.is_free() ? e.left() : e.right();
        linear_form result = left.is_free() ? right : left;
        for (expression& c : result.coefficients) {
            c = factor * c;
        }
        result.rest = factor * result.rest;
        return result;
    }

    linear_form quotient(const expression& e) {
        require_free(e.right(), "a denominator");
        linear_form result = form(e.left());
        if (result.is_free()) {
            return free(e);
        }
        for (expression& c : result.coefficients) {
            c = c / e.right();
        }
        result.rest = result.rest / e.right();
        return result;
    }

    void require_free(const expression& e, const std::string& where) {
        if (!form(e).is_free()) {
            refuse_form(e, where);
        }
    }

    [[noreturn]] void refuse_form(const expression& e, const std::string& where) {
        const linear_form& found = form(e);
        std::size_t which = 0;
        while (found.coefficients[which].is(0)) {
            ++which;
        }
        const expression& t = targets_[which];
        refuse(primed(t.name(), t.derivative()), of_.at,
               "is the highest derivative and stands in " + where +
                   ": make the equation explicit, by solving for it or by differentiating");
    }

    const std::vector<expression>& targets_;
    const equation& of_;
    std::unordered_map<const void*, linear_form> done_;
};

// Elimination: each step takes the simplest coefficient that may be divided by.
class elimination {
public:
    elimination(std::vector<linear_form> rows, const std::vector<equation>& equations,
                const std::vector<expression>& targets, const nonzero_test& may_divide)
        : rows_(std::move(rows)),
          equations_(equations),
          targets_(targets),
          may_divide_(may_divide),
          row_of_(targets.size()),
          used_(rows_.size(), false) {}

    std::vector<expression> solve() {
        for (std::size_t step = 0; step < targets_.size(); ++step) {
            const auto [row, column] = pivot();
            used_[row] = true;
            row_of_[column] = row;
            normalize(row, column);
            for (std::size_t other = 0; other < rows_.size(); ++other) {
                if (other != row) {
                    subtract(other, row, column);
                }
            }
        }
        std::vector<expression> result;
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            result.push_back(-rows_[*row_of_[i]].rest);
        }
        return result;
    }

private:
    struct choice {
        std::size_t row, column;
    };

    choice pivot() const {
        std::optional<choice> best;
        int least = 0;
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            for (std::size_t column = 0; !used_[row] && column < targets_.size(); ++column) {
                if (row_of_[column] || rows_[row].coefficients[column].is(0)) {
                    continue;
                }
                const int cost = cost_of(row, column);
                if (!best || cost < least) {
                    best = {row, column};
                    least = cost;
                }
            }
        }
        if (!best) {
            refuse_undetermined();
        }
        return *best;
    }

    int cost_of(std::size_t row, std::size_t column) const {
        const auto others =
            std::ranges::count_if(rows_[row].coefficients, [](const expression& c) { return !c.is(0); });
        const expression& c = rows_[row].coefficients[column];
        const int kind = c.kind() == node_kind::constant ? 0 : may_divide_(c) ? 100 : 10'000;
        return kind + static_cast<int>(others);
    }

    void normalize(std::size_t row, std::size_t column) {
        const expression by = rows_[row].coefficients[column];
        for (expression& c : rows_[row].coefficients) {
            c = c / by;
        }
        rows_[row].rest = rows_[row].rest / by;
    }

    void subtract(std::size_t from, std::size_t row, std::size_t column) {
        const expression times = rows_[from].coefficients[column];
        if (times.is(0)) {
            return;
        }
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            const expression less = times * rows_[row].coefficients[i];
            rows_[from].coefficients[i] = i == column ? expression() : rows_[from].coefficients[i] - less;
        }
        rows_[from].rest = rows_[from].rest - times * rows_[row].rest;
    }

    [[noreturn]] void refuse_undetermined() const {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!used_[i] && rows_[i].is_free()) {
                refuse("equation " + std::to_string(i + 1), equations_[i].at,
                       "has no highest derivative of its own: use its derivative in its place");
            }
        }
        for (std::size_t i = 0; i < targets_.size(); ++i) {
            if (!row_of_[i]) {
                refuse(primed(targets_[i].name(), targets_[i].derivative()), {},
                       "does not come out of the equations: add one that determines it");
            }
        }
        refuse("", {}, "has equations that depend on each other: give independent ones");
    }

    std::vector<linear_form> rows_;
    const std::vector<equation>& equations_;
    const std::vector<expression>& targets_;
    const nonzero_test& may_divide_;
    std::vector<std::optional<std::size_t>> row_of_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<expression> linear_solution(const std::vector<equation>& equations, const std::vector<expression>& targets,
                                        const nonzero_test& may_divide) {
    std::vector<linear_form> rows;
    for (const equation& each : equations) {
        const expression zero = each.left - each.right;
        rows.push_back(linear_reading(targets, each).form(zero));
    }
    return elimination(std::move(rows), equations, targets, may_divide).solve();
}

}  // namespace libration::ode
