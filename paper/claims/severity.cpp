#include "severity.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace libration {

namespace {

constexpr std::array<std::string_view, 10> formulas{
    "separatrix_formula", "libration_formula",  "rotation_formula", "omegab_libration",
    "omegab_rate",        "exact_resummation",  "b_constants",      "resummation_counterclockwise",
    "appendix_sigma",     "appendix_alpha_beta"};

constexpr std::array<std::string_view, 25> statements{"rotation_halves",
                                                      "shifts_reach_all_states",
                                                      "arcsine_is_required",
                                                      "elliptic_route_costs_more",
                                                      "ratio_test_estimates_radius",
                                                      "one_figure_for_libration",
                                                      "top_is_the_best_point",
                                                      "bottom_radius_of_libration",
                                                      "bottom_radius_of_rotation",
                                                      "error_grows_towards_separatrix",
                                                      "error_monotone",
                                                      "second_derivative",
                                                      "numerical_baseline",
                                                      "degree_for_degree",
                                                      "Knew_limit",
                                                      "Knew_rapid",
                                                      "figure_period_drift",
                                                      "period_analyticity",
                                                      "optimal_at_top",
                                                      "better_at_every_truncation",
                                                      "domb_sykes",
                                                      "approximants_continue",
                                                      "appendix_conditions",
                                                      "appendix_second_product",
                                                      "appendix_range"};

constexpr std::array<std::string_view, 15> wordings{"one_series_for_all_time",
                                                    "abstract_uniform_acceleration",
                                                    "better_at_every_time",
                                                    "uniform_rotation_limit",
                                                    "one_initial_condition",
                                                    "series_labels",
                                                    "figure_series_orders",
                                                    "figure_rotation_orders",
                                                    "figure_near_separatrix_orders",
                                                    "unaffected_by_singularities",
                                                    "remainder_of_time",
                                                    "negative_times",
                                                    "origin_shift",
                                                    "acceleration_rate",
                                                    "Kold_domain"};

}  // namespace

std::string name_of(severity s) {
    switch (s) {
        case severity::formula: return "formula";
        case severity::statement: return "statement";
        case severity::wording: break;
    }
    return "wording";
}

std::optional<severity> severity_of(const std::string& claim) {
    const auto is_in = [&](const auto& names) { return std::ranges::find(names, claim) != names.end(); };
    if (is_in(formulas)) {
        return severity::formula;
    }
    if (is_in(statements)) {
        return severity::statement;
    }
    return is_in(wordings) ? std::optional(severity::wording) : std::nullopt;
}

}  // namespace libration
