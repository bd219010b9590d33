#include "libration/query/problem_coefficients.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "libration/digits/memory_need.hpp"
#include "libration/digits/printed_values.hpp"
#include "libration/equation/dependency.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/plane/path.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long longest_exact_series = 400;
constexpr long first_exact_order = 16;
constexpr double most_products_of_words = 3e8;  // about a second

bool is_plain_zero(const number& x) {
    const auto plain = x.plain();
    return plain && plain->coefficient == 0;
}

// The coefficients of all unknowns, ordered by degree.
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

// The arrays of an expansion, one per step of the tape.
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

// In balls, with the path to the point proved.
std::vector<wide_t<ball>> proved_about_time(const coefficient_request& request, const number& time,
                                            const proof_route& route, kept_integrations* kept) {
    require_room<ball>(tape::about_points(request.system), request.order + route.more_terms);
    const long bits = static_cast<long>(ball::working_bits()) + 64;
    std::optional<proved_march> march;
    if (kept != nullptr) {
        const bool forward = (time - request.system.point()).sign() >= 0;
        march.emplace(kept_part{kept}, request.system, bits, forward ? 1 : -1, march_watch(), route);
    } else {
        march.emplace(request.system, bits, march_watch(), proved_march::usual_error_bits, route);
    }
    const auto values = march->at(time);
    if (!values && march->end() == stop::precision) {
        throw precision_exhausted("the path to the point");
    }
    if (!values) {
        throw error(error_kind::undecided, error_subject::point, "",
                    "is not reached: the step size falls below its minimum before it (probably a singularity)");
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

// Along the corners of the path.
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

double bits_of(const rational& q) {
    return static_cast<double>(mpz_sizeinbase(mpq_numref(q.backend().data()), 2) +
                               mpz_sizeinbase(mpq_denref(q.backend().data()), 2));
}

// The approximate number of word products for a series of twice the order, with fractions twice as long as the last
// ones.
double cost_of_doubling(const tape& made, const taylor_expansion<rational>& of) {
    double most = 0;
    for (int i = 0; i < static_cast<int>(made.orders().size()); ++i) {
        for (int n = 0; n <= of.order(); ++n) {
            most = std::max(most, bits_of(of.coefficients(i)[n]));
        }
    }
    const double terms = 2.0 * of.order();
    const double words = 2 * most / 64 + 1;
    return static_cast<double>(made.steps().size()) * terms * terms / 2 * words * words;
}

// The series in fractions, up to the order or as far as it takes little time: fractions can grow with every power.
std::optional<taylor_expansion<rational>> exact_series(const tape& made, long order) {
    if (order > longest_exact_series) {
        return std::nullopt;
    }
    try {
        for (long n = std::min(order, first_exact_order);; n = std::min(order, 2 * n)) {
            taylor_expansion<rational> exact(made, static_cast<int>(n));
            exact.about_start();
            if (n == order || cost_of_doubling(made, exact) > most_products_of_words) {
                return exact;
            }
        }
    } catch (const error&) {
        return std::nullopt;  // not all its numbers are fractions
    }
}

// For each unknown, which coefficients 0 .. order about the initial point are exactly 0: by fractions as far as they
// are known, then only by the symmetry.
std::vector<std::vector<bool>> zeros_of(const explicit_system& system, long order) {
    const tape made = tape::about_start(system);
    const auto exact = exact_series(made, order);
    std::vector<std::vector<bool>> zeros(system.unknowns().size());
    for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
        const int residue = made.residue_of(i);
        for (long n = 0; n <= order; ++n) {
            zeros[static_cast<std::size_t>(i)].push_back(exact && n <= exact->order()
                                                             ? exact->coefficients(i)[n] == 0
                                                             : residue < 0 || n % made.stride() != residue);
        }
    }
    return zeros;
}

// In the order of a coefficient_list. Each independent system separately, since the fractions of one may be short.
std::vector<bool> zeros_about_start(const coefficient_request& request) {
    std::vector<std::vector<bool>> zeros(request.system.unknowns().size());
    if (request.system.singular()) {
        zeros = zeros_of(request.system, request.order);  // the powers of a part may differ from those of the whole
    } else {
        for (const closed_subsystem& part : independent_subsystems(request.system)) {
            auto of_part = zeros_of(part.system, request.order);
            for (std::size_t k = 0; k < of_part.size(); ++k) {
                zeros[part.unknowns[k]] = std::move(of_part[k]);
            }
        }
    }
    std::vector<bool> flat;
    for (long n = request.first; n <= request.order; ++n) {
        for (const auto& of_unknown : zeros) {
            flat.push_back(of_unknown[static_cast<std::size_t>(n)]);
        }
    }
    return flat;
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
            [&] { return zeros_about_start(request); });
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
                                                     const proof_route& route, kept_integrations* kept) {
    if (request.complex()) {
        throw error(error_kind::argument, error_subject::point, "", "is complex, and no way to it is proved");
    }
    if (!request.about_start()) {
        return {proved_decimals(digits, [&] { return proved_about_time(request, request.at->re, route, kept); }), false,
                1};
    }
    const tape made = tape::about_start(request.system);
    auto values = proved_decimals(
        digits, [&] { return about_start<ball>(request, made, route.product, route.more_terms); },
        [&] { return zeros_about_start(request); });
    return {std::move(values), false, made.root()};
}

coefficient_list<rational> exact_coefficients(const coefficient_request& request) {
    if (!request.about_start()) {
        throw error(error_kind::argument, error_subject::point, "",
                    "is not a point for fractions, which a solution has only at its initial point");
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
