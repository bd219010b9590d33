#include "point_options.hpp"

#include "complex_times.hpp"
#include "text/input_error.hpp"

namespace libration {

void point_options::add_to(CLI::App& command) {
    command.add_option("--at", at_, "top, bottom, start or a time (T/8, 1.1); of a problem a time, also complex: 1+2i")
        ->type_name("POINT");
    command.add_option("--via", via_, "corners of the path to --at of a problem in the complex plane: 1+i,2+i")
        ->type_name("LIST");
}

void point_options::complete(series_request& request, const chosen_solution& chosen) const {
    request.about = at_.value_or(chosen.usual_point);
    request.corners = corners_of(via_);
    if (at_) {
        const std::string remedy = "write " + chosen.of->form_of_points();
        if (at_->empty()) {
            throw input_error("--at", *at_, "is not a point", remedy);
        }
        reading("--at", *at_, remedy, [&] { chosen.of->require_point(*at_); });
    }
}

void point_options::refuse_path(const error& problem) const {
    throw input_error(via_ ? "--at with --via" : "--at", *at_, problem.reason(),
                      "choose a point nearer to the initial point, or a path around the singularity, --via "
                      "\"1+i,2+i\"");
}

}  // namespace libration
