#include "verdict_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/convergence/root_variable.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration {

using namespace convergence;

namespace {

constexpr long digits_of_uncertainty = 3;

std::string json_text(const std::string& text) { return text.empty() ? "null" : "\"" + text + "\""; }

std::string json_object(const std::vector<std::pair<std::string, std::string>>& members) {
    std::string all;
    for (const auto& [name, value] : members) {
        all += (all.empty() ? "\"" : ", \"") + name + "\": " + value;
    }
    return "{" + all + "}";
}

std::string json_array(const std::vector<std::string>& items) {
    std::string all;
    for (const std::string& each : items) {
        all += (all.empty() ? "" : ", ") + each;
    }
    return "[" + all + "]";
}

std::string history_of(const list_verdict& verdict, long digits, int root) {
    std::vector<std::string> items;
    for (const shorter_answer& each : verdict.history) {
        radius_estimate<mpfr> at;
        at.radius = each.radius;
        at.uncertainty = each.uncertainty;
        const auto shown = printed(in_powers_of_root(at, root), digits);
        items.push_back(json_object({{"order", std::to_string(each.order)},
                                     {"radius", json_text(shown.radius)},
                                     {"uncertainty", json_text(shown.uncertainty)}}));
    }
    return json_array(items);
}

std::string ring_of(const list_verdict& verdict, long digits, int root) {
    std::vector<std::string> items;
    for (const ring_member& each : verdict.ring) {
        radius_estimate<mpfr> at;
        at.radius = modulus_of(each.position);
        at.uncertainty = each.uncertainty;
        at.position = each.position;
        at.exponent = each.exponent;
        at.exponent_uncertainty = each.exponent_uncertainty;
        const auto shown = printed(in_powers_of_root(at, root), digits);
        items.push_back(
            json_object({{"position_re", json_text(shown.position_re)},
                         {"position_im", json_text(shown.position_im)},
                         {"uncertainty", json_text(shown.uncertainty)},
                         {"exponent", json_text(shown.exponent)},
                         {"exponent_uncertainty", json_text(shown.exponent_uncertainty)},
                         {"kind", json_text(each.kind == singularity_kind::unknown ? "" : name_of(each.kind))}}));
    }
    return json_array(items);
}

std::string decimal_of_double(double x) { return to_decimal(mpfr(x), 17); }

std::string fits_of(const list_verdict& verdict) {
    std::vector<std::string> items;
    for (const auto& each : verdict.family) {
        items.push_back(json_object({{"position", json_text(decimal_of_double(each.real()))},
                                     {"exponent", json_text(decimal_of_double(each.imag()))}}));
    }
    return json_array(items);
}

std::string predictions_of(const list_verdict& verdict) {
    std::vector<std::string> items;
    for (const auto& [n, error] : verdict.predictions) {
        items.push_back(json_object({{"order", std::to_string(n)},
                                     {"log10_error", json_text(to_decimal(mpfr(error), digits_of_uncertainty))}}));
    }
    return json_array(items);
}

// The action with the digits that are certain: -0.333333333333333, or 1.2+3.4i.
std::string action_text(const list_verdict& verdict, long digits) {
    radius_estimate<mpfr> at;
    at.radius = modulus_of(*verdict.action);
    at.uncertainty = verdict.action_uncertainty;
    at.position = verdict.action;
    const auto shown = printed(at, digits);
    return verdict.action->im == 0 ? shown.position_re : complex_text(shown.position_re, shown.position_im, "i");
}

std::string bound_text(radius_bound bound) {
    switch (bound) {
        case radius_bound::at_least: return "at least";
        case radius_bound::at_most: return "at most";
        case radius_bound::none: break;
    }
    return "";
}

std::string power_of_ten(double log_error) { return "10^" + std::to_string(std::lround(std::floor(log_error))); }

std::string certain_decimal(const mpfr& x, const mpfr& uncertainty, long digits) {
    radius_estimate<mpfr> at;
    at.radius = abs(x);
    at.uncertainty = uncertainty;
    const std::string shown = printed(at, digits).radius;
    return x < 0 && shown != "0" ? "-" + shown : shown;
}

}  // namespace

std::vector<std::string> verdict_columns() {
    return {"bound",
            "gevrey",
            "action",
            "action_uncertainty",
            "suspect",
            "suspect_predicted",
            "suspect_uncertainty",
            "prediction",
            "history",
            "ring",
            "amplitude",
            "amplitude_uncertainty",
            "fits",
            "predictions"};
}

std::vector<answer_value> values_of(const list_verdict& verdict, long digits, int root) {
    const auto number = [](std::string text) { return answer_value{std::move(text), ""}; };
    const auto list = [](std::string text) { return answer_value{std::move(text), "", value_kind::list}; };
    const auto& suspect = verdict.suspect;
    const auto& amplitude = verdict.amplitude;
    return {text_value(bound_text(verdict.bound)),
            text_value(verdict.gevrey ? verdict.gevrey->str() : ""),
            text_value(verdict.action ? action_text(verdict, digits) : ""),
            number(verdict.action ? to_decimal(verdict.action_uncertainty, digits_of_uncertainty) : ""),
            suspect ? whole_value(suspect->index) : text_value(""),
            number(suspect ? certain_decimal(suspect->predicted, suspect->uncertainty, 60) : ""),
            number(suspect ? to_decimal(suspect->uncertainty, digits_of_uncertainty) : ""),
            number(verdict.prediction ? to_decimal(mpfr(*verdict.prediction), digits_of_uncertainty) : ""),
            list(history_of(verdict, digits, root)),
            list(ring_of(verdict, digits, root)),
            number(amplitude && root == 1 ? certain_decimal(amplitude->value, amplitude->uncertainty, digits) : ""),
            number(amplitude && root == 1 ? to_decimal(amplitude->uncertainty, digits_of_uncertainty) : ""),
            list(fits_of(verdict)),
            list(predictions_of(verdict))};
}

std::string radius_text(const list_verdict& verdict, const std::string& printed) {
    return verdict.growth == growth_class::zero ? "0" : verdict.growth == growth_class::infinite ? "inf" : printed;
}

std::vector<answer_note> notes_of(const list_verdict& verdict, const request& how) {
    const long digits = how.printed_digits();
    std::vector<answer_note> notes;
    for (std::size_t i = 1; i < verdict.ring.size(); ++i) {
        radius_estimate<mpfr> at;
        at.radius = modulus_of(verdict.ring[i].position);
        at.uncertainty = verdict.ring[i].uncertainty;
        at.position = verdict.ring[i].position;
        at.exponent = verdict.ring[i].exponent;
        at.exponent_uncertainty = verdict.ring[i].exponent_uncertainty;
        const auto shown = printed(at, digits);
        notes.push_back(
            {"also",
             (at.position->im == 0 ? shown.position_re : complex_text(shown.position_re, shown.position_im, " i")) +
                 " +- " + shown.uncertainty +
                 (at.exponent ? ", exponent " + shown.exponent + " +- " + shown.exponent_uncertainty : "")});
    }
    if (verdict.amplitude) {
        notes.push_back(
            {"amplitude", certain_decimal(verdict.amplitude->value, verdict.amplitude->uncertainty, digits) + " +- " +
                              to_decimal(verdict.amplitude->uncertainty, digits_of_uncertainty)});
    }
    if (verdict.gevrey && *verdict.gevrey > 0) {
        notes.push_back({"growth", "zero radius, Gevrey order " + verdict.gevrey->str()});
    } else if (verdict.gevrey) {
        notes.push_back({"growth", "entire, order " + rational(-1 / *verdict.gevrey).str()});
    }
    if (verdict.action) {
        notes.push_back({"action", action_text(verdict, digits) + " +- " +
                                       to_decimal(verdict.action_uncertainty, digits_of_uncertainty) +
                                       ": the Borel transform is singular there"});
    }
    if (how.known_place) {
        const precision_scope scope(digits + radius_guard_digits);
        const auto biased = biased_exponent(verdict, from_exact<mpfr>(*how.known_place));
        notes.push_back({"biased", biased ? "exponent " + certain_decimal(biased->value, biased->uncertainty, digits) +
                                                " +- " + to_decimal(biased->uncertainty, digits_of_uncertainty) +
                                                " if the singularity is at " + how.known_place->text
                                          : "no exponent at a real singularity"});
    }
    if (verdict.suspect) {
        const auto& suspect = *verdict.suspect;
        const std::string n = std::to_string(suspect.index);
        notes.push_back(
            {"suspect", (suspect.confirmed ? "coefficient " + n + " is off by "
                                           : "the last coefficients disagree: number " + n + " is off by ") +
                            to_decimal(mpfr(suspect.deviation), digits_of_uncertainty) +
                            " of itself; the others predict " +
                            certain_decimal(suspect.predicted, suspect.uncertainty, 60) + " +- " +
                            to_decimal(suspect.uncertainty, digits_of_uncertainty)});
    }
    if (verdict.prediction) {
        notes.push_back({"prediction", "the last coefficient was predicted from the others to " +
                                           power_of_ten(*verdict.prediction) + " of itself"});
    }
    return notes;
}

}  // namespace libration
