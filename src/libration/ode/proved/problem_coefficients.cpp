#include "libration/ode/proved/problem_coefficients.hpp"

#include <string>
#include <utility>

#include "libration/digits/memory_need.hpp"
#include "libration/digits/proved/printed_values.hpp"
#include "libration/ode/ball/fast_product.hpp"
#include "libration/ode/ball/taylor_expansion.hpp"
#include "libration/ode/path.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/step.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long longest_exact_series = 400;

bool is_plain_zero(const number& x) {
    const auto plain = x.plain();
    return plain && plain->coefficient == 0;
}

// The coefficients of all unknowns, one degree after the other.
template <class R, class Add>
void each_coefficient(const coefficient_request& request, const taylor_expansion<R>& of, const Add& add) {
    for (long n = request.first; n <= request.order; ++n) {
        for (int i = 0; i < static_cast<int>(request.system.unknowns().size()); ++i) {
            add(of.coefficients(i)[n], i, n);
        }
    }
}

template <class T>
void require_in_range(const T& value, const explicit_system& system, int unknown, long n) {
    if constexpr (rounding_scalar<T>) {
        if (mpfr_number_p(handle(mpfr(widen(value)))) == 0) {
            throw error(
                error_kind::range,
                "coefficient " + std::to_string(n) + " of " + system.unknowns()[static_cast<std::size_t>(unknown)].name,
                "", "is beyond the range of this scalar");
        }
    }
}

template <class T>
std::vector<wide_t<T>> flat_values(const coefficient_request& request, const taylor_expansion<T>& of) {
    std::vector<wide_t<T>> values;
    each_coefficient(request, of, [&](const T& value, int unknown, long n) {
        require_in_range(value, request.system, unknown, n);
        values.push_back(widen(value));
    });
    return values;
}

template <class T>
std::vector<complex_number<mpfr>> flat_values(const coefficient_request& request,
                                              const taylor_expansion<complex_number<T>>& of) {
    std::vector<complex_number<mpfr>> values;
    each_coefficient(request, of, [&](const complex_number<T>& value, int unknown, long n) {
        require_in_range(value.re, request.system, unknown, n);
        require_in_range(value.im, request.system, unknown, n);
        values.push_back({widen(value.re), widen(value.im)});
    });
    return values;
}

// The arrays of an expansion, one for each step of the tape.
template <class R>
void require_room(const tape& made, long order) {
    require_memory(
        "order " + std::to_string(order),
        static_cast<double>(made.steps().size()) * static_cast<double>(order + 1) * static_cast<double>(bytes_of<R>()));
}

template <class T>
std::vector<wide_t<T>> about_start(const coefficient_request& request, const tape& made,
                                   const series::block_product<T>* fast = fast_product<T>(), int more_terms = 0) {
    require_room<T>(made, request.order + more_terms);
    taylor_expansion<T> expansion(made, static_cast<int>(request.order) + more_terms, fast);
    expansion.about_start();
    return flat_values(request, expansion);
}

template <class T>
std::vector<wide_t<T>> about_time(const coefficient_request& request, const number& time) {
    require_room<T>(tape::about_points(request.system), request.order);
    const T t = constant_value<T>::of(time);
    taylor_march<T> march(request.system, fast_product<T>());
    const auto state = march.advance_to(t);
    const tape made = tape::about_points(request.system);
    taylor_expansion<T> expansion(made, static_cast<int>(request.order), fast_product<T>());
    expansion.about(t, state);
    return flat_values(request, expansion);
}

// In balls the way there is proved.
std::vector<wide_t<ball>> proved_about_time(const coefficient_request& request, const number& time,
                                            const proof_route& route) {
    require_room<ball>(tape::about_points(request.system), request.order + route.more_terms);
    proved_march march(request.system, static_cast<long>(ball::working_bits()) + 64, {}, proved_march::usual_error_bits,
                       route);
    const auto values = march.at(time);
    if (!values && march.end() == march_end::precision) {
        throw precision_exhausted("the way to the point");
    }
    if (!values) {
        throw error(error_kind::undecided, "point", "",
                    "is not reached: the steps become too small before it, as they do near a singularity");
    }
    solution_state<ball> state;
    auto next = values->begin();
    for (const auto& each : request.system.unknowns()) {
        state.emplace_back(next, next + each.order);
        next += each.order;
    }
    const tape made = tape::about_points(request.system);
    taylor_expansion<ball> expansion(made, static_cast<int>(request.order) + route.more_terms, route.product);
    expansion.about(constant_value<ball>::of(time), state);
    return flat_values(request, expansion);
}

// By the corners of the way.
template <class T>
std::vector<complex_number<mpfr>> about_point(const coefficient_request& request,
                                              const std::vector<complex_constant>& corners,
                                              const complex_constant& point) {
    require_room<complex_number<T>>(tape::about_points(request.system), request.order);
    const auto state = states_along<T>(request.system, corners, {point}).front();
    const tape made = tape::about_points(request.system);
    taylor_expansion<complex_number<T>> expansion(made, static_cast<int>(request.order));
    expansion.about(constant_value<complex_number<T>>::of(point), state);
    return flat_values(request, expansion);
}

// Which coefficients about the start are exactly 0: by fractions where they serve, else by the symmetry alone.
std::vector<bool> zeros_about_start(const coefficient_request& request, const tape& made) {
    std::vector<bool> zeros;
    try {
        if (request.order <= longest_exact_series) {
            taylor_expansion<rational> exact(made, static_cast<int>(request.order));
            exact.about_start();
            each_coefficient(request, exact, [&](const rational& c, int, long) { zeros.push_back(c == 0); });
            return zeros;
        }
    } catch (const error&) {
        zeros.clear();  // it has other numbers than fractions
    }
    for (long n = request.first; n <= request.order; ++n) {
        for (int i = 0; i < static_cast<int>(request.system.unknowns().size()); ++i) {
            const int residue = made.residue_of(i);
            zeros.push_back(residue < 0 || n % made.stride() != residue);
        }
    }
    return zeros;
}

}  // namespace

bool coefficient_request::about_start() const {
    return !at || (corners.empty() && is_plain_zero(at->im) && is_plain_zero(at->re - system.point()));
}

bool coefficient_request::complex() const { return !about_start() && (!corners.empty() || !is_plain_zero(at->im)); }

coefficient_list<mpfr> rounded_coefficients(const scalar_spec& scalar, const coefficient_request& request) {
    if (request.about_start()) {
        const tape made = tape::about_start(request.system);
        auto values = rounded_values(
            scalar, [&]<class T>() { return about_start<T>(request, made); },
            [&] { return zeros_about_start(request, made); });
        return {std::move(values), false, made.root()};
    }
    if (!request.complex()) {
        return {rounded_values(scalar, [&]<class T>() { return about_time<T>(request, request.at->re); }), false, 1};
    }
    const auto values = rounded_complex_values(
        scalar, [&]<class T>() { return about_point<T>(request, request.corners, *request.at); });
    coefficient_list<mpfr> found{{}, true, 1};
    for (const auto& each : values) {
        found.values.push_back(each.re);
        found.values.push_back(each.im);
    }
    return found;
}

coefficient_list<proved_decimal> proved_coefficients(const coefficient_request& request, long digits,
                                                     const proof_route& route) {
    if (request.complex()) {
        throw error(error_kind::argument, "point", "", "is complex, and no way to it is proved");
    }
    if (!request.about_start()) {
        return {proved_decimals(digits, [&] { return proved_about_time(request, request.at->re, route); }), false, 1};
    }
    const tape made = tape::about_start(request.system);
    auto values = proved_decimals(
        digits, [&] { return about_start<ball>(request, made, route.product, route.more_terms); },
        [&] { return zeros_about_start(request, made); });
    return {std::move(values), false, made.root()};
}

coefficient_list<rational> exact_coefficients(const coefficient_request& request) {
    if (!request.about_start()) {
        throw error(error_kind::argument, "point", "",
                    "is no point for fractions, which a solution has at its start alone");
    }
    const tape made = tape::about_start(request.system);
    require_room<rational>(made, request.order);
    taylor_expansion<rational> exact(made, static_cast<int>(request.order));
    exact.about_start();
    coefficient_list<rational> found{{}, false, made.root()};
    each_coefficient(request, exact, [&](const rational& c, int, long) { found.values.push_back(c); });
    return found;
}

}  // namespace libration::ode
