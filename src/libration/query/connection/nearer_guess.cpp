#include "nearer_guess.hpp"

#include <algorithm>
#include <cmath>

#include "candidate.hpp"

namespace libration::ode {

namespace {

constexpr int most_simplex_steps = 120;
constexpr double part_of_simplex = 0.15;
constexpr double least_of_simplex = 0.1;
constexpr double near_enough_for_newton = 1e-3;

struct simplex_corner {
    std::vector<double> at;
    double size;
};

class approach_search {
public:
    approach_search(const connection_map& map, std::vector<double> numbers) : map_(map), first_(std::move(numbers)) {}

    std::vector<double> result() {
        const std::size_t n = map_.numbers();
        std::vector<simplex_corner> corners{
            corner(std::vector<double>(first_.begin(), first_.begin() + static_cast<std::ptrdiff_t>(n)))};
        for (std::size_t i = 0; i < n; ++i) {
            auto at = corners.front().at;
            at[i] += part_of_simplex * std::max(std::fabs(at[i]), least_of_simplex);
            corners.push_back(corner(at));
        }
        for (int k = 0; k < most_simplex_steps; ++k) {
            std::ranges::stable_sort(corners, {}, &simplex_corner::size);
            if (corners.front().size < std::log(near_enough_for_newton)) {
                break;
            }
            step(corners);
        }
        const auto& best = *std::ranges::min_element(corners, {}, &simplex_corner::size);
        auto found = first_;
        std::ranges::copy(best.at, found.begin());
        return found;
    }

private:
    simplex_corner corner(const std::vector<double>& at) const {
        auto whole = first_;
        std::ranges::copy(at, whole.begin());
        whole.resize(std::max(whole.size(), map_.size()));
        const auto approach = approach_from(map_, whole);
        return {at, approach ? std::log(approach->distance) : INFINITY};
    }

    // Reflection of the last corner, expansion, contraction, or a smaller
    // simplex.
    void step(std::vector<simplex_corner>& corners) const {
        const std::size_t n = corners.size() - 1;
        std::vector<double> centre(n, 0);
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t i = 0; i < n; ++i) {
                centre[i] += corners[j].at[i] / static_cast<double>(n);
            }
        }
        simplex_corner& last = corners.back();
        const auto moved = [&](double by) {
            auto at = centre;
            for (std::size_t i = 0; i < n; ++i) {
                at[i] += by * (centre[i] - last.at[i]);
            }
            return corner(at);
        };
        const auto reflected = moved(1);
        if (reflected.size < corners.front().size) {
            const auto expanded = moved(2);
            last = expanded.size < reflected.size ? expanded : reflected;
        } else if (reflected.size < corners[n - 1].size) {
            last = reflected;
        } else {
            const auto contracted = reflected.size < last.size ? moved(0.5) : moved(-0.5);
            if (contracted.size < std::min(last.size, reflected.size)) {
                last = contracted;
                return;
            }
            for (std::size_t j = 1; j <= n; ++j) {
                auto at = corners[j].at;
                for (std::size_t i = 0; i < n; ++i) {
                    at[i] = (at[i] + corners.front().at[i]) / 2;
                }
                corners[j] = corner(at);
            }
        }
    }

    const connection_map& map_;
    std::vector<double> first_;
};

}  // namespace

std::vector<double> nearer_guess(const connection_map& map, const std::vector<double>& numbers) {
    return approach_search(map, numbers).result();
}

}  // namespace libration::ode
