#include "libration/convergence/radius_answers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "libration/convergence/coefficient_floor.hpp"
#include "libration/convergence/coefficient_noise.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/convergence/root_variable.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::convergence {

namespace {

constexpr long uncertainty_digits = 3;

// floor(log10 |x|).
long exponent_of_ten(const mpfr& x) { return mpfr_get_si(handle(mpfr(log10(mpfr(abs(x))))), MPFR_RNDD); }

// The number of digits of x down to the last place of its uncertainty as printed; 0 or less if x is below it.
long supported_digits(const mpfr& x, const mpfr& uncertainty) {
    return exponent_of_ten(x) - exponent_of_ten(uncertainty) + uncertainty_digits;
}

// x with the digits that its uncertainty supports, and no more than requested.
std::string supported(const mpfr& x, const mpfr& uncertainty, long digits) {
    if (uncertainty == 0) {
        const integer whole = nearest_integer(x);
        return x == whole ? whole.str() : to_decimal(x, digits);
    }
    const long count = x == 0 ? 0 : supported_digits(x, uncertainty);
    return count < 1 ? "0" : to_decimal(x, std::min(count, digits));
}

// The uncertainty of the radius as printed: if the requested digits truncate it, with a unit of its last place.
mpfr printed_uncertainty(const radius_estimate<mpfr>& estimate, long digits) {
    if (supported_digits(*estimate.radius, estimate.uncertainty) <= digits) {
        return estimate.uncertainty;
    }
    const int last_place = static_cast<int>(exponent_of_ten(*estimate.radius) - digits + 1);
    return estimate.uncertainty + pow(mpfr(10), last_place);
}

// The coefficients as the tests in T take them, and a verdict on them.
template <class T>
struct judged_list {
    coefficient_unit unit;
    series::power_series<T> scaled;
    list_verdict verdict;  // in that unit
};

double as_double(const mpfr& x) { return x.convert_to<double>(); }

// The verdict on these values, or on those that T holds.
template <class T>
judged_list<T> judged(const series::power_series<mpfr>& a, double noise, double zero, bool as_written,
                      const task_runner& run) {
    judged_list<T> found{unit_of(a), series::power_series<T>::zero(0), {}};
    found.scaled = in_unit_of<T>(a, found.unit);
    series_list list{{}, noise, zero};
    if (as_written) {
        const precision_scope scope(decimal_digits(bits_for(a.order()) + 32));
        list.values = in_unit_of<mpfr>(a, found.unit).coefficients();
    } else {
        std::ranges::transform(found.scaled.coefficients(), std::back_inserter(list.values),
                               [](const T& value) { return widen(value); });
    }
    found.verdict = verdict_on(list, run);
    return found;
}

// Of a list from a file, which may end in a noise floor; a motion's coefficients are correct to the last digit.
template <class T>
judged_list<T> judged_part(const listed_series& list, std::string& floor_text, const task_runner& run) {
    if (list.written.empty()) {
        const double rounding = as_double(widen(epsilon<T>()));
        return judged<T>(list.coefficients, rounding, rounding, false, run);
    }
    const series_list written = as_written(list);
    const series::power_series<mpfr> a(written.values);
    const auto floor = written.zero > 0 ? floor_of(list.coefficients) : std::nullopt;
    if (!floor) {
        return judged<T>(a, written.noise, written.zero, true, run);
    }
    floor_text = text_of(*floor);
    std::optional<judged_list<T>> best;
    const auto relative = [](const list_verdict& v) {
        return v.radius ? as_double(mpfr(v.uncertainty / *v.radius)) : 2.0;
    };
    for (const int times : {16, 256, 4096}) {
        auto found = judged<T>(above_floor(a, *floor, times), written.noise, written.zero, true, run);
        if (!best || relative(found.verdict) < relative(best->verdict)) {
            best = std::move(found);
        }
    }
    return *std::move(best);
}

void scale_lengths(list_verdict& verdict, const mpfr& unit) {
    const auto scale = [&](complex_number<mpfr>& z) { z = z * unit; };
    if (verdict.radius) {
        *verdict.radius *= unit;
        verdict.uncertainty *= unit;
    }
    if (verdict.position) {
        scale(*verdict.position);
    }
    if (verdict.rival) {
        *verdict.rival *= unit;
    }
    for (auto& member : verdict.ring) {
        scale(member.position);
        member.uncertainty *= unit;
    }
    if (verdict.action) {
        scale(*verdict.action);
        verdict.action_uncertainty *= unit;
    }
    for (auto& each : verdict.history) {
        each.radius *= unit;
        each.uncertainty *= unit;
    }
    for (auto& each : verdict.family) {
        each = {each.real() * as_double(unit), each.imag()};
    }
    if (verdict.suspect) {
        const mpfr power = pow(unit, -verdict.suspect->index);
        verdict.suspect->predicted *= power;
        verdict.suspect->uncertainty *= power;
    }
}

// For a list in powers of x^(1/root).
void name_rival(list_verdict& verdict, int root) {
    if (verdict.rival) {
        const std::string at = to_decimal(mpfr(pow(*verdict.rival, root)), 8);
        verdict.note += verdict.exact ? "; it is not decided whether the list is singular there or first at " + at
                                      : "; doubtful nearer cluster at " + at;
    }
}

// What the verdict and its row in a table have in common.
template <class To, class From>
void copy_answer(To& to, const From& from) {
    to.radius = from.radius;
    to.uncertainty = from.uncertainty;
    to.position = from.position;
    to.exponent = from.exponent;
    to.exponent_uncertainty = from.exponent_uncertainty;
    to.kind = from.kind;
    to.count = from.count;
}

// A list that is too short for the vote: the radius of a differential approximant that all of its coefficients satisfy to
// the last bit.
template <class T>
void take_equation(list_verdict& verdict, const radius_report<T>& report) {
    for (const auto& test : report.tests) {
        if (test.radius && std::string_view(test.method).starts_with("differential-approximant") &&
            test.uncertainty <= *test.radius * epsilon<T>() * T(1024)) {
            verdict.growth = growth_class::finite;
            copy_answer(verdict, widened(test));
            verdict.exact = true;
            verdict.used = verdict.pattern.order;
            verdict.note = "the short list satisfies a linear differential equation";
            return;
        }
    }
}

template <class T>
radius_answers answers_in(const listed_series& list, int root, const task_runner& run) {
    radius_answers answers;
    judged_list<T> found = judged_part<T>(list, answers.floor, run);
    const T noise = list.written.empty() ? epsilon<T>() : noise_of<T>(list.written);
    const auto report = report_on_radius(found.scaled, noise);
    answers.verdict = std::move(found.verdict);
    const bool is_exact = !list.written.empty() && as_written(list).noise == 0;
    if (is_exact && !answers.verdict.radius && answers.verdict.growth == growth_class::unknown) {
        take_equation(answers.verdict, report);
    }
    // The radius may be out of the range of T even if the coefficients are not.
    const precision_scope scope(decimal_digits(digits<T>()) + radius_guard_digits);
    const mpfr length = widen(found.unit.length);
    scale_lengths(answers.verdict, length);
    name_rival(answers.verdict, root);
    if (answers.verdict.suspect) {
        const mpfr factor = ldexp(mpfr(1), static_cast<int>(found.unit.exponent));
        answers.verdict.suspect->predicted *= factor;
        answers.verdict.suspect->uncertainty *= factor;
    }
    if (!answers.floor.empty()) {
        answers.verdict.note += "; " + answers.floor;
    }
    answers.rows.push_back(in_powers_of_root(estimate_of(answers.verdict), root));
    for (const auto& test : report.tests) {
        answers.rows.push_back(in_powers_of_root(in_unit(widened(test), found.unit.length), root));
    }
    return answers;
}

// |sum of a_n z^n| over the last half: large for a singularity at z, whose terms all have one argument.
mpfr aligned_sum(const std::vector<listed_series>& parts, const complex_number<mpfr>& z) {
    const auto& re = parts[0].coefficients;
    const auto& im = parts[1].coefficients;
    complex_number<mpfr> power{mpfr(1)};
    complex_number<mpfr> sum{mpfr(0)};
    const int last = std::min(re.order(), im.order());
    for (int n = 0; n <= last; ++n, power = power * z) {
        if (2 * n >= last) {
            sum = sum + complex_number<mpfr>{re[n], im[n]} * power;
        }
    }
    return modulus_of(sum);
}

// Lists of real and imaginary parts have both z and its conjugate as singularities even if the whole list has only one:
// selects that one.
void choose_side(radius_estimate<mpfr>& verdict, const std::vector<listed_series>& parts) {
    if (!verdict.position || verdict.position->im == 0) {
        return;
    }
    const complex_number<mpfr> above = *verdict.position;
    const complex_number<mpfr> below{above.re, mpfr(-above.im)};
    const mpfr at_above = aligned_sum(parts, above);
    const mpfr at_below = aligned_sum(parts, below);
    if (at_below >= at_above * 2) {
        verdict.position = below;
    }
    if (at_below >= at_above * 2 || at_above >= at_below * 2) {
        verdict.count = std::max(1, verdict.count / 2);
    }
}

}  // namespace

series_list as_written(const listed_series& list) {
    const precision_scope scope(decimal_digits(bits_for(list.coefficients.order()) + 64));
    series_list found;
    std::ranges::transform(list.written, std::back_inserter(found.values),
                           [](const exact& number) { return from_exact<mpfr>(number); });
    if (list.rounded != 0) {
        const long digits = list.rounded.value_or(rounding_of(list.written));
        found.noise = digits == 0 ? 0 : std::pow(10.0, static_cast<double>(1 - digits)) / 2;
        const bool decimals = std::ranges::any_of(list.written, [](const exact& n) { return written_digits(n) > 0; });
        found.zero = decimals ? as_double(noise_of<mpfr>(list.written)) : 0;
    }
    return found;
}

radius_estimate<mpfr> estimate_of(const list_verdict& verdict) {
    radius_estimate<mpfr> row;
    row.method = "verdict";
    copy_answer(row, verdict);
    row.note =
        verdict.radius && !verdict.pattern.text().empty() ? verdict.pattern.text() + "; " + verdict.note : verdict.note;
    return row;
}

printed_estimate printed(const radius_estimate<mpfr>& estimate, long digits) {
    const auto text = [&](const mpfr& x) { return supported(x, estimate.uncertainty, digits); };
    printed_estimate shown;
    if (estimate.radius) {
        shown.radius = text(*estimate.radius);
        if (shown.radius == "0") {  // a radius is positive, however uncertain
            shown.radius = to_decimal(*estimate.radius, 1);
        }
        shown.uncertainty = to_decimal(printed_uncertainty(estimate, digits), uncertainty_digits);
    }
    if (estimate.position) {
        shown.position_re = text(estimate.position->re);
        shown.position_im = text(estimate.position->im);
    }
    if (estimate.exponent) {
        shown.exponent = supported(*estimate.exponent, estimate.exponent_uncertainty, digits);
        shown.exponent_uncertainty = to_decimal(estimate.exponent_uncertainty, uncertainty_digits);
    }
    return shown;
}

std::size_t nearest_of(const std::vector<radius_answers>& all) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto& now = all[i].rows.front();
        const auto& before = all[best].rows.front();
        if (!now.radius || !before.radius) {
            best = now.radius ? i : best;
            continue;
        }
        const bool agree = abs(*now.radius - *before.radius) <= now.uncertainty + before.uncertainty;
        best = (agree ? now.uncertainty < before.uncertainty : *now.radius < *before.radius) ? i : best;
    }
    return best;
}

radius_answers answers_of(const listed_function& function, const scalar_spec& scalar, const task_runner& run) {
    std::vector<radius_answers> parts;
    for (const listed_series& list : function.parts) {
        parts.push_back(with_scalar(scalar, 0, [&]<class T>() { return answers_in<T>(list, function.root, run); }));
    }
    const std::size_t best = nearest_of(parts);
    if (parts.size() > 1) {
        const precision_scope scope(scalar.digits + radius_guard_digits);
        auto& verdict = parts[best].rows.front();
        choose_side(verdict, function.parts);
        verdict.note += best == 0 ? "; from the real parts" : "; from the imaginary parts";
    }
    return std::move(parts[best]);
}

}  // namespace libration::convergence
