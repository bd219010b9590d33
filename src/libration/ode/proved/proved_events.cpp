#include "libration/ode/proved/proved_events.hpp"

#include <string>
#include <utility>

#include "libration/scalar/error.hpp"
#include "needed_bits.hpp"

namespace libration::ode {

namespace {

constexpr int most_undecided_runs = 5;

// The value that g = 0 alone gives each unknown: of a leaf in which g is linear without another one.
std::vector<std::optional<number>> given_values(const explicit_system& system, const expression& g) {
    std::vector<std::optional<number>> values;
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            const expression leaf = unknown(each.name, j);
            const expression factor = partial(g, leaf);
            const expression rest = replaced(g, [&](const expression& other) -> std::optional<expression> {
                return same_form(other, leaf) ? std::optional(expression()) : std::nullopt;
            });
            const bool alone =
                factor.kind() == node_kind::constant && !factor.is(0) && rest.kind() == node_kind::constant;
            values.push_back(alone ? std::optional(-(rest.constant() / factor.constant())) : std::nullopt);
        }
    }
    return values;
}

class event_runs {
public:
    event_runs(const explicit_system& system, const event_request& request, long digits, const proof_route& route)
        : system_(system), request_(request), given_(given_values(system, request.g)), route_(route), bits_(digits) {}

    std::vector<printed_event> result() {
        while (!complete()) {
        }
        return std::move(events_);
    }

private:
    bool complete() {
        events_.clear();
        const precision_scope scope(decimal_digits(bits_.now()) + 10);
        event_search search(system_, request_.g, bits_.now(), request_.direction, route_);
        try {
            while (static_cast<long>(events_.size()) < request_.count) {
                const auto event = search.next(request_.way, request_.before);
                if (!event) {
                    return require_more_bits(search);
                }
                if (!printed(*event)) {
                    return false;
                }
            }
        } catch (const precision_exhausted&) {
            if (++undecided_ >= most_undecided_runs) {
                throw error(error_kind::undecided, "event", name_of_next(),
                            "is not decided by " + std::to_string(bits_.now()) +
                                " bits: the function touches 0 there, or nearly");
            }
            bits_.raise_to(2 * bits_.now(), "event", name_of_next());
            return false;
        }
        return true;
    }

    bool printed(const proved_event& event) {
        printed_event made;
        std::vector<ball> values = event.state;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given_[i]) {
                values[i] = constant_value<ball>::of(*given_[i]);
            }
        }
        values.insert(values.begin(), event.time);
        for (const ball& value : values) {
            auto decimal = bits_.printed(value, "event", name_of_next());
            if (!decimal) {
                return false;
            }
            made.values.push_back(*std::move(decimal));
        }
        made.time = made.values.front();
        made.values.erase(made.values.begin());
        events_.push_back(std::move(made));
        return true;
    }

    bool require_more_bits(const event_search& search) {
        if (!search.stopped()) {
            throw error(error_kind::undecided, "event", name_of_next(),
                        "is not before that time: " + std::to_string(events_.size()) + " were found");
        }
        if (search.march().end() == march_end::steps) {
            throw error(error_kind::undecided, "event", name_of_next(),
                        "is not reached: the solution is proved to exist up to " +
                            upper_bound_text(search.march().reached()) +
                            ", where the steps become too small, as they do near a singularity");
        }
        bits_.raise_to(2 * bits_.now(), "event", name_of_next());
        return false;
    }

    std::string name_of_next() const { return std::to_string(events_.size() + 1); }

    const explicit_system& system_;
    const event_request& request_;
    std::vector<std::optional<number>> given_;
    proof_route route_;
    std::vector<printed_event> events_;
    needed_bits bits_;
    int undecided_ = 0;
};

}  // namespace

std::vector<printed_event> proved_events(const explicit_system& system, const event_request& request, long digits,
                                         const proof_route& route) {
    return event_runs(system, request, digits, route).result();
}

}  // namespace libration::ode
