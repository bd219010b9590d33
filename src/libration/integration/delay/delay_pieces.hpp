// The pieces of a solution with delays, and where the delayed values are in them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

#include "delayed_value.hpp"
#include "libration/equation/breaking_points.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/delay_system.hpp"

namespace libration::ode {

// Those that later pieces need, and the present one, which is the last.
template <field R>
class delay_pieces {
public:
    explicit delay_pieces(const delay_system& system)
        : delays_(system.delays()), points_(system.point(), delays_), sources_(delays_.size()) {
        begin();
    }

    const number& begins() const { return pieces_.back().begins; }
    const number& ends() { return points_[number_ + 1]; }
    const std::vector<delay_step<R>>& steps() const { return pieces_.back().steps; }
    // Whether it is the first piece.
    bool is_first() const { return number_ == 0; }
    // The number of delays, from the shortest on, by which earlier values are those of the solution.
    std::size_t passed() const { return passed_; }

    void add(delay_step<R> step) { pieces_.back().steps.push_back(std::move(step)); }

    void begin_next() {
        ++number_;
        begin();
    }

    // The solution from the time at this distance from the beginning of the piece on.
    delayed_view<R> view(const R& distance) const { return {pieces_.back(), distance}; }
    // The same earlier by a delay that has passed.
    delayed_view<R> view(std::size_t delay, const R& distance) const {
        const source& from = sources_[delay];
        return {pieces_[from.piece - first_], R(from.offset + distance)};
    }

private:
    // The time earlier by a delay than the beginning of the present piece: the number of its piece, and the distance from
    // the beginning of that.
    struct source {
        std::size_t piece = 0;
        R offset = R(0);
    };

    void begin() {
        const number now = points_[number_];
        pieces_.push_back({now, {}});
        while (passed_ < delays_.size() && (now - delays_[passed_] - points_[0]).sign() >= 0) {
            ++passed_;
        }
        std::size_t oldest = passed_ < delays_.size() ? 0 : number_;
        for (std::size_t j = 0; j < passed_; ++j) {
            const number earlier = now - delays_[j];
            source& from = sources_[j];
            while ((earlier - points_[from.piece + 1]).sign() >= 0) {
                ++from.piece;
            }
            from.offset = constant_value<R>::of(earlier - points_[from.piece]);
            oldest = std::min(oldest, from.piece);
        }
        for (; first_ < oldest; ++first_) {
            pieces_.pop_front();
        }
    }

    const std::vector<number>& delays_;
    breaking_points points_;
    std::deque<delay_piece<R>> pieces_;
    std::size_t first_ = 0;   // the number of the first of them, from the initial point
    std::size_t number_ = 0;  // of the present one
    std::size_t passed_ = 0;
    std::vector<source> sources_;  // of each delay
};

}  // namespace libration::ode
