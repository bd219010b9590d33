#include "libration/expansion/step_lanes.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "lane_vectors.hpp"

namespace libration::ode {

namespace {

// The average number of steps in a group from which lanes cost less than single steps.
constexpr std::size_t least_lanes = 3;
constexpr std::size_t most_lanes = 16;

bool has_lanes(const tape_step& step) {
    switch (step.kind) {
        case operation::sum:
        case operation::difference:
        case operation::product:
        case operation::square:
        case operation::quotient:
        case operation::square_root: return true;
        case operation::scaled: return step.has_one_factor();
        case operation::constant:
        case operation::variable:
        case operation::state:
        case operation::raised:
        case operation::by_variable:
        case operation::delayed:
        case operation::slope:
        case operation::power:
        case operation::function:
        case operation::primitive:
        case operation::companion: break;
    }
    return false;
}

std::vector<int> operands_of(const tape_step& step) {
    std::vector<int> operands;
    if (step.kind != operation::state) {  // whose operands are an unknown and a derivative
        std::ranges::copy_if(std::array{step.left, step.right}, std::back_inserter(operands),
                             [](int each) { return each >= 0; });
    }
    return operands;
}

// The depth of each step in the graph of operands; steps of the same depth are independent.
std::vector<int> depths_of(const tape& of) {
    std::vector<int> depths;
    for (const tape_step& step : of.steps()) {
        int depth = step.kind == operation::companion ? depths.back() : step.kind == operation::state ? 0 : 1;
        for (const int operand : operands_of(step)) {
            depth = std::max(depth, depths[static_cast<std::size_t>(operand)] + 1);
        }
        depths.push_back(depth);
    }
    return depths;
}

// The steps by depth and kind, which is -1 for those without lanes; the last ones first.
std::map<std::pair<int, int>, std::vector<int>, std::greater<>> steps_by_depth(const tape& of) {
    std::map<std::pair<int, int>, std::vector<int>, std::greater<>> sorted;
    const std::vector<int> depths = depths_of(of);
    for (std::size_t i = 0; i < of.steps().size(); ++i) {
        const tape_step& step = of.steps()[i];
        if (step.kind != operation::state && step.kind != operation::companion) {
            sorted[{depths[i], has_lanes(step) ? static_cast<int>(step.kind) : -1}].push_back(static_cast<int>(i));
        }
    }
    return sorted;
}

// Steps that can run together, at most most_lanes. Those that are operands of others are in the order in which these
// read them, first all left operands, so that they need not be gathered.
std::vector<std::vector<int>> sorted_steps(const tape& of) {
    std::vector<std::vector<int>> together;
    std::map<int, std::size_t> ranks;
    const auto rank = [&](int step) {
        const auto known = ranks.find(step);
        return std::pair(known == ranks.end() ? of.steps().size() : known->second, step);
    };
    for (auto& [place, steps] : steps_by_depth(of)) {
        std::ranges::sort(steps, {}, rank);
        for (const auto side : {&tape_step::left, &tape_step::right}) {
            for (const int step : steps) {
                ranks.emplace(of.steps()[static_cast<std::size_t>(step)].*side, ranks.size());
            }
        }
        const std::size_t most = place.second < 0 ? 1 : most_lanes;
        for (std::size_t end = steps.size(); end > 0;) {
            const std::size_t first = (end - 1) / most * most;
            together.emplace_back(steps.begin() + static_cast<std::ptrdiff_t>(first),
                                  steps.begin() + static_cast<std::ptrdiff_t>(end));
            end = first;
        }
    }
    std::ranges::reverse(together);
    return together;
}

}  // namespace

// Assigns positions to steps, and determines which operands groups read.
class step_lanes::builder {
public:
    builder(step_lanes& to, const tape& of, double* arrays, std::size_t length, const std::vector<double>& factors)
        : to_(to), of_(of), arrays_(arrays), length_(length), factors_(factors) {}

    void run() {
        const auto together = sorted_steps(of_);
        const auto is_one = [this](const auto& steps) { return is_group(steps); };
        const auto groups = static_cast<std::size_t>(std::ranges::count_if(together, is_one));
        const auto lanes = static_cast<std::size_t>(std::ranges::count_if(of_.steps(), has_lanes));
        if (groups == 0 || lanes < least_lanes * groups) {
            return;
        }
        find_read(together);
        add_states();
        for (const auto& steps : together) {
            if (is_group(steps)) {
                add_group(steps);
            } else {
                for (const int step : steps) {
                    add_alone(step);
                }
            }
        }
        to_.rows_.length = to_.starts_.size();
        to_.rows_.numbers.assign(length_ * to_.rows_.length, 0.0);
    }

private:
    bool is_group(const std::vector<int>& steps) const { return has_lanes(step_at(steps.front())); }

    const tape_step& step_at(int i) const { return of_.steps()[static_cast<std::size_t>(i)]; }
    double* array(int step) const { return arrays_ + static_cast<std::size_t>(step) * length_; }

    // Determines the readers of each value: groups read rows; single steps, unknowns and callers read arrays.
    void find_read(const std::vector<std::vector<int>>& together) {
        in_arrays_.insert(of_.outputs().begin(), of_.outputs().end());
        in_arrays_.insert(of_.watched().begin(), of_.watched().end());
        for (const tape_step& each : of_.steps()) {
            if (each.kind == operation::primitive) {
                in_arrays_.insert(each.derivative);
            }
        }
        for (const auto& steps : together) {
            for (const int step : steps) {
                const auto operands = operands_of(step_at(step));
                (is_group(steps) ? in_rows_ : in_arrays_).insert(operands.begin(), operands.end());
            }
        }
    }

    // Allocates the next free positions for these steps.
    std::size_t new_places(const std::vector<int>& steps) {
        const std::size_t first = to_.starts_.size();
        for (const int step : steps) {
            to_.starts_.push_back({array(step), to_.starts_.size()});
        }
        return first;
    }

    // Pads after them to the width of a vector, with the values of the first step to avoid divisions by 0.
    void pad(int step, std::size_t lanes) {
        for (; lanes % widest_vector != 0; ++lanes) {
            new_places({step});
        }
    }

    void add_states() {
        for (const tape_state& each : of_.states()) {
            if (in_rows_.contains(each.step)) {
                places_[each.step] = new_places({each.step});
                to_.states_.push_back({array(each.step), places_[each.step]});
            }
        }
    }

    void add_alone(int step) {
        if (to_.order_.empty() || !to_.order_.back().alone) {
            to_.order_.push_back({true, to_.alone_.size(), 0, to_.transfers_.size(), 0});
        }
        to_.alone_.push_back(step);
        ++to_.order_.back().count;
        for (int i = step;
             i == step || (i < static_cast<int>(of_.steps().size()) && step_at(i).kind == operation::companion); ++i) {
            if (in_rows_.contains(i)) {
                places_[i] = new_places({i});
                to_.transfers_.push_back({array(i), places_[i]});
                ++to_.order_.back().transfers;
            }
        }
    }

    // The position of contiguous operands, or the one to which they are gathered, with the indices appended.
    std::pair<std::size_t, std::ptrdiff_t> operands(const std::vector<int>& steps) {
        const std::size_t first = places_.at(steps.front());
        bool there = true;
        for (std::size_t lane = 0; lane < steps.size(); ++lane) {
            there = there && places_.at(steps[lane]) == first + lane;
        }
        if (there) {
            return {first, -1};
        }
        const auto indices = static_cast<std::ptrdiff_t>(to_.rows_.indices.size());
        for (std::size_t lane = 0; lane < steps.size() || lane % widest_vector != 0; ++lane) {
            const int step = lane < steps.size() ? steps[lane] : steps.front();
            to_.rows_.indices.push_back(static_cast<std::int64_t>(places_.at(step)));
        }
        const std::size_t place = new_places(steps);
        pad(steps.front(), steps.size());
        return {place, indices};
    }

    void add_group(const std::vector<int>& steps) {
        lane_group made{step_at(steps.front()).kind, steps.size(), 0, 0, 0, -1, -1, to_.rows_.factors.size()};
        std::vector<int> left;
        std::vector<int> right;
        for (const int step : steps) {
            const tape_step& each = step_at(step);
            left.push_back(each.left);
            right.push_back(each.right);
            to_.rows_.factors.push_back(factors_[static_cast<std::size_t>(step)]);
        }
        to_.rows_.factors.resize(made.factors + (steps.size() + widest_vector - 1) / widest_vector * widest_vector,
                                 1.0);
        std::tie(made.left, made.gathered_left) = operands(left);
        made.right = made.left;
        if (right.front() >= 0) {
            std::tie(made.right, made.gathered_right) = operands(right);
        }
        made.result = new_places(steps);
        pad(steps.front(), steps.size());
        if (to_.order_.empty() || to_.order_.back().alone) {
            to_.order_.push_back({false, to_.groups_.size(), 0, to_.transfers_.size(), 0});
        }
        entry& last = to_.order_.back();
        ++last.count;
        for (std::size_t lane = 0; lane < steps.size(); ++lane) {
            places_[steps[lane]] = made.result + lane;
            if (in_arrays_.contains(steps[lane])) {
                to_.transfers_.push_back({array(steps[lane]), made.result + lane});
                ++last.transfers;
            }
        }
        to_.groups_.push_back(made);
    }

    step_lanes& to_;
    const tape& of_;
    double* arrays_;
    std::size_t length_;
    const std::vector<double>& factors_;
    std::set<int> in_rows_;
    std::set<int> in_arrays_;
    std::map<int, std::size_t> places_;
};

step_lanes::step_lanes(const tape& of, double* arrays, std::size_t length, const std::vector<double>& factors) {
    builder(*this, of, arrays, length, factors).run();
}

void step_lanes::begin() {
    double* const row = rows_.row(0);
    for (const transfer& each : starts_) {
        row[each.place] = *each.array;
    }
    for (const lane_group& each : groups_) {
        if (each.kind == operation::square_root) {
            for (std::size_t lane = 0; lane < each.lanes; ++lane) {
                rows_.factors[each.factors + lane] = 2 * row[each.result + lane];
            }
        }
    }
}

void step_lanes::take_states(int n) {
    double* const row = rows_.row(n);
    for (const transfer& each : states_) {
        row[each.place] = each.array[n];
    }
}

void step_lanes::take(const entry& alone, int n) {
    double* const row = rows_.row(n);
    for (std::size_t i = alone.first_transfer; i < alone.first_transfer + alone.transfers; ++i) {
        row[transfers_[i].place] = transfers_[i].array[n];
    }
}

void step_lanes::run(const entry& groups, int n) {
    run_lanes({groups_.data() + groups.first, groups.count}, rows_, n);
    const double* const row = rows_.row(n);
    for (std::size_t i = groups.first_transfer; i < groups.first_transfer + groups.transfers; ++i) {
        transfers_[i].array[n] = row[transfers_[i].place];
    }
}

}  // namespace libration::ode
