#include "problem/list_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libration/convergence/radius_answers.hpp"
#include "problem/coefficient_file.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace convergence;

namespace {

// x with the digits that its uncertainty leaves.
cell certain_cell(const mpfr& x, const mpfr& uncertainty, long digits) {
    radius_estimate<mpfr> at;
    at.radius = abs(x);
    at.uncertainty = uncertainty;
    at.position = complex_number<mpfr>{x, mpfr(0)};
    return number_cell(x == 0 ? "0" : printed(at, digits).position_re);
}

}  // namespace

series_list real_list_in(const std::string& file, const std::optional<long>& rounded,
                         const std::optional<std::size_t>& order) {
    auto lists = lists_in_file(file);
    if (lists.size() != 1 || lists.front().is_complex()) {
        throw input_error("--coefficients", file, "holds more than one real list", "write one real list to a file");
    }
    std::vector<exact>& written = lists.front().real;
    if (order && *order + 1 < written.size()) {
        written.resize(*order + 1);
    }
    if (written.empty()) {
        throw input_error("--coefficients", file, "holds no coefficient", "write at least one");
    }
    std::vector<mpfr> values(written.size(), mpfr(0));
    return as_written({series::power_series<mpfr>(std::move(values)), std::move(written), rounded});
}

table table_of_suspect(const list_verdict& verdict, long digits) {
    table data({{"n", ""}, {"predicted", ""}, {"uncertainty", ""}, {"deviation", ""}, {"confirmed", ""}});
    if (verdict.suspect) {
        const auto& suspect = *verdict.suspect;
        data.add_row({suspect.index, certain_cell(suspect.predicted, suspect.uncertainty, std::max(digits, 60L)),
                      decimal_cell(suspect.uncertainty, 3), decimal_cell(mpfr(suspect.deviation), 3),
                      suspect.confirmed ? "yes" : "no"});
    }
    return data;
}

std::string text_of_suspect(const list_verdict& verdict, const table& data) {
    if (!verdict.suspect) {
        return verdict.prediction
                   ? fmt::format(
                         "no coefficient is contradicted by the others; the last one was predicted to 10^{:.0f}\n",
                         *verdict.prediction)
                   : "too few coefficients for an audit\n";
    }
    const auto& row = data.rows().front();
    const std::string remark = verdict.suspect->confirmed
                                   ? "the next three coefficients agree with the predicted value"
                                   : "too few coefficients follow it to confirm the predicted value";
    return fmt::format("coefficient {} is off by {} of itself: the others predict {} +- {}\n{}\n", row[0].text(),
                       row[3].text(), row[1].text(), row[2].text(), remark);
}

table table_of_predictions(const std::vector<predicted_coefficient>& found, long digits) {
    table data({{"n", ""}, {"value", ""}, {"uncertainty", ""}});
    for (const auto& each : found) {
        data.add_row({each.index, certain_cell(each.value, each.uncertainty, std::max(digits, 60L)),
                      decimal_cell(each.uncertainty, 3)});
    }
    return data;
}

}  // namespace libration
