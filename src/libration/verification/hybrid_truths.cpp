#include "libration/verification/hybrid_truths.hpp"

#include <utility>

#include "../hybrid/path_limits.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

// A path with so many bits, and the time of its last state.
struct hybrid_truths::followed_path {
    long bits;
    std::unique_ptr<hybrid_path> path = {};
    number latest = {};
    number farthest = number(rational(1'000'000'000));
};

hybrid_truths::hybrid_truths(const hybrid_system& system, std::vector<std::size_t> places)
    : system_(system), places_(std::move(places)) {}

hybrid_truths::~hybrid_truths() = default;

std::vector<ball> hybrid_truths::state(const exact& time, long digits) {
    const number at = as_exact_real(time);
    if ((at - system_.point()).sign() < 0) {
        throw error(error_kind::argument, error_subject::time, time.text,
                    "is before the initial point, from which events and piecewise right-hand sides are followed "
                    "forwards only");
    }
    auto& way = by_digits_[digits];
    if (!way) {
        way = std::make_unique<followed_path>(followed_path{.bits = bits_of_first_run(digits)});
    }
    if ((at - way->farthest).sign() > 0) {
        way->farthest = at;
        way->path.reset();
    }
    for (;;) {
        if (!way->path || (at - way->latest).sign() < 0) {
            way->path = std::make_unique<hybrid_path>(system_, way->bits);
        }
        way->latest = at;
        if (auto found = way->path->at(at, way->farthest)) {
            return *std::move(found);
        }
        const path_end why = way->path->end();
        const bool more_bits_help = why == path_end::none || why == path_end::precision || why == path_end::undecided;
        if (!more_bits_help || 2 * way->bits > most_bits_of_path(digits)) {
            const std::string reason = why == path_end::precision || why == path_end::none
                                           ? std::to_string(way->bits) + " bits do not decide the next event"
                                           : way->path->reason();
            throw error(error_kind::undecided, error_subject::time, time.text,
                        "is not reached: " + events_text(*way->path) + ", " + reason);
        }
        way->bits *= 2;
        way->path.reset();
    }
}

std::vector<true_value> hybrid_truths::truths_at(const exact& time, long digits) {
    std::vector<true_value> truths;
    if ((as_exact_real(time) - system_.point()).sign() == 0) {
        for (const std::size_t place : places_) {
            const number& value = system_.starts()[place];
            truths.push_back({constant_value<ball>::of(value), value.fraction()});
        }
        return truths;
    }
    const auto found = state(time, digits);
    for (const std::size_t place : places_) {
        truths.push_back({found[place]});
    }
    return truths;
}

row_question hybrid_truths::at(const exact& time) {
    row_question question;
    question.first_digits = [](long places) { return (places + 29) / 10 * 10; };
    question.truths = [this, time](long digits) { return truths_at(time, digits); };
    question.condition = [](long /*digits*/) { return std::string(); };
    return question;
}

}  // namespace libration::ode
