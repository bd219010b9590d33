#include "flow_variations.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "kept_bounds.hpp"
#include "set_values.hpp"
#include "step_norms.hpp"

namespace libration::ode {

namespace {

// The derivatives of all unknowns of a form by the given ones, by rows; each row by the columns where it is nonzero.
using jacobian_row = std::map<std::size_t, expression>;

void add_by_chain(jacobian_row& row, std::size_t leaf, const expression& by, const std::vector<jacobian_row>& leaves) {
    for (const auto& [column, inner] : leaves[leaf]) {
        const expression product = by * inner;
        const auto found = row.find(column);
        if (found == row.end()) {
            row.emplace(column, product);
        } else {
            found->second = found->second + product;
        }
    }
}

gradient nonzero_partials(const expression& e, const std::map<std::string, std::size_t>& places,
                          const std::vector<expression>& leaves) {
    std::map<std::size_t, bool> occurring;
    each_leaf(e, [&](const expression& leaf) {
        if (leaf.kind() == node_kind::unknown) {
            occurring[places.at(leaf.name())] = true;
        }
    });
    gradient result;
    for (const auto& [k, _] : occurring) {
        expression by = partial(e, leaves[k]);
        if (!by.is(0)) {
            result.emplace_back(k, std::move(by));
        }
    }
    return result;
}

}  // namespace

jacobian_form::differentiated::differentiated(const polynomial_form& of) {
    std::map<std::string, std::size_t> places;
    std::vector<jacobian_row> leaves(of.leaves.size());
    for (std::size_t k = 0; k < of.leaves.size(); ++k) {
        places.emplace(of.leaves[k].name(), k);
        if (k < of.given) {
            leaves[k].emplace(k, expression(1));
            continue;
        }
        for (const auto& [leaf, by] : of.polynomial_gradients[k - of.given]) {
            add_by_chain(leaves[k], leaf, by, leaves);
        }
    }
    for (std::size_t i = 0; i < of.given; ++i) {
        jacobian_row row;
        for (const auto& [leaf, by] : nonzero_partials(of.system.right()[i], places, of.leaves)) {
            add_by_chain(row, leaf, by, leaves);
        }
        for (auto& [column, value] : row) {
            if (!value.is(0)) {
                entries.push_back({i, column, value.is_constant()});
                values.push_back(std::move(value));
            }
        }
    }
}

jacobian_form::jacobian_form(const polynomial_form& of) : jacobian_form(of, differentiated(of)) {}

jacobian_form::jacobian_form(const polynomial_form& of, differentiated jacobian)
    : given_(of.given), entries_(std::move(jacobian.entries)), tape_(tape::about_points(of.system, jacobian.values)) {}

std::size_t jacobian_form::steps_of_unknowns() const {
    return static_cast<std::size_t>(std::ranges::max(tape_.outputs())) + 1;
}

flow_variations::flow_variations(const jacobian_form& of, int order, const series::block_product<ball>* fast)
    : of_(&of),
      unknowns_(of.steps(), order, fast),
      length_(static_cast<std::size_t>(order) + 1),
      columns_(of.given() * of.given() * length_) {}

void flow_variations::about(const ball& time, const std::vector<ball>& lifted) {
    unknowns_.about(time, as_state(lifted));
    const std::size_t given = of_->given();
    for (std::size_t j = 0; j < given; ++j) {
        for (std::size_t i = 0; i < given; ++i) {
            columns_[place(i, j)] = ball(i == j ? 1 : 0);
        }
    }
    const auto& entries = of_->entries();
    std::vector<ball> sums(given);
    for (std::size_t n = 0; n + 1 < length_; ++n) {
        for (std::size_t j = 0; j < given; ++j) {
            std::ranges::fill(sums, ball(0));
            for (std::size_t k = 0; k < entries.size(); ++k) {
                const ball* const a = unknowns_.watched(static_cast<int>(k));
                ball& sum = sums[entries[k].row];
                arb_dot(sum.handle(), sum.handle(), 0, a->handle(), 1,
                        columns_[place(entries[k].column, j) + n].handle(), -1,
                        entries[k].constant ? 1 : static_cast<slong>(n) + 1, ball::working_bits());
            }
            for (std::size_t i = 0; i < given; ++i) {
                columns_[place(i, j) + n + 1] = sums[i] / static_cast<long>(n + 1);
            }
        }
    }
}

double flow_variations::estimated_radius() const {
    const std::size_t given = of_->given();
    const auto least_by = [&](const auto& size) {
        double least = no_radius;
        for (std::size_t i = 0; i < of_->steps().orders().size(); ++i) {
            least = std::min(least, ode::estimated_radius(unknowns_.coefficients(static_cast<int>(i)), order(), size));
        }
        for (std::size_t k = 0; k < given * given; ++k) {
            least = std::min(least, ode::estimated_radius(columns_.data() + k * length_, order(), size));
        }
        return least;
    };
    const double certain = least_by([](const ball& a) { return least_size_of(a); });
    return certain < no_radius ? certain : least_by([](const ball& a) { return size_of(a); });
}

std::optional<tail_bound> flow_variations::tail(const ball& time, double log_of_radius) const {
    if (log_of_radius == no_radius) {
        double scale = 0;
        for (std::size_t i = 0; i < of_->steps().orders().size(); ++i) {
            scale = std::max(scale, scale_of_series(unknowns_.coefficients(static_cast<int>(i)), order()));
        }
        for (std::size_t first = 0; first < columns_.size(); first += length_) {
            scale = std::max(scale, scale_of_series(columns_.data() + first, order()));
        }
        log_of_radius = largest_tried + scale;
    }
    const series_sizes sizes = sizes_of(of_->steps(), unknowns_, time, order());
    return first_tail(log_of_radius, [&](const magnitude& radius) { return bounded(sizes, radius); });
}

std::optional<tail_bound> flow_variations::bounded(const series_sizes& sizes, const magnitude& radius) const {
    const norms_of_steps norms(of_->steps(), sizes, radius);
    const auto of_unknowns = kept_remainders(of_->steps(), norms, order(), radius, of_->steps_of_unknowns());
    if (!of_unknowns) {
        return std::nullopt;
    }
    const std::size_t given = of_->given();
    const auto& entries = of_->entries();
    const auto degree = static_cast<unsigned long>(order());
    const auto changes =
        norms.changes([&](const tape_step& state) { return (*of_unknowns)[static_cast<std::size_t>(state.left)]; });
    std::vector<magnitude> sizes_of_entries;
    std::vector<magnitude> changes_of_entries;
    for (const int step : of_->steps().watched()) {
        const magnitude& change = changes[static_cast<std::size_t>(step)];
        changes_of_entries.push_back(change);
        sizes_of_entries.push_back(norms.parts(step).whole + change);
    }
    if (!std::ranges::all_of(sizes_of_entries, [](const magnitude& each) { return each.is_finite(); })) {
        return std::nullopt;  // also where a factor of 0 hides it
    }
    const magnitude of_defect = radius / (degree + 1);
    const magnitude gain = radius / (degree + 2);
    tail_bound result{
        radius, order(), {of_unknowns->begin(), of_unknowns->begin() + static_cast<std::ptrdiff_t>(given)}};
    for (std::size_t j = 0; j < given; ++j) {
        std::vector<norms_of_steps::step_norm> column;
        for (std::size_t i = 0; i < given; ++i) {
            column.push_back(norms.parts_of(coefficients(i, j)));
        }
        std::vector<magnitude> fixed(given);  // what does not depend on s
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const auto& q = column[entries[k].column];
            const auto& jacobian = norms.parts(of_->steps().watched()[k]);
            magnitude& sum = fixed[entries[k].row];
            sum.add_product(norms_of_steps::rest_of_product(jacobian, q), of_defect);
            sum.add_product(changes_of_entries[k] * q.whole, gain);
        }
        const auto image = [&](const std::vector<magnitude>& s) {
            std::vector<magnitude> next(given);
            for (std::size_t k = 0; k < entries.size(); ++k) {
                next[entries[k].row].add_product(sizes_of_entries[k], s[entries[k].column]);
            }
            for (std::size_t i = 0; i < given; ++i) {
                next[i] = next[i] * gain + fixed[i];
            }
            return next;
        };
        const auto kept = kept_bounds(image, fixed, [](std::vector<magnitude>&) {});
        if (!kept) {
            return std::nullopt;
        }
        result.error.insert(result.error.end(), kept->begin(), kept->end());
    }
    return result;
}

}  // namespace libration::ode
