#include "plot/singularity_plot.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "text/members.hpp"

namespace libration {

figure_content singularity_plot(const table& found, const std::string& initial_point, const std::string& problem) {
    static constexpr std::array<std::string_view, 6> drawn{"position_re", "position_im", "modulus",
                                                           "kind",        "rigour",      "unknown"};
    const auto names = members_of(found.columns(), &column::name);
    std::vector<std::size_t> places;
    for (const std::string_view name : drawn) {
        places.push_back(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()));
    }
    return {"singularity_plot",
            {{"positions.csv", to_csv(found.with_columns(places))}},
            {{"problem", heading_in_figure(problem)}, {"initial_point", initial_point}}};
}

}  // namespace libration
