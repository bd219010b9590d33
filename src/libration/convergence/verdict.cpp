#include "libration/convergence/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "amplitude.hpp"
#include "apparent_root.hpp"
#include "cluster_answer.hpp"
#include "examined_list.hpp"
#include "hold_out.hpp"
#include "libration/convergence/strided_series.hpp"
#include "libration/scalar/decimal.hpp"
#include "list_growth.hpp"

namespace libration::convergence {

namespace {

constexpr int fewest_of_exact_list = 10;
constexpr double finest_uncertainty = 1e-50;
constexpr double strong_share = 10;

class verdict_builder {
public:
    verdict_builder(const series_list& list, const task_runner& run) : list_(list), run_(run) {}

    list_verdict verdict() {
        const precision_scope scope(decimal_digits(bits_for(list_.order()) + 64));
        find_pattern();
        if (found_.pattern.last < 0 || found_.pattern.polynomial) {
            found_.note = found_.pattern.text();
            return std::move(found_);
        }
        const auto size = static_cast<int>(b_.size());
        const bool examine = size >= fewest_of_exact_list && !found_.pattern.lacunary;
        if (examine && size >= fewest_coefficients) {
            hold_out();
        }
        const auto growth = size_growth_of(b_);
        gamma_ = growth ? growth->gamma : 0;
        auto by = examine ? examined(b_, class_, list_.noise, run_) : nullptr;
        if (by && by->strong.empty()) {
            if (sharpest_transform() && transform_->is_as_sharp_as(list_.noise)) {
                take_factorial_growth(false);
                return std::move(found_);
            }
            by = with_cuts(std::move(by), b_, class_, list_.noise, run_);
        }
        const bool strong = by && !by->strong.empty();
        if (strong) {
            take(*by);
        }
        const bool decided = strong && (relative_uncertainty() < 0.03 || std::abs(gamma_) < 0.15);
        if (!decided && !(examine && take_factorial_growth(strong)) && !strong) {
            take_growth_alone(by.get());
        }
        return std::move(found_);
    }

private:
    void find_pattern() {
        found_.pattern = pattern_of(list_);
        class_ = {found_.pattern.first % found_.pattern.stride, found_.pattern.stride};
        b_ = class_of(list_, found_.pattern);
        found_.used = list_.order();
    }

    int index_of(int k) const { return class_.first + class_.stride * k; }

    // The predictability of the coefficients, and the one that is wrong: the verdict is then based on those before it.
    void hold_out() {
        const int last = static_cast<int>(b_.size()) - 1;
        const auto errors = prediction_errors(b_, std::max(fewest_coefficients, last / 3), list_.noise, run_);
        if (const auto at = errors.find(last); at != errors.end()) {
            found_.prediction = at->second;
        }
        for (const auto& [k, error] : errors) {
            found_.predictions.emplace_back(index_of(k), error);
        }
        found_.suspect = find_suspect(b_, errors, list_.noise, run_);
        if (found_.suspect) {
            const int k = found_.suspect->index;
            found_.suspect->index = index_of(k);
            if (k >= fewest_coefficients) {
                b_.resize(static_cast<std::size_t>(k));
            }
        }
    }

    double relative_uncertainty() const { return mpfr(found_.uncertainty / *found_.radius).convert_to<double>(); }

    mpfr in_x(const mpfr& y) const { return stride_root(y, class_.stride); }

    // A pair that its uncertainty does not distinguish from a point of the axis is what the fits make of one point.
    static bool is_unresolved(const placed_cluster& each) {
        const root_consensus& at = each.consensus();
        return at.position.im != 0 && abs(at.position.im) <= each.uncertainty * at.modulus();
    }
    static bool is_real(const placed_cluster& each) { return each.consensus().position.im == 0 || is_unresolved(each); }

    ring_member member_of(const placed_cluster& each, const mpfr& unit) const {
        const root_consensus& at = each.consensus();
        const complex_number<mpfr> w{mpfr(at.position.re * unit),
                                     is_real(each) ? mpfr(0) : mpfr(at.position.im * unit)};
        ring_member member{.position = stride_root(w, class_.stride), .uncertainty = mpfr(0)};
        member.uncertainty = modulus_of(member.position) * each.uncertainty / class_.stride;
        const auto [exponent, uncertainty] = exponent_at(*each.of, each.at);
        member.kind = is_unresolved(each) ? singularity_kind::unknown : kind_at(*each.of, each.at);
        if (member.kind != singularity_kind::irregular && uncertainty < 10 && !is_unresolved(each)) {
            member.exponent = exponent;
            member.exponent_uncertainty = mpfr(uncertainty);
        }
        return member;
    }

    void take(const examined_list& by) {
        const mpfr unit = widen(by.family.unit);
        auto ring = ring_of(by.strong);
        for (auto& each : ring) {
            each.uncertainty =
                std::max({each.uncertainty, finest_uncertainty, each.consensus().exact ? list_.noise : 0});
            found_.ring.push_back(member_of(each, unit));
            found_.count += is_real(each) ? class_.stride : 2 * class_.stride;
        }
        const placed_cluster& lead = ring.front();
        const ring_member& first = found_.ring.front();
        found_.growth = growth_class::finite;
        found_.position = first.position;
        found_.radius = modulus_of(first.position);
        found_.uncertainty = first.uncertainty;
        found_.exponent = first.exponent;
        found_.exponent_uncertainty = first.exponent_uncertainty;
        found_.kind = first.kind;
        found_.exact = lead.consensus().exact;
        if (lead.consensus().type > 20) {
            found_.second_exponent = lead.consensus().second;
        }
        found_.used = index_of(lead.consensus().length);
        add_amplitude(by.family, lead);
        add_history(*lead.of, unit);
        add_family(lead.consensus(), unit);
        widen_drifting(lead);
        describe(lead);
        admit_undecided(by, unit);
        const double below = lead.lower();
        if (lead.uncertainty > 1e-40) {
            if (const auto nearer = doubtful_nearer(by.family, by.clusters, below)) {
                const mpfr radius = in_x(mpfr(unit * *nearer));
                found_.uncertainty = std::max(found_.uncertainty, mpfr(abs(*found_.radius - radius) * 11 / 10));
                found_.rival = radius;
            }
        }
    }

    // By the list, or by what an exact equation continues it to, whichever is sharper: where the equation has a root within
    // the circle, the errors of rounding grow.
    static std::optional<exponent_estimate> sharpest_amplitude(const approximant_family& family,
                                                               const known_power& power) {
        constexpr int sharp_order = 600;
        auto found = amplitude_of(family.scaled, power);
        const auto exact = std::ranges::find_if(family.fits, &differential_fit::exact);
        if (exact == family.fits.end() || family.order >= sharp_order) {
            return found;
        }
        const auto& track = family.tracks[exact->track];
        const int length = std::min(family.order, track.degree + 110);
        const auto relation = relation_of(family.scaled, track, length, bits_for(family.order));
        if (!relation) {
            return found;
        }
        const auto list = continued_by(*relation, family.scaled, family.order, sharp_order - family.order);
        const bool is_finite = std::ranges::all_of(list, [](const mpfr& each) { return isfinite(each); });
        auto further = is_finite ? amplitude_of(list, power) : std::nullopt;
        return further && (!found || further->uncertainty < found->uncertainty) ? further : found;
    }

    // f = x^first h(x^stride) ~ x0^first A stride^t (1 - x/x0)^t for h ~ A (1 - w/w0)^t.
    void add_amplitude(const approximant_family& family, const placed_cluster& lead) {
        const mpfr& y = lead.consensus().position.re;
        if (found_.ring.size() > 1 || lead.consensus().position.im != 0 || found_.position->im != 0 ||
            !found_.exponent) {
            return;
        }
        known_power power{.position = {y, mpfr(abs(y) * lead.uncertainty)},
                          .exponent = {*found_.exponent, found_.exponent_uncertainty},
                          .is_logarithm = found_.kind == singularity_kind::logarithm};
        if (lead.consensus().type == 22) {
            power.second = found_.second_exponent;
        }
        const auto h = sharpest_amplitude(family, power);
        if (h) {
            const mpfr factor = pow(found_.position->re, class_.first) * pow(mpfr(class_.stride), *found_.exponent);
            found_.amplitude = exponent_estimate{mpfr(h->value * factor), mpfr(h->uncertainty * abs(factor))};
        }
    }

    void add_history(const root_cluster& cluster, const mpfr& unit) {
        for (std::size_t i = 0; i < cluster.history.size(); ++i) {
            if (cluster.history[i]) {
                const mpfr radius = in_x(mpfr(modulus_of(cluster.history[i]->position) * unit));
                const double relative = std::max(position_uncertainty(cluster, i), finest_uncertainty);
                found_.history.push_back(
                    {index_of(cluster.history[i]->length), radius, mpfr(radius * relative / class_.stride)});
            }
        }
    }

    void add_family(const root_consensus& lead, const mpfr& unit) {
        const double y = lead.place().real();
        found_.slope = lead.slope * y * class_.stride;
        found_.residual = lead.residual;
        if (lead.position.im == 0 && class_.stride == 1) {
            for (const auto& each : lead.members) {
                found_.family.emplace_back(each.real() * unit.convert_to<double>(), each.imag());
            }
        }
    }

    // An exponent that moves in one direction over three lengths by more than its spread may continue to do so.
    void widen_drifting(const placed_cluster& lead) {
        const auto& history = lead.of->history;
        if (!found_.exponent || lead.consensus().exact || lead.at < 3) {
            return;
        }
        std::vector<double> moves;
        for (std::size_t i = lead.at - 2; i <= lead.at; ++i) {
            if (!history[i] || !history[i - 1]) {
                return;
            }
            moves.push_back(mpfr(history[i]->exponent.value - history[i - 1]->exponent.value).convert_to<double>());
        }
        const double total = moves[0] + moves[1] + moves[2];
        const bool one_way = moves[0] * moves[1] > 0 && moves[1] * moves[2] > 0;
        const exponent_vote& vote = lead.consensus().exponent;
        if (one_way && std::abs(total) > 4 * std::max(vote.spread, vote.step)) {
            for (const auto& each : history) {
                if (each && each->share >= strong_share) {
                    const mpfr moved = abs(mpfr(each->exponent.value - *found_.exponent));
                    found_.exponent_uncertainty = std::max(found_.exponent_uncertainty, moved);
                }
            }
            drifts_ = true;
        }
    }

    // An exact equation has a root in front of another one, so near that it is not decided whether the list is singular
    // at the first: the radius may be that of the second.
    void admit_undecided(const examined_list& by, const mpfr& unit) {
        const root_consensus& first = by.strong.front()->now();
        if (!first.exact || by.strong.size() < 2 ||
            nature_of_nearest(by.family, by.strong) != nature_of_root::undecided) {
            return;
        }
        const mpfr next = in_x(mpfr(modulus_of(by.strong[1]->now().position) * unit));
        if (abs(next - *found_.radius) <= 2 * found_.uncertainty) {
            return;  // on the same circle
        }
        found_.rival = next;
        found_.uncertainty = std::max(found_.uncertainty, mpfr(abs(next - *found_.radius) * 11 / 10));
        found_.kind = singularity_kind::unknown;
        found_.exponent.reset();
        found_.amplitude.reset();
        found_.position.reset();
        found_.ring.clear();
        found_.count = 0;
    }

    void describe(const placed_cluster& lead) {
        const root_consensus& at = lead.consensus();
        found_.note = at.exact ? "the list satisfies a linear differential equation"
                               : std::to_string(at.agreeing) + " differential approximants agree";
        const int all = index_of(static_cast<int>(b_.size()) - 1);
        if (found_.used < all) {
            found_.note += "; from the first " + std::to_string(found_.used + 1) + " coefficients";
            if (lead.of->now().distance_to(at) > position_uncertainty(*lead.of, lead.at) * at.modulus()) {
                found_.note += ", which the later ones contradict";
            }
        }
        if (found_.kind == singularity_kind::confluent && found_.second_exponent) {
            found_.note += "; the second exponent is " + to_decimal(mpfr(*found_.second_exponent), 6);
        }
        if (drifts_) {
            found_.note += "; the exponent drifts: confluent corrections are likely";
        }
        if (found_.suspect) {
            found_.note += "; without coefficient " + std::to_string(found_.suspect->index) + " and the later ones";
        }
    }

    struct borel_transform {
        std::unique_ptr<examined_list> list;
        rational order;
        double uncertainty, score;

        // No other order can have a position with more digits.
        bool is_as_sharp_as(double noise) const { return uncertainty <= std::max(finest_uncertainty, noise); }
    };

    // The Borel transform with the sharpest singularity; the score is the number of digits of its position.
    const std::optional<borel_transform>& sharpest_transform() {
        if (transforms_seen_ || std::abs(gamma_) <= 0.12) {
            return transform_;
        }
        transforms_seen_ = true;
        for (const rational& order : gevrey_orders_near(gamma_)) {
            const rational s = gamma_ > 0 ? order : rational(-order);
            auto found =
                examined(without_factorials(b_, s, bits_for(static_cast<int>(b_.size()))), class_, list_.noise, run_);
            if (found->strong.empty()) {
                continue;
            }
            const placed_cluster at = placed(*found->strong.front());
            const double uncertainty = std::max(at.uncertainty, finest_uncertainty);
            const double score = -std::log10(uncertainty) + 0.3 * std::log10(at.consensus().share);
            if (!transform_ || score > transform_->score + 0.5) {
                transform_ = borel_transform{std::move(found), s, uncertainty, score};
            }
            if (transform_->is_as_sharp_as(list_.noise)) {
                break;
            }
        }
        return transform_;
    }

    // It replaces a radius only if it is two digits sharper than that.
    bool take_factorial_growth(bool has_radius) {
        const auto& best = sharpest_transform();
        const bool better = best && (!has_radius || -std::log10(relative_uncertainty()) < best->score - 2);
        if (better) {
            take_action(*best->list, best->order);
        }
        return better;
    }

    void take_action(const examined_list& by, const rational& s) {
        const placed_cluster at = placed(*by.strong.front());
        const double relative = std::max({at.uncertainty, finest_uncertainty, at.consensus().exact ? list_.noise : 0});
        const ring_member member = member_of(at, widen(by.family.unit));
        list_verdict none;
        none.pattern = found_.pattern;
        none.suspect = std::move(found_.suspect);
        none.prediction = found_.prediction;
        none.predictions = std::move(found_.predictions);
        found_ = std::move(none);
        found_.growth = s > 0 ? growth_class::zero : growth_class::infinite;
        found_.gevrey = s / class_.stride;
        found_.action = member.position;
        found_.action_uncertainty = modulus_of(member.position) * relative / class_.stride;
        found_.exponent = member.exponent;
        found_.exponent_uncertainty = member.exponent_uncertainty;
        found_.exact = at.consensus().exact;
        found_.used = index_of(at.consensus().length);
        found_.note = s > 0 ? "the coefficients grow like factorials" : "the coefficients fall like inverse factorials";
    }

    void take_growth_alone(const examined_list* examined) {
        constexpr int fewest_for_growth = 30;
        const bool no_roots = examined != nullptr && examined->family.is_exact() && !examined->family.has_exact_root();
        if (no_roots && gamma_ < -0.12) {
            found_.growth = growth_class::infinite;
            found_.exact = true;
            found_.note = "the list satisfies a linear differential equation without finite singularities";
            return;
        }
        if (std::abs(gamma_) > 0.3 && list_.order() >= fewest_for_growth && is_steady_growth(b_, gamma_)) {
            found_.growth = gamma_ > 0 ? growth_class::zero : growth_class::infinite;
            found_.note = gamma_ > 0 ? "by growth alone: the coefficients grow faster than any power R^-n"
                                     : "by growth alone: the coefficients fall faster than any power R^-n";
            return;
        }
        const auto envelope = envelope_of(list_.values);
        if (envelope && envelope->uncertainty < 1) {
            found_.growth = growth_class::finite;
            found_.radius = exp(mpfr(envelope->log_radius));
            found_.uncertainty = *found_.radius * envelope->uncertainty;
            found_.kind = found_.pattern.lacunary ? singularity_kind::boundary : singularity_kind::unknown;
            found_.bound = gamma_ < -0.1  ? radius_bound::at_least
                           : gamma_ > 0.1 ? radius_bound::at_most
                                          : radius_bound::none;
            found_.note =
                "no singularity that a linear differential equation describes is seen; the radius is from the "
                "sizes of the coefficients alone";
        } else {
            found_.note =
                envelope ? "too few coefficients: their sizes give no radius to a factor of 2" : "too few coefficients";
        }
    }

    const series_list& list_;
    const task_runner& run_;
    std::vector<mpfr> b_;  ///< the coefficients of the class that the pattern found
    coefficient_class class_;
    double gamma_ = 0;
    bool drifts_ = false;
    bool transforms_seen_ = false;
    std::optional<borel_transform> transform_;
    list_verdict found_;
};

}  // namespace

list_verdict verdict_on(const series_list& list, const task_runner& run) {
    return verdict_builder(list, run).verdict();
}

}  // namespace libration::convergence
