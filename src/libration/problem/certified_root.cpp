#include "certified_root.hpp"

#include <algorithm>
#include <utility>

#include "certificate_text.hpp"
#include "libration/algebra/krawczyk.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "near_fractions.hpp"

namespace libration {

namespace {

constexpr long guard_bits = 60;
constexpr int most_corrections = 12;
constexpr int most_boxes = 12;
// The first precision of the derivatives, of which a few digits are sufficient.
constexpr long digits_of_derivatives = 6;
// Of a radius: the distance of the middle from the root, and the errors of F and of its derivatives.
const rational part_of_middle(1, 1000);
const rational part_of_errors(1, 8);
// The middle and the matrix C have so many digits more than the radii and one.
const rational unit_of_middle(1, 10'000);
const rational unit_of_matrix(1, 1'000'000);
// The claims about states, relative to their size.
const rational first_width(1, 1'000);
const rational next_width(1, 100);
constexpr int most_widths = 12;

[[noreturn]] void refuse_undecided(const std::string& reason) {
    throw error(error_kind::undecided, error_subject::certificate, "", reason);
}

ball hull_of(const ode::decimal_interval& of) {
    return hull(from_rational<ball>(of.low), from_rational<ball>(of.high));
}

class root_certificate {
public:
    root_certificate(const certified_root& of, const request& how)
        : of_(of),
          how_(how),
          digits_(how.printed_digits()),
          box_(of.starts),
          system_(of.system(middles_of(of.starts))) {
        if (of.period) {
            box_.push_back(*of.period);
        }
        middle_ = middles_of(box_);
    }

    std::string text() {
        find_middle();
        choose_box();
        const ode::explicit_system system = of_.system(middle_);
        std::string all = text_of_certificate(system, values_at_middle(), last_time(), digits_, how_);
        for (std::size_t k = 0; k < of_.places.size(); ++k) {
            all += text_of_certificate(system, derivatives_by(k), last_time(), digits_of_derivatives, how_);
        }
        const auto names = ode::names_of_state(system);
        for (std::size_t i = 0; i < of_.conditions.size(); ++i) {
            const auto& [place, value] = of_.conditions[i];
            all += "root " + names[place] + " " + (value ? value->str() : "start");
            for (const rational& c : matrix_[i]) {
                all += " " + c.str();
            }
            all += "\n";
        }
        return all;
    }

private:
    // F and its derivative over a box of the unknowns, and the state and its slopes at the end.
    struct end_values {
        std::vector<ball> state, slopes, residual;
        ode::ball_matrix derivative;
    };

    static std::vector<rational> middles_of(const std::vector<ode::decimal_interval>& box) {
        std::vector<rational> result;
        result.reserve(box.size());
        for (const auto& each : box) {
            result.emplace_back((each.low + each.high) / 2);
        }
        return result;
    }

    std::size_t size() const { return box_.size(); }
    rational radius(std::size_t k) const {
        return std::min(rational(middle_[k] - box_[k].low), rational(box_[k].high - middle_[k]));
    }
    rational time_of_middle() const { return of_.period ? middle_.back() : of_.time; }
    rational last_time() const { return of_.period ? box_.back().high : of_.time; }

    // std::nullopt if the solutions through the box are not proved to exist up to the end.
    std::optional<end_values> values_on(const std::vector<ball>& unknowns, long bits) const {
        const precision_scope scope(decimal_digits(bits));
        const ode::first_order_form form(system_);
        std::vector<ball> start;
        for (const ode::number& each : form.starts) {
            start.push_back(ode::constant_value<ball>::of(each));
        }
        for (std::size_t k = 0; k < of_.places.size(); ++k) {
            start[of_.places[k]] = unknowns[k];
        }
        ode::proved_march march(system_, start, bits, ode::proved_march::usual_error_bits,
                                [this](const ball& reached, long now) {
                                    if (how_.reached) {
                                        how_.reached(midpoint_of(reached).convert_to<double>(), now);
                                    }
                                });
        march.keep_derivative();
        const ball time = of_.period ? unknowns.back() : from_rational<ball>(of_.time);
        const auto state = march.at(time);
        if (!state) {
            return std::nullopt;
        }
        const ode::ball_matrix flow = march.derivative_at(time);
        end_values found{*state, form.slopes_at(*state, time), {}, {}};
        for (const auto& [place, value] : of_.conditions) {
            found.residual.push_back((*state)[place] - (value ? from_rational<ball>(*value) : start[place]));
            auto& row = found.derivative.emplace_back();
            for (const std::size_t by : of_.places) {
                row.push_back(!value && by == place ? flow[place][by] - 1 : flow[place][by]);
            }
            if (of_.period) {
                row.push_back(found.slopes[place]);
            }
        }
        return found;
    }

    end_values values_at_middle_with(long bits) const {
        const precision_scope scope(decimal_digits(bits));
        std::vector<ball> unknowns;
        for (const rational& each : middle_) {
            unknowns.push_back(from_rational<ball>(each));
        }
        auto found = values_on(unknowns, bits);
        if (!found) {
            refuse_undecided("is of a root near which the solution is not proved to exist up to the condition");
        }
        return *std::move(found);
    }

    // Newton's method to a middle that is near enough to the root, and C, near the inverse of F' there.
    void find_middle() {
        long bits = bits_of_digits(digits_) + guard_bits;
        for (int i = 0; i < most_corrections; ++i, bits += bits / 4) {
            at_middle_ = values_at_middle_with(bits);
            const precision_scope scope(decimal_digits(bits));
            const auto inverse = ode::inverse_near(at_middle_.derivative);
            if (!inverse) {
                refuse_undecided("is of a root that is not isolated: the derivative of the conditions is singular");
            }
            std::vector<ball> step(size(), ball(0));
            bool near = true;
            for (std::size_t k = 0; k < size(); ++k) {
                for (std::size_t l = 0; l < size(); ++l) {
                    step[k] += (*inverse)[k][l] * at_middle_.residual[l];
                }
                near = near && certainly_less(abs(step[k]), from_rational<ball>(radius(k) * part_of_middle));
            }
            if (near) {
                round_matrix(*inverse);
                return;
            }
            for (std::size_t k = 0; k < size(); ++k) {
                const rational unit = power_of_ten_below((box_[k].high - box_[k].low) / 2) * unit_of_middle;
                middle_[k] = rounded_to(middle_[k] - fraction_near(step[k]), unit);
                if (middle_[k] <= box_[k].low || box_[k].high <= middle_[k]) {
                    refuse_undecided("is of a root that is not found again within one unit of its last digit");
                }
            }
        }
        refuse_undecided("is of a root that is not found again with more digits: ask for fewer");
    }

    void round_matrix(const ode::ball_matrix& inverse) {
        matrix_.assign(size(), {});
        for (std::size_t i = 0; i < size(); ++i) {
            for (std::size_t l = 0; l < size(); ++l) {
                const rational c = fraction_near(inverse[i][l]);
                matrix_[i].push_back(c == 0 ? c : rounded_to(c, power_of_ten_below(rational(abs(c))) * unit_of_row(i)));
            }
        }
    }

    // C needs more digits where the radii are of different sizes.
    rational unit_of_row(std::size_t i) const {
        rational largest = radius(i);
        for (std::size_t k = 0; k < size(); ++k) {
            largest = std::max(largest, radius(k));
        }
        return unit_of_matrix * power_of_ten_below(radius(i) / largest);
    }

    void set_box(const std::vector<rational>& radii) {
        for (std::size_t k = 0; k < size(); ++k) {
            const rational low = middle_[k] - radii[k];
            const rational high = middle_[k] + radii[k];
            box_[k] = {low.str(), high.str(), low, high};
        }
    }

    // A box on which |1 - C F'| r is small, about the middle if that on which the root is known is too large. The middle
    // of a smaller box has to be nearer to the root.
    void choose_box() {
        for (int i = 0; i < most_boxes; ++i) {
            const long bits = bits_of_digits(digits_) + guard_bits + ode::proved_march::usual_error_bits;
            const precision_scope scope(decimal_digits(bits));
            std::vector<ball> unknowns;
            std::ranges::transform(box_, std::back_inserter(unknowns), hull_of);
            const auto found = values_on(unknowns, bits);
            if (found && contracts(found->derivative)) {
                return;
            }
            std::vector<rational> radii;
            for (std::size_t k = 0; k < size(); ++k) {
                radii.push_back(power_of_ten_below(radius(k)) / 100);
            }
            set_box(radii);
            find_middle();
            set_box(radii);
        }
        refuse_undecided("is of a root near which the derivatives of the conditions change too much");
    }

    bool contracts(const ode::ball_matrix& derivative) const {
        for (std::size_t i = 0; i < size(); ++i) {
            ball total(0);
            for (std::size_t k = 0; k < size(); ++k) {
                ball entry(i == k ? -1 : 0);
                for (std::size_t l = 0; l < size(); ++l) {
                    entry += from_rational<ball>(matrix_[i][l]) * derivative[l][k];
                }
                total += abs(entry) * from_rational<ball>(radius(k));
            }
            if (!certainly_less(total, from_rational<ball>(radius(i) * part_of_errors))) {
                return false;
            }
        }
        return true;
    }

    // So far may F_l, times 1, or its derivative by unknown k, times r_k, be from the value in the middle.
    rational reach_of(std::size_t l, const rational& factor) const {
        std::optional<rational> least;
        for (std::size_t i = 0; i < size(); ++i) {
            if (const rational c = abs(matrix_[i][l]); c != 0) {
                const rational reach = radius(i) * part_of_errors / (static_cast<long>(size() * size()) * c * factor);
                least = least ? std::min(*least, reach) : reach;
            }
        }
        return least.value_or(1);
    }

    ode::certified_statement values_at_middle() const {
        ode::certified_statement statement;
        for (std::size_t l = 0; l < size(); ++l) {
            const std::size_t place = of_.conditions[l].place;
            statement.values.push_back(
                {time_of_middle(), place, interval_about(at_middle_.state[place], reach_of(l, 1))});
        }
        return statement;
    }

    ode::certified_statement derivatives_by(std::size_t k) const {
        ode::certified_statement statement{.values = {}, .varied = of_.places[k]};
        for (std::size_t j = 0; j < of_.places.size(); ++j) {
            statement.starts.push_back({of_.places[j], box_[j].low, box_[j].high});
        }
        if (k == 0 && of_.period) {
            statement.values = states_near_end();
        }
        const std::size_t count = at_middle_.state.size();
        const rational first = of_.period ? box_.back().low : of_.time;
        for (std::size_t l = 0; l < size(); ++l) {
            const auto& [place, value] = of_.conditions[l];
            const ball derivative =
                !value && of_.places[k] == place ? at_middle_.derivative[l][k] + 1 : at_middle_.derivative[l][k];
            statement.values.push_back(
                {first, count + place, interval_about(derivative, reach_of(l, radius(k))), {}, until()});
        }
        return statement;
    }

    std::optional<rational> until() const { return of_.period ? std::optional(box_.back().high) : std::nullopt; }

    // Intervals of the states that are so narrow that their slopes, the derivatives by the time, are known as well.
    std::vector<ode::claimed_value> states_near_end() const {
        const precision_scope scope(decimal_digits(bits_of_digits(digits_) + guard_bits));
        const ode::first_order_form form(system_);
        rational width = first_width;
        for (int i = 0; i < most_widths; ++i, width *= next_width) {
            std::vector<ode::claimed_value> values;
            std::vector<ball> states;
            for (std::size_t place = 0; place < at_middle_.state.size(); ++place) {
                const ball& state = at_middle_.state[place];
                const rational size = std::max(rational(1), rational(abs(fraction_near(state))));
                values.push_back({box_.back().low, place, interval_about(state, size * width), {}, until()});
                states.push_back(hull_of(values.back().in));
            }
            const auto slopes = form.slopes_at(states, from_rational<ball>(middle_.back()));
            bool narrow = true;
            for (std::size_t l = 0; l < size(); ++l) {
                const rational reach = reach_of(l, radius(size() - 1));
                const ball error = slopes[of_.conditions[l].place] - at_middle_.derivative[l].back();
                narrow = narrow && certainly_less(abs(error), from_rational<ball>(reach));
            }
            if (narrow) {
                return values;
            }
        }
        refuse_undecided("is of a periodic orbit of which the velocity is not proved");
    }

    const certified_root& of_;
    const request& how_;
    long digits_;
    std::vector<ode::decimal_interval> box_;
    ode::explicit_system system_;
    std::vector<rational> middle_;
    end_values at_middle_;
    std::vector<std::vector<rational>> matrix_;
};

}  // namespace

std::string text_of_root(const certified_root& root, const request& how) { return root_certificate(root, how).text(); }

}  // namespace libration
