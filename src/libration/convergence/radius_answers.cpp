#include "libration/convergence/radius_answers.hpp"

#include <algorithm>
#include <utility>

#include "libration/convergence/coefficient_noise.hpp"
#include "libration/convergence/list_report.hpp"
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

// The report on a list from a file, which may end in a noise floor; a motion's coefficients are correct to the last
// digit.
template <class T>
list_report<T> report_in(const listed_series& list) {
    if (!list.written.empty()) {
        return report_on_list<T>(list.coefficients, noise_of<T>(list.written));
    }
    const coefficient_unit unit = unit_of(list.coefficients);
    return {report_on_radius(in_unit_of<T>(list.coefficients, unit), epsilon<T>()), unit, std::nullopt};
}

template <class T>
radius_answers answers_in(const listed_series& list, int root) {
    const list_report<T> found = report_in<T>(list);
    const radius_report<T>& report = found.report;
    radius_answers answers{report.pattern, found.floor_text(), {}};
    const auto in_variable = [&](const auto& estimate) {
        return in_powers_of_root(in_unit(widened(estimate), found.unit.length), root);
    };
    answers.rows.reserve(report.tests.size() + 1);
    // The radius may be out of the range of T even if the coefficients are not.
    const precision_scope scope(decimal_digits(digits<T>()) + radius_guard_digits);
    answers.rows.push_back(in_variable(report.verdict));
    for (const auto& test : report.tests) {
        answers.rows.push_back(in_variable(test));
    }
    std::string& note = answers.rows.front().note;
    if (report.verdict.radius) {
        note = report.pattern.text() + "; " + note;
    }
    if (found.floor) {
        note += "; " + answers.floor;
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

bool keeps_kind(const listed_function& function, const scalar_spec& scalar, singularity_kind kind) {
    const int order = function.parts.front().coefficients.order();
    for (const int fewer : {order - 1, order - 2, order * 4 / 5}) {
        if (fewer < 0) {
            continue;
        }
        listed_function shorter{{}, function.root};
        for (const listed_series& list : function.parts) {
            const auto& all = list.coefficients.coefficients();
            const auto count = static_cast<std::ptrdiff_t>(std::min(all.size(), static_cast<std::size_t>(fewer) + 1));
            const auto written = std::min(count, static_cast<std::ptrdiff_t>(list.written.size()));
            shorter.parts.push_back({series::power_series<mpfr>(std::vector<mpfr>(all.begin(), all.begin() + count)),
                                     {list.written.begin(), list.written.begin() + written}});
        }
        const singularity_kind found = answers_of(shorter, scalar).rows.front().kind;
        if (found != kind && (found != singularity_kind::unknown || kind == singularity_kind::pole)) {
            return false;
        }
    }
    return true;
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

radius_answers answers_of(const listed_function& function, const scalar_spec& scalar) {
    std::vector<radius_answers> parts;
    for (const listed_series& list : function.parts) {
        parts.push_back(with_scalar(scalar, 0, [&]<class T>() { return answers_in<T>(list, function.root); }));
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
