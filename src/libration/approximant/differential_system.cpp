#include "differential_system.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace libration {

namespace {

// The factor by which D multiplies x^n.
mpfr factor_of(const differential_track& track, int n) { return mpfr(track.stride * n + track.first) / track.stride; }

}  // namespace

coefficient_of_equation coefficient_of(const differential_relation& relation, std::span<const mpfr> a, int m) {
    coefficient_of_equation at{mpfr(0), mpfr(0)};
    for (std::size_t k = 0; k < relation.q.size(); ++k) {
        for (std::size_t j = 0; j < relation.q[k].size() && static_cast<int>(j) <= m; ++j) {
            const int n = m - static_cast<int>(j);
            const mpfr term = relation.q[k][j] * pow(factor_of(relation.track, n), static_cast<int>(k)) *
                              a[static_cast<std::size_t>(n)];
            at.value += term;
            at.largest = std::max(at.largest, mpfr(abs(term)));
        }
    }
    return at;
}

mpfr next_by(const differential_relation& relation, std::span<const mpfr> a, int m) {
    mpfr sum(0);
    mpfr factor(0);
    const mpfr power = factor_of(relation.track, m);
    for (int k = static_cast<int>(relation.q.size()) - 1; k >= 0; --k) {
        const auto& q = relation.q[static_cast<std::size_t>(k)];
        factor = factor * power + (q.empty() ? mpfr(0) : q.front());
        for (std::size_t j = 1; j < q.size() && static_cast<int>(j) <= m; ++j) {
            const int n = m - static_cast<int>(j);
            if (q[j] != 0) {
                sum -= q[j] * pow(factor_of(relation.track, n), k) * a[static_cast<std::size_t>(n)];
            }
        }
    }
    return sum / factor;
}

differential_system::differential_system(std::span<const mpfr> a, const differential_track& track, int last)
    : track_(track), a_(a), terms_(static_cast<std::size_t>(track.order) + 1), threshold_(digits<mpfr>() * 4L / 5) {
    const int whole = std::max(1, static_cast<int>(a.size()) - 1);
    for (int n = 0; n <= last; ++n) {
        mpfr value = narrow<mpfr>(a[static_cast<std::size_t>(n)]);
        const mpfr ratio = factor_of(track, n) / whole;
        for (auto& of_power : terms_) {
            of_power.push_back(value);
            value *= ratio;
        }
    }
    order_unknowns(last - track.degree);
    reduced_.reserve(columns_.size() * width());
}

// By degree; Q_M, whose first coefficient is 1, is the longest.
void differential_system::order_unknowns(int count) {
    const int top = track_.order;
    const auto key = [&](const unknown& u) {
        return u.power < top ? 2 * u.shift : 2 * u.shift - 1 - 2 * track_.offset;
    };
    std::vector<unknown> all;
    for (int j = 0; j <= count + track_.offset; ++j) {
        for (int k = track_.lowest; k <= top; ++k) {
            if (k < top || j > 0) {
                all.push_back({k, j, 0});
            }
        }
    }
    std::ranges::stable_sort(all, [&](const unknown& x, const unknown& y) {
        return std::pair(key(x), x.power) < std::pair(key(y), y.power);
    });
    all.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        all[static_cast<std::size_t>(i)].index = i;
    }
    columns_ = std::move(all);
}

differential_system::equation differential_system::written(int m) const {
    equation row;
    row.entries.reserve(width());
    row.size = exponent_of_zero;
    for (const unknown& u : columns_) {
        row.entries.push_back(u.shift <= m ? term(u.power, m - u.shift) : mpfr(0));
        if (u.index < unknowns_) {
            row.size = std::max(row.size, binary_exponent(row.entries.back()));
        }
    }
    row.entries.push_back(-term(track_.order, m));
    row.size = std::max(row.size, binary_exponent(row.entries.back()));
    return row;
}

void differential_system::reduce(equation& row) const {
    auto& entries = row.entries;
    const int step = static_cast<int>(width());
    for (std::size_t j = 1; j < width(); ++j) {
        const auto count = static_cast<int>(std::min(j, pivots_));
        if (count > 0) {
            entries[j] -= inner_product(entries.data(), 1, reduced_.data() + j, step, count);
        }
    }
}

bool differential_system::add() {
    ++unknowns_;
    equation row = written(length());
    if (!std::ranges::all_of(row.entries, [](const mpfr& each) { return each == 0; })) {
        reduce(row);
        pending_.push_back(std::move(row));
    }
    for (std::size_t i = 0; i < pending_.size();) {
        equation next = std::move(pending_[i]);
        if (place(next)) {
            pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        } else {
            pending_[i++] = std::move(next);
        }
    }
    return pending_.empty();
}

// Takes the equation as a pivot row if one of its unknowns in use is large enough.
bool differential_system::place(equation& row) {
    std::optional<std::size_t> best;
    long largest = exponent_of_zero;
    for (std::size_t c = pivots_; c < columns_.size(); ++c) {
        const long size = binary_exponent(row.entries[c]);
        if (columns_[c].index < unknowns_ && row.entries[c] != 0 && size > largest) {
            largest = size;
            best = c;
        }
    }
    if (!best || row.size - largest > threshold_) {
        return false;
    }
    add_pivot(std::move(row), *best);
    return true;
}

void differential_system::add_pivot(equation&& row, std::size_t column) {
    const std::size_t at = pivots_;
    std::swap(columns_[at], columns_[column]);
    std::swap(row.entries[at], row.entries[column]);
    for (std::size_t i = 0; i < pivots_; ++i) {
        std::swap(reduced_[i * width() + at], reduced_[i * width() + column]);
    }
    for (std::size_t c = at + 1; c < width(); ++c) {
        row.entries[c] /= row.entries[at];
    }
    for (equation& other : pending_) {
        if (other.entries.empty()) {  // the row that is being placed
            continue;
        }
        std::swap(other.entries[at], other.entries[column]);
        for (std::size_t c = at + 1; c < width(); ++c) {
            other.entries[c] -= other.entries[at] * row.entries[c];
        }
    }
    std::ranges::move(row.entries, std::back_inserter(reduced_));
    ++pivots_;
}

bool differential_system::is_consistent() const {
    return std::ranges::all_of(pending_, [&](const equation& row) {
        return row.entries.back() == 0 || row.size - binary_exponent(row.entries.back()) > threshold_;
    });
}

differential_relation differential_system::relation() const {
    std::vector<mpfr> x(pivots_);
    for (std::size_t i = pivots_; i-- > 0;) {
        const mpfr* const row = reduced_.data() + i * width();
        x[i] = row[width() - 1] - inner_product(row + i + 1, 1, x.data() + i + 1, 1, static_cast<int>(pivots_ - i - 1));
    }
    differential_relation found{track_, false, {}};
    found.q.resize(static_cast<std::size_t>(track_.order) + 1);
    found.q.back().emplace_back(1);
    const mpfr whole(std::max(1, static_cast<int>(a_.size()) - 1));
    for (std::size_t i = 0; i < pivots_; ++i) {
        auto& q = found.q[static_cast<std::size_t>(columns_[i].power)];
        const auto shift = static_cast<std::size_t>(columns_[i].shift);
        if (x[i] != 0) {
            q.resize(std::max(q.size(), shift + 1), mpfr(0));
            q[shift] = x[i] * pow(whole, track_.order - columns_[i].power);
        }
    }
    for (auto& q : found.q) {
        q.resize(std::max<std::size_t>(q.size(), 1), mpfr(0));
    }
    return found;
}

}  // namespace libration
