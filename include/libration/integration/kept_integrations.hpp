// Steps of a solution that are kept, for more than one question about it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// Integrations of a solution and of its independent parts from the initial point, one in each direction, by rule_for()
/// with relative error weights, without the derivative of the flow. Each has the precision of the question that asked for
/// most. Not for several threads at once.
class kept_integrations {
public:
    /// The number of the whole system, unless it is its only part.
    static constexpr std::size_t whole = static_cast<std::size_t>(-1);
    static constexpr std::size_t usual_bytes = std::size_t{1} << 26U;

    /// At most so many bytes for the steps of each integration.
    explicit kept_integrations(std::size_t most_bytes = usual_bytes) : most_bytes_(most_bytes) {}

    /// The integration of a part, with this system, in the direction of time (< 0: backwards), of at least so many bits: the
    /// one that is kept, if its first step is, or a new one instead of it. Throws error like rule_for().
    std::shared_ptr<integration> along(std::size_t part, const explicit_system& system, long bits, int direction,
                                       const proof_route& route);
    /// Whether all steps of an integration stay: their estimated size is at most `most_bytes`.
    bool keeps(const integration& along) const;
    /// The steps that have been made.
    std::size_t made() const;

private:
    struct entry {
        std::size_t part;
        int direction;
        proof_route route;
        std::shared_ptr<integration> along;
    };

    std::size_t most_bytes_;
    std::vector<entry> entries_;
    std::size_t made_before_ = 0;  // by integrations that are no longer kept
};

/// A part of a solution with its kept steps; without them each question integrates anew.
struct kept_part {
    kept_integrations* steps = nullptr;
    std::size_t part = kept_integrations::whole;
};

/// The kept steps of an object that is const, for one thread at a time: others get none.
class shared_integrations {
public:
    /// Holds the steps as long as it exists.
    class use {
    public:
        explicit use(shared_integrations& of)
            : lock_(of.guard_, std::try_to_lock), steps_(lock_ ? &of.steps_ : nullptr) {}
        kept_integrations* steps() const { return steps_; }

    private:
        std::unique_lock<std::mutex> lock_;
        kept_integrations* steps_;
    };

    /// The steps that have been made, when no other thread uses them.
    std::size_t made() const {
        const std::scoped_lock lock(guard_);
        return steps_.made();
    }

private:
    mutable std::mutex guard_;
    kept_integrations steps_;
};

}  // namespace libration::ode
