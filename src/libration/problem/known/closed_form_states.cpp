#include "closed_form_states.hpp"

#include <utility>

#include "libration/digits/precision_loop.hpp"

namespace libration {

answer closed_form_states(const std::string& problem, const std::vector<std::string>& quantities,
                          const std::vector<exact>& times, const request& how,
                          const std::function<closed_form_row(const exact& time)>& at) {
    if (how.integrator != ode::integrator_choice::automatic) {
        const char* const name = how.integrator == ode::integrator_choice::taylor       ? "taylor"
                                 : how.integrator == ode::integrator_choice::comparison ? "comparison"
                                                                                        : "collocation";
        throw error(error_kind::argument, error_subject::integrator, name,
                    "is not used by the closed form of " + problem + ": use automatic, or solve with general = true");
    }
    answer result{.names = quantities, .rows = {}, .rigour = "proved"};
    for (const exact& time : times) {
        closed_form_row found;
        const auto undecided = undecided_in([&] { found = at(time); });
        result.rows.push_back(std::move(found.values));
        const auto ended = undecided_in([&] {
            if (how.progress) {
                how.progress(static_cast<double>(result.rows.size()) / static_cast<double>(times.size()));
            }
        });
        for (const auto& reason : {found.missing, undecided, ended}) {
            result.missing = reason ? reason : result.missing;
        }
        if (ended) {
            break;
        }
    }
    result.rows.resize(times.size());
    return result;
}

}  // namespace libration
