#include "closed_form_states.hpp"

#include <utility>

namespace libration {

namespace {

// Calls the progress callback after the last row. False if it ends the work.
bool continues(const request& how, answer& result, std::size_t times) {
    try {
        if (how.progress) {
            how.progress(static_cast<double>(result.rows.size()) / static_cast<double>(times));
        }
        return true;
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        result.missing = problem;
        return false;
    }
}

}  // namespace

answer closed_form_states(const std::string& problem, const std::vector<std::string>& quantities,
                          const std::vector<exact>& times, const request& how,
                          const std::function<closed_form_row(const exact& time)>& at) {
    if (how.integrator != ode::integrator_choice::automatic) {
        throw error(error_kind::argument, "integrator",
                    how.integrator == ode::integrator_choice::taylor ? "taylor" : "collocation",
                    "is not used by the closed form of " + problem + ": use automatic, or solve with general = true");
    }
    answer result{.names = quantities, .rows = {}, .rigour = "proved"};
    for (const exact& time : times) {
        auto& row = result.rows.emplace_back();
        try {
            closed_form_row found = at(time);
            row = std::move(found.values);
            if (found.missing) {
                result.missing = std::move(found.missing);
            }
        } catch (const error& reason) {
            if (reason.kind() != error_kind::undecided) {
                throw;
            }
            result.missing = reason;
        }
        if (!continues(how, result, times.size())) {
            break;
        }
    }
    result.rows.resize(times.size());
    return result;
}

}  // namespace libration
