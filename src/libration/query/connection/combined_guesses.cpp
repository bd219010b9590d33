#include "combined_guesses.hpp"

#include <algorithm>
#include <utility>

#include "first_guesses.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t few_values = 7;

}  // namespace

std::vector<std::vector<double>> combined_guesses(const connection_map& map, const connection_question& question) {
    std::vector<double> given = nearest_doubles(map.open().values);
    given.resize(map.numbers() + map.coordinates(), 1);
    std::vector<std::vector<double>> all{given};
    if (map.coordinates() == 1) {
        all.push_back(given);
        all.back().back() = -1;
    }
    for (std::size_t i = 0; i < question.unknowns.size(); ++i) {
        if (std::ranges::find(question.open, question.unknowns[i]) == question.open.end()) {
            continue;
        }
        std::vector<std::vector<double>> more;
        auto values = signed_first_guesses();
        if (question.open.size() > 1) {
            values.resize(few_values);
        }
        for (const auto& before : all) {
            for (const double value : values) {
                more.push_back(before);
                more.back()[i] = value;
            }
        }
        all = std::move(more);
    }
    return all;
}

}  // namespace libration::ode
