// The study error_norm of a problem with conditions at infinity: the asymptotic approximants with the proved approach,
// compared with the series and its Pade approximants.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "norms_at_infinity.hpp"
#include "printed_norm.hpp"

namespace libration::studies::error_norm_study::at_infinity {

namespace far_norms = approximant_norms;

inline constexpr long digits_of_axis = 20;

inline const column_list<norm_row>& columns_at_infinity() {
    static const auto all = with_meanings(
        columns_of_equation(),
        {{"method",
          "series | pade: [N - m, m] with the largest m <= N/2 that there is | asymptotic: with the proved "
          "approach to the limit"},
         {"rigour",
          "two-method: the solution is proved, or integrated from proved initial values, and approximants of "
          "two precisions agree | heuristic | not decided: not distinguished from 0"}});
    return all;
}

inline norm_row row_of(const question& asked, const far_norms::judged_norm& found, const mpfr& start) {
    norm_row row{
        .order = found.of.order, .method = found.of.method, .scalar = asked.scalar, .unknown = found.of.unknown};
    if (!found.of.found) {
        return row;
    }
    row.rigour = found.digits == 0 ? "not decided" : found.agreed ? "two-method" : "heuristic";
    if (found.digits > 0) {
        row.norm = decimal_cell(found.of.found->norm, found.digits);
        row.time = decimal_cell(mpfr(start + found.of.found->place), far_norms::norm_digits);
        row.log10_norm = log10_cell(found.of.found->norm);
    }
    return row;
}

inline table rows_at(const question& asked, std::size_t i, const std::vector<int>& orders) {
    const long digits = asked.scalar.digits + far_norms::norm_digits;
    const precision_scope scope(digits + digits_of_axis);
    const far_norms::solution_at_infinity solution(asked.sweep->at_infinity(i), asked.typed_times, orders.back(),
                                                   digits);
    const mpfr start = ode::constant_value<mpfr>::of(solution.solved.far.system.point());
    std::vector<norm_row> rows;
    for (const auto& each : far_norms::judged_norms(solution, orders, digits)) {
        rows.push_back(row_of(asked, each, start));
    }
    return make_table(columns_at_infinity(), rows);
}

inline study_plan plan(const study_request& request) {
    const question asked{equation_sweep_of(request), times_of(request, 0), request.values.of("time"),
                         request.scalar.value_or(read_scalar("mpfr:20"))};
    if (!request.further_scalars.empty()) {
        throw input_error("--scalar", asked.scalar.name() + "," + request.further_scalars.front().name(),
                          "is a list, and with conditions at infinity this study takes one arithmetic at a time",
                          "write " + asked.scalar.name());
    }
    if (asked.scalar.kind != scalar_kind::arbitrary) {
        throw input_error("--scalar", asked.scalar.name(), "has no asymptotic approximants",
                          fmt::format("use mpfr:{}", asked.scalar.digits));
    }
    if (!request.values.of("unknown").empty()) {
        throw input_error(
            "--unknowns is not supported with conditions at infinity: leave it out; the unknown is that of "
            "the first condition");
    }
    const auto orders = orders_from(request, 1, "is not an order of an approximant");
    return plan_by_numbers({head_of(*asked.sweep, "", asked.scalar, columns_at_infinity())}, asked.sweep, "order",
                           orders, [asked](std::size_t i, const std::vector<int>& chosen) {
                               return std::vector<table>{rows_at(asked, i, chosen)};
                           });
}

// The rows of the asymptotic approximants of one combination of the axes.
struct norms_by_order {
    std::string heading;
    std::vector<std::pair<std::string, double>> norms;  // the order, and log10 of the norm, -inf if not told from 0
};

inline std::string remark_on(const norms_by_order& of) {
    constexpr double growth = 0.04;  // of log10 of a norm
    const auto best = std::ranges::min_element(of.norms, {}, &std::pair<std::string, double>::second);
    const auto number = [](double log10_norm) {
        return std::isfinite(log10_norm) ? to_decimal(mpfr(pow(mpfr(10), mpfr(log10_norm))), 2)
                                         : std::string("0 as far as its digits show");
    };
    std::string text = fmt::format("asymptotic{}: of these orders N = {} is the best, with the norm {}", of.heading,
                                   best->first, number(best->second));
    if (of.norms.back().second > best->second + growth) {
        text += fmt::format("; warning: beyond it the norms grow, to {} at N = {}: more terms do not help",
                            number(of.norms.back().second), of.norms.back().first);
    }
    return text;
}

inline std::vector<std::string> remarks(const std::vector<study_table>& tables) {
    const table& all = tables.front().data;
    static const std::vector<std::string> own{"order", "norm", "time_of_maximum", "scalar", "rigour", "log10_norm"};
    std::vector<norms_by_order> found;
    for (const table_row_cells& row : all.rows()) {
        std::string heading, order, method, log10_norm, rigour;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string& name = all.columns()[i].name;
            const std::string text = row[i].text();
            std::string* const kept = name == "order"        ? &order
                                      : name == "method"     ? &method
                                      : name == "log10_norm" ? &log10_norm
                                      : name == "rigour"     ? &rigour
                                                             : nullptr;
            if (kept != nullptr) {
                *kept = text;
            } else if (std::ranges::find(own, name) == own.end() && !text.empty()) {
                heading += fmt::format(", {} {}", name, text);
            }
        }
        if (method != "asymptotic" || rigour.empty()) {
            continue;
        }
        if (found.empty() || found.back().heading != heading) {
            found.push_back({heading, {}});
        }
        found.back().norms.emplace_back(
            order, log10_norm.empty() ? -std::numeric_limits<double>::infinity() : std::stod(log10_norm));
    }
    const precision_scope scope(digits_of_axis);
    std::vector<std::string> lines;
    std::ranges::transform(found, std::back_inserter(lines), remark_on);
    return lines;
}

}  // namespace libration::studies::error_norm_study::at_infinity
