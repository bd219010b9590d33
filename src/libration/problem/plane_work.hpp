// Searches and proofs in the complex plane: the report of their work to request::stage, and its end.
#pragma once

#include <optional>
#include <string>

#include "libration/integration/plane_watch.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// Counts the expansion points and discs of all works with its callback. It and the request must outlive them.
class plane_work {
public:
    explicit plane_work(const request& how) : how_(how) {}

    ode::plane_watch watch() {
        if (!how_.stage) {
            return {};
        }
        return [this](ode::plane_step step) {
            ++(step == ode::plane_step::point ? points_ : discs_);
            how_.stage(std::to_string(points_) + " expansion points" +
                       (discs_ > 0 ? ", " + std::to_string(discs_) + " discs" : ""));
        };
    }

private:
    const request& how_;
    long points_ = 0;
    long discs_ = 0;
};

}  // namespace libration
