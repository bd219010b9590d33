#include "orbit_choice.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "../../equation/reversal.hpp"
#include "libration/scalar/error.hpp"
#include "orbit_refinement.hpp"

namespace libration::ode {

namespace {

constexpr double independent_gradient = 1e-6;
constexpr double full_rank = 1e-9;
constexpr int most_steps_to_orbit = 40;
constexpr int most_shorter_steps = 10;

class orbit_choice {
public:
    orbit_choice(const first_order_form& form, const std::vector<first_integral>& integrals, rounded_flow& flow,
                 const std::optional<number>& period, std::vector<int> reversal)
        : form_(form), flow_(flow), typed_period_(period), state_(flow.start()) {
        guess_.conditions.reversal = std::move(reversal);
        for (std::size_t i = 0; i < state_.size(); ++i) {
            if (is_half() && sign(i) < 0) {
                open_rows_.push_back(i);
            } else {
                columns_.push_back(i);
            }
        }
        if (!is_half()) {
            open_rows_ = columns_;
        }
        for (const first_integral& each : integrals) {
            if (!is_half() || is_odd_under(form, each.value, guess_.conditions.reversal)) {
                integrals_.push_back(&each);
            }
        }
    }

    // std::nullopt if Newton's method does not converge, or the family has more integrals.
    std::optional<orbit_guess> result(double period, long bits) {
        guess_.period = period;
        drop_conditions();
        if (!choose_held() || !settle()) {
            return std::nullopt;
        }
        for (const std::size_t i : guess_.conditions.free) {
            guess_.unknowns.push_back(exactly(state_[i]));
        }
        if (guess_.conditions.is_period_free) {
            guess_.unknowns.push_back(exactly(guess_.period));
        }
        Eigen::VectorXd value;
        Eigen::MatrixXd derivative;
        if (!free_.empty() && evaluate(value, &derivative)) {
            const auto typed = guess_.conditions.is_period_free ? std::nullopt : typed_period_;
            refine(guess_, flow_, form_, typed, among_free(derivative), bits);
        }
        return std::move(guess_);
    }

private:
    bool is_half() const { return !guess_.conditions.reversal.empty(); }
    int sign(std::size_t i) const { return guess_.conditions.reversal[i]; }
    double size(std::size_t i) const { return std::max(1.0, std::abs(flow_.start()[i])); }

    // Elimination in the gradients, one integral after the other, the largest entry being the pivot.
    void drop_conditions() {
        std::vector<std::vector<double>> rows;
        auto& chosen = guess_.conditions;
        const auto at = is_half() ? flow_.at(flow_.start(), guess_.period / 2) : std::optional(flow_.start());
        for (const first_integral* each : integrals_) {
            if (!at) {
                break;
            }
            expression_values<double> values(form_.leaves, 0.0);
            for (const double x : *at) {
                values.push_back(x);
            }
            std::vector<double> row;
            double largest = 0;
            for (const std::size_t i : open_rows_) {
                row.push_back(values.of(each->gradient[i]) * size(i));
                largest = std::max(largest, std::abs(row.back()));
            }
            for (std::size_t k = 0; k < rows.size(); ++k) {
                const auto pivot = place_of(open_rows_, chosen.dropped[k]);
                const double factor = row[pivot] / rows[k][pivot];
                for (std::size_t j = 0; j < row.size(); ++j) {
                    row[j] -= factor * rows[k][j];
                }
                row[pivot] = 0;
            }
            const auto pivot = std::ranges::max_element(row, {}, [](double x) { return std::abs(x); });
            if (pivot == row.end() || !(std::abs(*pivot) > independent_gradient * std::max(1e-3, largest))) {
                continue;
            }
            chosen.dropped.push_back(open_rows_[static_cast<std::size_t>(pivot - row.begin())]);
            chosen.integrals.push_back(*each);
            rows.push_back(std::move(row));
        }
        for (const std::size_t i : open_rows_) {
            if (std::ranges::find(chosen.dropped, i) == chosen.dropped.end()) {
                chosen.rows.push_back(i);
            }
        }
    }

    static std::size_t place_of(const std::vector<std::size_t>& list, std::size_t value) {
        return static_cast<std::size_t>(std::ranges::find(list, value) - list.begin());
    }

    // The conditions, and their derivatives by the columns and by the period.
    bool evaluate(Eigen::VectorXd& value, Eigen::MatrixXd* derivative) {
        const double time = is_half() ? guess_.period / 2 : guess_.period;
        const auto end = flow_.at(state_, time);
        if (!end) {
            return false;
        }
        const auto& rows = guess_.conditions.rows;
        value.resize(static_cast<Eigen::Index>(rows.size()));
        for (std::size_t r = 0; r < rows.size(); ++r) {
            value(static_cast<Eigen::Index>(r)) = is_half() ? (*end)[rows[r]] : (*end)[rows[r]] - state_[rows[r]];
        }
        if (derivative == nullptr) {
            return true;
        }
        const auto flow = flow_.derivative(state_, time);
        if (flow.empty()) {
            return false;
        }
        const auto slope = flow_.slopes(*end);
        derivative->resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns_.size() + 1));
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const auto i = static_cast<Eigen::Index>(r);
            for (std::size_t c = 0; c < columns_.size(); ++c) {
                const double unit = !is_half() && rows[r] == columns_[c] ? 1 : 0;
                (*derivative)(i, static_cast<Eigen::Index>(c)) = flow[rows[r]][columns_[c]] - unit;
            }
            (*derivative)(i, static_cast<Eigen::Index>(columns_.size())) = slope[rows[r]] / (is_half() ? 2 : 1);
        }
        return true;
    }

    // The unknowns in the order in which they keep their values; the number of columns means the period.
    std::vector<std::size_t> order_of_held() const {
        std::vector<std::size_t> order;
        if (typed_period_) {
            order.push_back(columns_.size());
        }
        for (const bool zeros : {true, false}) {
            for (const bool unknowns : {true, false}) {
                for (std::size_t c = 0; c < columns_.size(); ++c) {
                    const bool is_unknown = form_.given[columns_[c]].derivative() == 0;
                    if ((flow_.start()[columns_[c]] == 0) == zeros && is_unknown == unknowns) {
                        order.push_back(c);
                    }
                }
            }
        }
        return order;
    }

    bool choose_held() {
        Eigen::VectorXd value;
        Eigen::MatrixXd derivative;
        if (!evaluate(value, &derivative)) {
            return false;
        }
        const auto rank = derivative.rows();
        for (Eigen::Index c = 0; c + 1 < derivative.cols(); ++c) {
            derivative.col(c) *= size(columns_[static_cast<std::size_t>(c)]);
        }
        derivative.col(derivative.cols() - 1) *= guess_.period;
        const Eigen::JacobiSVD<Eigen::MatrixXd> parts(derivative, Eigen::ComputeFullV);
        if (rank > 0 && !(parts.singularValues()(rank - 1) > full_rank * parts.singularValues()(0))) {
            return false;
        }
        const Eigen::MatrixXd kernel = parts.matrixV().rightCols(derivative.cols() - rank);
        const auto count = static_cast<std::size_t>(kernel.cols());
        std::vector<Eigen::RowVectorXd> directions;
        std::vector<std::size_t> held;
        for (const double least : {3e-4, 1e-5}) {
            for (const std::size_t c : order_of_held()) {
                if (held.size() == count || std::ranges::find(held, c) != held.end()) {
                    continue;
                }
                Eigen::RowVectorXd rest = kernel.row(static_cast<Eigen::Index>(c));
                for (const auto& each : directions) {
                    rest -= rest.dot(each) * each;
                }
                if (rest.norm() > least) {
                    directions.push_back(rest / rest.norm());
                    held.push_back(c);
                }
            }
        }
        if (held.size() != count) {
            return false;
        }
        auto& chosen = guess_.conditions;
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (std::ranges::find(held, c) == held.end()) {
                chosen.free.push_back(columns_[c]);
                free_.push_back(static_cast<Eigen::Index>(c));
            }
        }
        chosen.is_period_free = std::ranges::find(held, columns_.size()) == held.end();
        if (chosen.is_period_free) {
            free_.push_back(static_cast<Eigen::Index>(columns_.size()));
        } else if (typed_period_) {
            guess_.period = constant_value<double>::of(*typed_period_);
        }
        return true;
    }

    Eigen::MatrixXd among_free(const Eigen::MatrixXd& derivative) const {
        Eigen::MatrixXd square(derivative.rows(), static_cast<Eigen::Index>(free_.size()));
        for (std::size_t c = 0; c < free_.size(); ++c) {
            square.col(static_cast<Eigen::Index>(c)) = derivative.col(free_[c]);
        }
        return square;
    }

    void move(const Eigen::VectorXd& step, double part) {
        for (std::size_t k = 0; k < guess_.conditions.free.size(); ++k) {
            state_[guess_.conditions.free[k]] -= part * step(static_cast<Eigen::Index>(k));
        }
        if (guess_.conditions.is_period_free) {
            guess_.period -= part * step(step.size() - 1);
        }
    }

    // Newton's method, with shorter steps while the conditions grow, until they no longer become smaller.
    bool settle() {
        const double guessed = guess_.period;
        Eigen::VectorXd value;
        Eigen::MatrixXd derivative;
        if (free_.empty()) {
            return true;
        }
        double before = HUGE_VAL;
        for (int k = 0; k < most_steps_to_orbit; ++k) {
            if (!evaluate(value, &derivative)) {
                return false;
            }
            const double now = value.norm();
            if (now < 1e-9 && !(now < before / 4)) {
                return true;
            }
            before = now;
            const Eigen::VectorXd step = among_free(derivative).colPivHouseholderQr().solve(value);
            const auto kept_state = state_;
            const double kept_period = guess_.period;
            double part = 1;
            for (int h = 0; h < most_shorter_steps; ++h, part /= 2) {
                state_ = kept_state;
                guess_.period = kept_period;
                move(step, part);
                const bool near = guess_.period < 1.5 * guessed && guessed < 1.5 * guess_.period;
                if (near && evaluate(value, nullptr) && (value.norm() < now || now < 1e-8)) {
                    break;
                }
            }
            if (!step.allFinite()) {
                return false;
            }
        }
        return before < 1e-6;
    }

    const first_order_form& form_;
    rounded_flow& flow_;
    const std::optional<number>& typed_period_;
    std::vector<double> state_;
    std::vector<std::size_t> columns_;    // the components that may be unknown
    std::vector<std::size_t> open_rows_;  // the conditions
    std::vector<const first_integral*> integrals_;
    std::vector<Eigen::Index> free_;  // among the columns
    orbit_guess guess_;
};

}  // namespace

orbit_guess guessed_orbit(const explicit_system& system, const first_order_form& form,
                          const std::vector<first_integral>& integrals, const std::optional<number>& period,
                          long bits) {
    rounded_flow flow(system);
    const near_return nearest = guessed_return(flow, period);
    for (const auto& reversal : {reversal_of(form), std::vector<int>()}) {
        if (auto found = orbit_choice(form, integrals, flow, period, reversal).result(nearest.time, bits)) {
            return *std::move(found);
        }
    }
    throw error(error_kind::undecided, error_subject::solution, "",
                "is not found: Newton's method does not converge from the return " + described_return(nearest) +
                    ": choose initial values nearer to a periodic orbit");
}

}  // namespace libration::ode
