#include "multipliers.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// So many places, one for each row, at which the rows are most independent: those of the pivots of an elimination.
std::vector<std::size_t> pivots_of(const ball_matrix& rows) {
    std::vector<std::vector<double>> rest;
    for (const auto& row : rows) {
        auto& values = rest.emplace_back();
        for (const ball& each : row) {
            values.push_back(as_double(each));
        }
    }
    std::vector<std::size_t> pivots;
    for (std::size_t k = 0; k < rest.size(); ++k) {
        const auto largest = std::ranges::max_element(rest[k], {}, [](double x) { return std::abs(x); });
        const auto pivot = static_cast<std::size_t>(largest - rest[k].begin());
        pivots.push_back(pivot);
        for (std::size_t i = k + 1; i < rest.size(); ++i) {
            const double factor = rest[i][pivot] / rest[k][pivot];
            for (std::size_t j = 0; j < rest[i].size(); ++j) {
                rest[i][j] -= factor * rest[k][j];
            }
            rest[i][pivot] = 0;
        }
    }
    return pivots;
}

std::vector<std::size_t> all_but(std::size_t size, const std::vector<std::size_t>& left_out) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < size; ++i) {
        if (std::ranges::find(left_out, i) == left_out.end()) {
            kept.push_back(i);
        }
    }
    return kept;
}

dense_matrix part_of(const dense_matrix& of, const std::vector<std::size_t>& rows,
                     const std::vector<std::size_t>& columns) {
    dense_matrix result(rows.size(), columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            result(i, j) = of(rows[i], columns[j]);
        }
    }
    return result;
}

dense_matrix dense(const ball_matrix& rows, std::size_t columns) {
    dense_matrix result(rows.size(), columns);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            result(i, j) = rows[i][j];
        }
    }
    return result;
}

dense_matrix difference(dense_matrix a, const dense_matrix& b) {
    for (std::size_t k = 0; k < a.entries.size(); ++k) {
        a.entries[k] -= b.entries[k];
    }
    return a;
}

std::vector<std::size_t> first_numbers(std::size_t count) { return all_but(count, {}); }

// M on ker L, in the components that are not pivots of L.
std::optional<dense_matrix> on_kernel(const dense_matrix& flow, const ball_matrix& gradients,
                                      const std::vector<std::size_t>& kept, const std::vector<std::size_t>& pivots) {
    const dense_matrix rows = dense(gradients, flow.columns);
    const auto all = first_numbers(gradients.size());
    const auto solved = inverse(part_of(rows, all, pivots));
    if (!solved) {
        return std::nullopt;
    }
    return difference(part_of(flow, kept, kept),
                      product(part_of(flow, kept, pivots), product(*solved, part_of(rows, all, kept))));
}

// The quotient by the span of the columns X, with M X = X, in the components that are not pivots of X.
std::optional<dense_matrix> on_quotient(const dense_matrix& map, const ball_matrix& fields) {
    const auto pivots = pivots_of(fields);
    const auto kept = all_but(map.rows, pivots);
    const dense_matrix rows = dense(fields, map.rows);  // X transposed
    const auto all = first_numbers(fields.size());
    const auto solved = inverse(part_of(rows, all, pivots));
    if (!solved) {
        return std::nullopt;
    }
    // X_W X_K^-1 = (X_K^-T X_W^T)^T.
    const dense_matrix transposed = product(*solved, part_of(rows, all, kept));
    dense_matrix by(kept.size(), pivots.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t j = 0; j < pivots.size(); ++j) {
            by(i, j) = transposed(j, i);
        }
    }
    return difference(part_of(map, kept, kept), product(by, part_of(map, pivots, kept)));
}

class eigenvalue_search {
public:
    explicit eigenvalue_search(const dense_matrix& of) : size_(static_cast<slong>(of.rows)) {
        acb_mat_init(matrix_, size_, size_);
        acb_mat_init(vectors_, size_, size_);
        values_ = _acb_vec_init(size_);
        near_ = _acb_vec_init(size_);
        for (std::size_t i = 0; i < of.rows; ++i) {
            for (std::size_t j = 0; j < of.rows; ++j) {
                acb_set_arb(acb_mat_entry(matrix_, static_cast<slong>(i), static_cast<slong>(j)), of(i, j).handle());
            }
        }
    }
    eigenvalue_search(const eigenvalue_search&) = delete;
    eigenvalue_search& operator=(const eigenvalue_search&) = delete;
    ~eigenvalue_search() {
        acb_mat_clear(matrix_);
        acb_mat_clear(vectors_);
        _acb_vec_clear(values_, size_);
        _acb_vec_clear(near_, size_);
    }

    std::optional<enclosed_multipliers> result() {
        const slong bits = ball::working_bits();
        acb_mat_approx_eig_qr(near_, nullptr, vectors_, matrix_, nullptr, 0, bits);
        enclosed_multipliers found;
        found.isolated = acb_mat_eig_simple(values_, nullptr, nullptr, matrix_, near_, vectors_, bits) != 0;
        if (!found.isolated && acb_mat_eig_multiple(values_, matrix_, near_, vectors_, bits) == 0) {
            return std::nullopt;
        }
        for (slong k = 0; k < size_; ++k) {
            complex_number<ball> value;
            arb_set(value.re.handle(), acb_realref(values_ + k));
            arb_set(value.im.handle(), acb_imagref(values_ + k));
            if (!is_finite(value.re) || !is_finite(value.im)) {
                return std::nullopt;
            }
            found.values.push_back(value);
        }
        found.isolated = found.isolated && conjugates_are_apart(found.values);
        for (complex_number<ball>& each : found.values) {
            if (found.isolated && contains_zero(each.im)) {
                each.im = ball(0);
            }
        }
        return found;
    }

private:
    // An enclosure that meets the real axis contains a real eigenvalue and no other, if its conjugate, which contains
    // the conjugate eigenvalue, meets no other enclosure.
    static bool conjugates_are_apart(const std::vector<complex_number<ball>>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (std::size_t j = 0; j < values.size() && contains_zero(values[i].im); ++j) {
                if (i != j && overlaps(values[i].re, values[j].re) && overlaps(values[i].im, -values[j].im)) {
                    return false;
                }
            }
        }
        return true;
    }

    slong size_;
    acb_mat_t matrix_, vectors_;
    acb_ptr values_, near_;
};

ball square_of_size(const complex_number<ball>& z) { return z.re * z.re + z.im * z.im; }

// 1/conj z = z/|z|^2 is an eigenvalue with z: it is z itself if no other enclosure meets that of it.
bool is_on_circle(const std::vector<complex_number<ball>>& all, std::size_t k) {
    const ball square = square_of_size(all[k]);
    if (contains_zero(square)) {
        return false;
    }
    const ball re = all[k].re / square;
    const ball im = all[k].im / square;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != k && overlaps(all[i].re, re) && overlaps(all[i].im, im)) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::optional<enclosed_multipliers> other_multipliers(const ball_matrix& flow,
                                                      const known_directions::at_state& known) {
    const auto pivots = pivots_of(known.gradients);
    const auto kept = all_but(flow.size(), pivots);
    const auto map = known.gradients.empty() ? std::optional(dense(flow, flow.size()))
                                             : on_kernel(dense(flow, flow.size()), known.gradients, kept, pivots);
    if (!map) {
        return std::nullopt;
    }
    ball_matrix fields;
    for (const auto& each : known.fields) {
        auto& row = fields.emplace_back();
        for (const std::size_t i : kept) {
            row.push_back(each[i]);
        }
    }
    const auto rest = on_quotient(*map, fields);
    if (!rest) {
        return std::nullopt;
    }
    if (rest->rows == 0) {
        return enclosed_multipliers{{}, true};
    }
    return eigenvalue_search(*rest).result();
}

orbit_stability stability_of(const enclosed_multipliers& others, std::size_t ones, bool symplectic) {
    const auto& all = others.values;
    if (std::ranges::any_of(all, [](const auto& z) { return certainly_less(ball(1), square_of_size(z)); })) {
        return orbit_stability::unstable;
    }
    if (ones == 1 &&
        std::ranges::all_of(all, [](const auto& z) { return certainly_less(square_of_size(z), ball(1)); })) {
        return orbit_stability::attracting;
    }
    if (symplectic && others.isolated && !all.empty()) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!is_on_circle(all, k)) {
                return orbit_stability::undecided;
            }
        }
        return orbit_stability::on_circle;
    }
    return orbit_stability::undecided;
}

}  // namespace libration::ode
