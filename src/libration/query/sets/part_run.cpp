#include "part_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

magnitude width_of(const closed_interval& of) { return magnitude(of.upper - of.lower); }

// Whether it is complete, and no value that is not monotone has an excess.
bool is_sharp(const set_query& question, const set_run_result& run, const number_box& part, bool with_derivatives) {
    if (!run.complete || !with_derivatives) {
        return run.complete;
    }
    for (std::size_t i = 0; i < run.images.size(); ++i) {
        for (std::size_t k = 0; question.is_narrowed(i) && k < run.images[i]->values.size(); ++k) {
            const set_image& here = *run.images[i];
            if (has_width(here.values[k]) && !is_monotone(here.derivatives[k]) &&
                excess_of(here, k, part, here.values[k]) > negligible_excess) {
                return false;
            }
        }
    }
    return true;
}

// By the values at times of a run that is complete.
void narrow_by(const set_run_result& times, set_run_result& run) {
    for (std::size_t i = 0; i < run.images.size(); ++i) {
        for (std::size_t k = 0; times.images[i] && k < run.images[i]->values.size(); ++k) {
            narrow(run.images[i]->values[k], times.images[i]->values[k]);
        }
    }
}

}  // namespace

set_run_result best_run(const set_query& question, const number_box& part, bool with_derivatives) {
    const auto sharp = [&](const set_run_result& of) { return is_sharp(question, of, part, with_derivatives); };
    set_run_result linear = question.enclosed_at_times(part, with_derivatives);
    const bool is_linear = sharp(linear);
    long steps = linear.steps;
    if (!is_linear || (question.has_spans() && is_wide(part))) {
        const ball start = constant_value<ball>::of(question.problem().system().point());
        const auto distance = [&](const set_run_result& of) { return magnitude(of.reached - start); };
        auto models = question.enclosed_by_models(part, with_derivatives);
        steps += models ? models->steps : 0;
        if (models && (models->complete ? !is_linear || sharp(*models)
                                        : !linear.complete && distance(linear) < distance(*models))) {
            if (linear.complete) {
                narrow_by(linear, *models);
            }
            models->steps = steps;
            return *std::move(models);
        }
    }
    if (question.has_spans()) {
        linear = question.enclosed_from(part, with_derivatives);
        steps += linear.steps;
    }
    linear.steps = steps;
    return linear;
}

double excess_of(const set_image& image, std::size_t value, const number_box& part, const closed_interval& range) {
    const double whole = log_of(width_of(range));
    if (!image.excess.empty()) {
        return std::exp2(log_of(image.excess[value].width) - whole);
    }
    magnitude linear;
    for (std::size_t j = 0; j < part.size(); ++j) {
        linear.add_product(magnitude::midpoint_of(image.derivatives[value][j]), radius_of(part[j]));
    }
    return std::exp2(log_of(width_of(image.values[value])) - whole) - std::exp2(log_of(linear) + 1 - whole);
}

int direction_of(const ball& derivative) {
    if (arb_is_zero(derivative.handle()) != 0) {
        return 2;
    }
    return arb_is_nonnegative(derivative.handle()) != 0 ? 1 : arb_is_nonpositive(derivative.handle()) != 0 ? -1 : 0;
}

bool is_monotone(const std::vector<ball>& derivatives) {
    return std::ranges::all_of(derivatives, [](const ball& each) { return direction_of(each) != 0; });
}

}  // namespace libration::ode
