#include "libration/convergence/sum_vote.hpp"

#include <algorithm>

namespace libration::convergence {

namespace {

constexpr int steps_of_density = 4;
constexpr int steps_of_member = 12;
constexpr int blunter = 10;
constexpr std::size_t most_sharp = 12;

mpfr log_density(std::span<const stepped_value> values, const mpfr& at, const mpfr& scale) {
    mpfr sum(0);
    for (const stepped_value& each : values) {
        const mpfr width = each.step * steps_of_density;
        const mpfr apart = (at - each.value) / width;
        const mpfr square = apart * apart + 1;
        sum += log(mpfr((scale / width * 7 / (square * sqrt(square)) + 3) / 10));
    }
    return sum;
}

struct weighted {
    mpfr value, weight;
};

// The value below which `part`/4 of the weight is.
mpfr weighted_quantile(std::vector<weighted> all, int part) {
    std::ranges::sort(all, [](const auto& x, const auto& y) { return x.value < y.value; });
    mpfr total(0);
    for (const weighted& each : all) {
        total += each.weight;
    }
    mpfr below(0);
    for (const weighted& each : all) {
        below += each.weight;
        if (below * 4 >= total * part) {
            return each.value;
        }
    }
    return all.back().value;
}

}  // namespace

std::optional<vote_result> vote_on(std::span<const stepped_value> values, const mpfr& scale) {
    if (values.empty()) {
        return std::nullopt;
    }
    std::size_t leader = 0;
    std::optional<mpfr> highest;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const mpfr density = log_density(values, values[i].value, scale);
        if (!highest || density > *highest) {
            highest = density;
            leader = i;
        }
    }
    vote_result result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (abs(mpfr(values[i].value - values[leader].value)) <= values[i].step * steps_of_member) {
            result.members.push_back(i);
        }
    }
    std::vector<std::size_t> sharp = result.members;
    std::ranges::sort(sharp, [&](std::size_t i, std::size_t j) { return values[i].step < values[j].step; });
    const mpfr bluntest = values[sharp[std::min<std::size_t>(sharp.size() - 1, 2)]].step * blunter;
    std::erase_if(sharp, [&](std::size_t i) { return values[i].step > bluntest; });
    sharp.resize(std::min(sharp.size(), most_sharp));
    std::vector<weighted> of_values;
    for (const std::size_t i : sharp) {
        of_values.push_back({values[i].value, mpfr(1 / values[i].step)});
    }
    result.value = weighted_quantile(of_values, 2);
    for (weighted& each : of_values) {
        each.value = abs(mpfr(each.value - result.value));
    }
    result.spread = weighted_quantile(std::move(of_values), 3);
    result.step = values[sharp[sharp.size() / 2]].step;
    return result;
}

}  // namespace libration::convergence
