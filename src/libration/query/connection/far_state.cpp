#include "far_state.hpp"

#include <algorithm>
#include <optional>

#include "libration/equation/identities.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

class resting {
public:
    resting(const first_order_form& form, const std::vector<std::pair<std::size_t, expression>>& given, int direction)
        : form_(form), values_(form.leaves.size()), time_(direction > 0 ? "(inf)" : "(-inf)") {
        for (const auto& [k, value] : given) {
            values_[k] = value;
        }
        find_needed(given);
    }

    far_state result() {
        while (determine_one()) {
        }
        for (std::size_t k = 0; k < form_.slopes.size(); ++k) {
            if (needed_[k]) {
                require_rest(k);
            }
        }
        far_state found;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            found.ignored.push_back(!needed_[k]);
            if (!needed_[k]) {
                values_[k] = expression(0);  // not read
            }
            if (!values_[k]) {
                found.names.push_back(form_.names[k] + time_);
                found.coordinates.push_back(unknown("limit of " + found.names.back()));  // not a name that can be typed
                values_[k] = found.coordinates.back();
            }
            found.values.push_back(*values_[k]);
        }
        return found;
    }

private:
    // The given leaves and those in the slopes of needed ones.
    void find_needed(const std::vector<std::pair<std::size_t, expression>>& given) {
        needed_.resize(form_.leaves.size());
        std::vector<std::size_t> open;
        for (const auto& [k, value] : given) {
            open.push_back(k);
        }
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            if (!needed_[k]) {
                needed_[k] = true;
                each_leaf(form_.slopes[k], [&](const expression& leaf) {
                    const std::size_t place = place_of(leaf);
                    if (place < needed_.size()) {
                        open.push_back(place);
                    }
                });
            }
        }
    }
    std::size_t place_of(const expression& leaf) const {
        return static_cast<std::size_t>(
            std::ranges::find_if(form_.leaves, [&](const expression& each) { return same_form(each, leaf); }) -
            form_.leaves.begin());
    }
    expression at_rest(const expression& e) const {
        return replaced(e, [&](const expression& leaf) {
            const std::size_t k = place_of(leaf);
            return k < values_.size() ? values_[k] : std::nullopt;
        });
    }
    // The leaves in it that are not determined.
    std::vector<std::size_t> open_in(const expression& e) const {
        std::vector<std::size_t> result;
        each_leaf(e, [&](const expression& leaf) {
            const std::size_t k = place_of(leaf);
            if (k < values_.size() && !values_[k] && std::ranges::find(result, k) == result.end()) {
                result.push_back(k);
            }
        });
        return result;
    }
    bool determine_one() {
        for (std::size_t k = 0; k < form_.slopes.size(); ++k) {
            if (!needed_[k]) {
                continue;
            }
            const expression e = at_rest(form_.slopes[k]);
            const auto open = is_identically_zero(e) ? std::vector<std::size_t>() : open_in(e);
            if (open.size() != 1) {
                continue;
            }
            const expression& leaf = form_.leaves[open.front()];
            const auto factor = partial(e, leaf).fraction();
            if (factor && *factor != 0) {
                const expression rest = replaced(e, [&](const expression& each) {
                    return same_form(each, leaf) ? std::optional<expression>(0) : std::nullopt;
                });
                values_[open.front()] = -rest / expression(*factor);
                return true;
            }
        }
        return false;
    }
    void require_rest(std::size_t k) const {
        const expression e = at_rest(form_.slopes[k]);
        if (is_identically_zero(e)) {
            return;
        }
        const auto open = open_in(e);
        if (open.empty() && e.fraction()) {
            throw error(error_kind::argument, error_subject::conditions, "",
                        "is not the limit of a constant solution: " + form_.names[k] +
                            " grows with the time, which is supported only for boundary layers that one equation in " +
                            form_.names[k] +
                            " determines, f''' = -a*f*f'' + q(f'), with quantities T'' = -c*f*T' that it carries: give "
                            "the limits of an equilibrium");
        }
        if (open.empty()) {
            throw error(error_kind::argument, error_subject::conditions, "",
                        "is not the limit of a constant solution: the derivative of " + form_.names[k] +
                            " is not seen to vanish there: give the limits of an equilibrium, exactly");
        }
        throw error(error_kind::argument, error_subject::conditions, "",
                    "does not determine the limit of " + form_.names[open.front()] + ": add " +
                        form_.names[open.front()] + time_ + " = NUMBER");
    }

    const first_order_form& form_;
    std::vector<std::optional<expression>> values_;
    std::vector<bool> needed_;
    std::string time_;
};

}  // namespace

far_state far_state_of(const first_order_form& form, const std::vector<std::pair<std::size_t, expression>>& given,
                       int direction) {
    return resting(form, given, direction).result();
}

}  // namespace libration::ode
