// The limit of a sequence s_n = s + s_1/n + s_2/n^2 + ..., n -> infinity, with an estimate of its error.
//
// Neville's table: the value at 1/n = 0 of the polynomial in 1/n through s_n and j earlier entries, s - S =
// O(n^-(j+1)); with steps h between the entries used [Guttmann1989]. Rounding grows with the column like (n/h)^j/j!, so
// the best column is the one whose last entries move least; larger steps amplify less. Oscillations are amplified in
// the same way and increase the movement: then column 0 is the best one. If the oscillation decays faster than the
// terms it hides, polynomials in 1/n fitted by least squares to many entries are more accurate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/settling.hpp"
#include "libration/scalar/error.hpp"

namespace libration::convergence {

/// s_n.
template <rounding_scalar T>
struct sequence_entry {
    int n;
    T value;
};

/// A limit, its uncertainty, and the power of 1/n removed last.
template <rounding_scalar T>
struct sequence_limit {
    T value = T(0);
    T uncertainty = T(0);
    int removed = 0;
};

namespace fitting {

/// Replaces column j - 1 of the table by column j; entries before j h are left as they were.
template <rounding_scalar T>
void next_column(std::vector<T>& column, const std::vector<sequence_entry<T>>& s, std::size_t j, std::size_t h) {
    T step(0);
    for (std::size_t i = s.size(); i-- > j * h;) {
        const int before = s[i - j * h].n;
        step = column[i];
        step -= column[i - h];
        step *= before;
        step /= s[i].n - before;
        column[i] += step;
    }
}

/// How many of the last entries of a column, which begins at `first`, show its movement.
template <rounding_scalar T>
std::size_t window_of(const std::vector<sequence_entry<T>>& s, std::size_t first) {
    return std::min(s.size() - 1 - first, std::max<std::size_t>(3, s.size() / 8));
}

/// The power p of n^-p with which the last entries of a column approach its limit, by their first and last differences,
/// at least 1/4; std::nullopt unless they are monotonic, as they are until rounding dominates.
template <rounding_scalar T>
std::optional<T> power_of_approach(const std::vector<T>& column, const std::vector<sequence_entry<T>>& s,
                                   std::size_t first) {
    using std::log;
    const std::size_t last = s.size() - 1;
    const std::size_t begin = last - window_of(s, first);
    const auto slope = [&](std::size_t i) { return T((column[i + 1] - column[i]) / (s[i + 1].n - s[i].n)); };
    const auto middle = [&](std::size_t i) { return T(T(s[i + 1].n + s[i].n) / 2); };
    const bool rises = column[begin] < column[last];
    for (std::size_t i = begin; i < last; ++i) {
        if (column[i] == column[i + 1] || (column[i] < column[i + 1]) != rises) {
            return std::nullopt;
        }
    }
    const T decrease = log(T(slope(begin) / slope(last - 1)));
    return std::max(T(T(1) / 4), T(decrease / log(T(middle(last - 1) / middle(begin))) - 1));
}

/// Entry i of column j with the movement of the previous entries, which estimates its error, of order n^-power.
template <rounding_scalar T>
sequence_limit<T> column_limit(const std::vector<T>& column, const std::vector<sequence_entry<T>>& s, std::size_t j,
                               std::size_t first, const T& power) {
    using std::abs;
    const std::size_t last = s.size() - 1;
    const std::size_t window = window_of(s, first);
    T moved(0);
    for (std::size_t i = last - window; i < last; ++i) {
        moved = std::max(moved, T(abs(column[i] - column[last])));
    }
    const T falls = T(s[last].n) / ((s[last].n - s[last - window].n) * power);
    return {column[last], T(moved * (falls > 1 ? falls : T(1))), static_cast<int>(j)};
}

/// The sums needed for a least-squares fit of a polynomial in 1/n to the entries `first` .. `last`, in the variable u
/// with u = -+1 at the ends n = m and n = m/2, so that the normal equations are well conditioned.
template <rounding_scalar T>
class fitted_polynomial {
public:
    /// For degrees up to `most`. O((last - first) most).
    fitted_polynomial(const std::vector<sequence_entry<T>>& s, std::size_t first, std::size_t last, std::size_t most)
        : powers_(2 * most + 1, T(0)), values_(most + 1, T(0)) {
        for (std::size_t e = first; e <= last; ++e) {
            const T u = T(2 * s[last].n) / s[e].n - 3;
            T power(1);
            for (std::size_t k = 0; k < powers_.size(); ++k) {
                if (k > 0) {
                    power *= u;
                }
                powers_[k] += power;
                if (k <= most) {
                    add_product(values_[k], power, s[e].value);
                }
            }
        }
    }

    /// The polynomial of this degree at 1/n = 0, u = -3; std::nullopt if the equations are singular.
    std::optional<T> at_infinity(std::size_t degree) const {
        std::vector<std::vector<T>> normal(degree + 1);
        for (std::size_t i = 0; i <= degree; ++i) {
            const auto row = powers_.begin() + static_cast<std::ptrdiff_t>(i);
            normal[i].assign(row, row + static_cast<std::ptrdiff_t>(degree) + 1);
        }
        std::vector<T> right(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(degree) + 1);
        const auto solution = solve_linear(std::move(normal), std::move(right), T(epsilon<T>() * 64));
        if (!solution) {
            return std::nullopt;
        }
        T value(0);
        for (std::size_t i = degree + 1; i-- > 0;) {
            value = value * -3 + (*solution)[i];
        }
        return value;
    }

private:
    std::vector<T> powers_;  ///< sum u^k
    std::vector<T> values_;  ///< sum u^k value
};

}  // namespace fitting

/// By Neville's table with the steps 1, 2, 4, .. and at most 40 columns. n increases from entry to entry; at least four
/// entries, of size about 1 or equally scaled. For a power law the uncertainty is about the error: column j, whose error
/// is O(n^-(j+1)), may approach the limit more slowly, as with a term in n^(-1/2), which no column removes; then so do
/// the later ones. O(N log N) per column. Throws error for fewer entries.
template <rounding_scalar T>
sequence_limit<T> neville_limit(const std::vector<sequence_entry<T>>& s) {
    using std::abs;
    constexpr std::size_t fewest = 4;
    constexpr std::size_t most_columns = 40;
    if (s.size() < fewest) {
        throw error(error_kind::argument, "number of entries", std::to_string(s.size()),
                    "is below the 4 that an extrapolation needs");
    }
    std::optional<sequence_limit<T>> best;
    for (std::size_t h = 1; h == 1 || h * 16 <= s.size(); h *= 2) {
        std::vector<T> column;
        column.reserve(s.size());
        for (const auto& entry : s) {
            column.push_back(entry.value);
        }
        const std::size_t most = std::min(most_columns, (s.size() - fewest) / h / 2);
        std::optional<T> before;  // the power of the column before
        std::optional<T> slow;    // that of a term that no column removes: the same in two of them
        for (std::size_t j = 0; j <= most; ++j) {
            if (j > 0) {
                fitting::next_column(column, s, j, h);
            }
            const auto power = fitting::power_of_approach(column, s, j * h);
            if (!slow && power && before && abs(*power - *before) < T(1) / 2) {
                slow = std::min(*power, *before);
            }
            before = power;
            const T expected(static_cast<int>(j) + 1);
            auto limit = fitting::column_limit(column, s, j, j * h, slow ? std::min(*slow, expected) : expected);
            if (is_a_number(limit.value) && (!best || limit.uncertainty < best->uncertainty)) {
                best = std::move(limit);
            }
        }
    }
    if (!best) {
        return {s.back().value, s.back().value, 0};
    }
    return *std::move(best);
}

/// By least squares with a polynomial of degree p <= 4 in 1/n on the last half of the entries; the chosen degree is the
/// one whose value moves least when the last eighth and the last quarter of the entries are left out, and the last one,
/// two, three. For sequences that oscillate about a power law. At least four entries. O(N).
template <rounding_scalar T>
sequence_limit<T> fitted_limit(const std::vector<sequence_entry<T>>& s) {
    using std::abs;
    constexpr std::size_t most_degree = 4;
    if (s.size() < 4) {
        throw error(error_kind::argument, "number of entries", std::to_string(s.size()),
                    "is below the 4 that a fit needs");
    }
    const std::size_t last = s.size() - 1;
    const std::size_t most = std::min(most_degree, s.size() < 16 ? 0 : s.size() / 8 - 1);
    std::vector<fitting::fitted_polynomial<T>> fits;
    for (const std::size_t less :
         {std::size_t(0), std::size_t(1), std::size_t(2), std::size_t(3), s.size() / 8, s.size() / 4}) {
        const std::size_t end = last - std::min(less, last / 2);
        fits.emplace_back(s, end / 2, end, most);
    }
    std::optional<sequence_limit<T>> best;
    for (std::size_t degree = 0; degree <= most; ++degree) {
        const auto value = fits.front().at_infinity(degree);
        std::optional<T> moved(T(0));
        for (std::size_t i = 1; i < fits.size(); ++i) {
            const auto other = value && moved ? fits[i].at_infinity(degree) : std::nullopt;
            moved = other ? std::optional<T>(abs(*other - *value) > *moved ? T(abs(*other - *value)) : *moved)
                          : std::nullopt;
        }
        if (!moved) {
            break;
        }
        if (is_a_number(*value) && (!best || *moved * 2 < best->uncertainty)) {
            best = sequence_limit<T>{*value, T(*moved * 2), static_cast<int>(degree)};
        }
    }
    if (!best) {
        return {s.back().value, s.back().value, 0};
    }
    return *std::move(best);
}

/// The more certain one of the two.
template <rounding_scalar T>
sequence_limit<T> extrapolated_limit(const std::vector<sequence_entry<T>>& s) {
    auto by_table = neville_limit(s);
    auto by_fit = fitted_limit(s);
    return by_fit.uncertainty < by_table.uncertainty ? std::move(by_fit) : std::move(by_table);
}

}  // namespace libration::convergence
