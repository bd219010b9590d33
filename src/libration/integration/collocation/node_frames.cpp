#include "node_frames.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "../../algebra/rounded_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"

namespace libration::ode {

namespace {

std::size_t size_of(const moving_frame& of) {
    return std::accumulate(of.blocks.begin(), of.blocks.end(), std::size_t{0});
}

class ball_frames : public node_frames {
public:
    ball_frames(const moving_frame& of, const chebyshev_zeros& at, long bits, long node_bits)
        : of_(of), zeros_(at), bits_(bits), node_bits_(node_bits), size_(size_of(of)) {
        const precision_scope scope(decimal_digits(bits));
        slopes_ = derivatives_of(of.columns);
    }

    node_frame at(int k, const sparse_entries& jacobian) override {
        const bool right = k < zeros_.count() / 2;
        move_to(right ? k : zeros_.count() - 1 - k);
        const std::size_t side = right ? 0 : 1;
        const precision_scope few(decimal_digits(node_bits_));
        node_frame result;
        result.frame = {size_, size_, values_[side]};
        result.inverse = inverse_of_frame({size_, size_, inverses_[side]}, changes_[side], of_.slow);
        result.linear = product(result.inverse, moved(side, jacobian));
        result.unit = product(result.inverse, result.frame);
        for (std::size_t i = 0; i < size_; ++i) {
            result.unit(i, i) -= 1L;
        }
        return result;
    }

private:
    void move_to(int k) {
        if (k == at_) {
            return;
        }
        const precision_scope scope(decimal_digits(bits_));
        values_ = zeros_.values(of_.columns, k, node_bits_);
        value_slopes_ = zeros_.values(slopes_, k, node_bits_);
        inverses_ = zeros_.values(of_.inverse, k, node_bits_);
        changes_ = zeros_.values(of_.change, k, node_bits_);
        at_ = k;
    }
    // J V - V'.
    dense_matrix moved(std::size_t side, const sparse_entries& jacobian) const {
        dense_matrix result(size_, size_);
        for (std::size_t i = 0; i < size_ * size_; ++i) {
            result.entries[i] = -value_slopes_[side][i];
        }
        for (std::size_t place = 0; place < jacobian.values.size(); ++place) {
            const auto [i, m] = jacobian.places[place];
            for (std::size_t j = 0; j < size_; ++j) {
                arb_addmul(result(i, j).handle(), jacobian.values[place].handle(),
                           values_[side][m * size_ + j].handle(), ball::working_bits());
            }
        }
        return result;
    }

    const moving_frame& of_;
    const chebyshev_zeros& zeros_;
    long bits_, node_bits_;
    std::size_t size_;
    std::vector<ball_polynomial> slopes_;
    std::array<std::vector<ball>, 2> values_, value_slopes_, inverses_, changes_;
    int at_ = -1;
};

// The values at all nodes, by rows, of polynomials in powers of x.
rounded_matrix values_at_all(const std::vector<ball_polynomial>& all, const chebyshev_zeros& at, long bits) {
    std::size_t length = 1;
    for (const ball_polynomial& each : all) {
        length = std::max(length, each.size());
    }
    const precision_scope scope(decimal_digits(bits));
    chebyshev_form form(bits);
    std::vector<ball> coefficients;
    for (const ball_polynomial& each : all) {
        auto row = form.coefficients(each);
        row.resize(length, ball(0));
        coefficients.insert(coefficients.end(), row.begin(), row.end());
    }
    const rounded_matrix by(length, static_cast<std::size_t>(at.count()),
                            at.chebyshev_values(static_cast<int>(length) - 1));
    return product(rounded_matrix(all.size(), length, coefficients), by);
}

class rounded_frames : public node_frames {
public:
    rounded_frames(const moving_frame& of, const chebyshev_zeros& at, long bits)
        : size_(size_of(of)), slow_(of.change.empty() ? 0 : of.slow) {
        std::vector<ball_polynomial> columns;
        std::vector<ball> fast;
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = 0; j < size_; ++j) {
                const ball_polynomial& entry = of.columns[i * size_ + j];
                if (j < slow_) {
                    columns.push_back(entry);
                } else {
                    fast.push_back(constant_of(entry));
                }
            }
        }
        fast_ = rounded_matrix(size_, size_ - slow_, fast);
        columns_ = values_at_all(columns, at, bits);
        slopes_ = values_at_all(derivatives_of(columns), at, bits);
        changes_ = values_at_all(of.change, at, bits);
        std::vector<ball> inverse;
        for (const ball_polynomial& each : of.inverse) {
            inverse.push_back(constant_of(each));
        }
        inverse_ = rounded_matrix(size_, size_, inverse);
        inverse_of_fast_ = product(inverse_, fast_);
    }

    node_frame at(int k, const sparse_entries& jacobian) override {
        const rounded_matrix columns = at_node(columns_, k);
        const rounded_matrix change = at_node(changes_, k);
        const auto with_change = [&](rounded_matrix of) {
            const rounded_matrix of_slow = of.part(0, slow_);
            return sum(std::move(of), product(change, of_slow));
        };
        const rounded_matrix frame = beside(columns, fast_);
        rounded_matrix unit = with_change(beside(product(inverse_, columns), inverse_of_fast_));
        node_frame result;
        result.frame = frame.balls();
        result.inverse = with_change(inverse_).balls();
        result.linear = with_change(product(inverse_, moved(frame, at_node(slopes_, k), jacobian))).balls();
        result.unit = unit.balls();
        for (std::size_t i = 0; i < size_; ++i) {
            result.unit(i, i) -= 1L;
        }
        return result;
    }

private:
    static ball constant_of(const ball_polynomial& entry) {
        if (entry.size() > 1) {
            throw std::logic_error("a frame in double has constant fast columns");
        }
        return entry.empty() ? ball(0) : entry.front();
    }
    // Of values with the places i slow + j of entries as rows.
    rounded_matrix at_node(const rounded_matrix& all, int k) const {
        rounded_matrix result(size_, slow_);
        for (std::size_t i = 0; i < size_ * slow_; ++i) {
            result.values[i] = all.values[i * all.columns + static_cast<std::size_t>(k)];
            result.errors[i] = all.errors[i * all.columns + static_cast<std::size_t>(k)];
        }
        return result;
    }
    rounded_matrix beside(const rounded_matrix& slow, const rounded_matrix& fast) const {
        rounded_matrix result(size_, size_);
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = 0; j < size_; ++j) {
                const rounded_matrix& from = j < slow_ ? slow : fast;
                const std::size_t place = i * from.columns + (j < slow_ ? j : j - slow_);
                result.values[i * size_ + j] = from.values[place];
                result.errors[i * size_ + j] = from.errors[place];
            }
        }
        return result;
    }
    // J V - V': sums of a few products, by the error of such a sum in terms of the sum of absolute values.
    rounded_matrix moved(const rounded_matrix& frame, const rounded_matrix& slopes,
                         const sparse_entries& jacobian) const {
        rounded_matrix result(size_, size_);
        std::vector<double> absolute(size_ * size_, 0);
        std::vector<std::size_t> terms(size_, 2);
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = 0; j < slow_; ++j) {
                result.values[i * size_ + j] = -slopes.values[i * slow_ + j];
                result.errors[i * size_ + j] = slopes.errors[i * slow_ + j];
                absolute[i * size_ + j] = std::fabs(slopes.values[i * slow_ + j]);
            }
        }
        const rounded_matrix entries(1, jacobian.values.size(), jacobian.values);
        for (std::size_t place = 0; place < jacobian.values.size(); ++place) {
            const auto [i, m] = jacobian.places[place];
            ++terms[i];
            const double factor = entries.values[place];
            const double error = entries.errors[place];
            for (std::size_t j = 0; j < size_; ++j) {
                const double value = frame.values[m * size_ + j];
                const double more = frame.errors[m * size_ + j];
                result.values[i * size_ + j] += factor * value;
                absolute[i * size_ + j] += std::fabs(factor * value);
                result.errors[i * size_ + j] += std::fabs(factor) * more + error * (std::fabs(value) + more);
            }
        }
        for (std::size_t i = 0; i < size_; ++i) {
            const double relative = static_cast<double>(terms[i]) * 0x1.001p-53;
            for (std::size_t j = 0; j < size_; ++j) {
                double& error = result.errors[i * size_ + j];
                error = upper_bound_of_sum(error + relative * upper_bound_of_sum(absolute[i * size_ + j]));
            }
        }
        return result;
    }

    std::size_t size_;
    std::size_t slow_;  ///< the number of columns that move
    rounded_matrix fast_, columns_, slopes_, changes_, inverse_, inverse_of_fast_;
};

}  // namespace

std::unique_ptr<node_frames> frames_in_balls(const moving_frame& of, const chebyshev_zeros& at, long bits,
                                             long node_bits) {
    return std::make_unique<ball_frames>(of, at, bits, node_bits);
}

std::unique_ptr<node_frames> frames_in_double(const moving_frame& of, const chebyshev_zeros& at, long bits) {
    return std::make_unique<rounded_frames>(of, at, bits);
}

}  // namespace libration::ode
