// Made by `./run bench tuning --out include/libration/pendulum/tuning.hpp`: from where on a route costs less
// than another, on Intel(R) Xeon(R) Processor, 2026-11-22. Only costs and roundings depend on it.
#pragma once

namespace libration::pendulum::tuning {

/// Quotients of thetas instead of the recurrence: from this power on, and from this power times bits on.
inline constexpr long thetas_from_power_on_balls = 160;
inline constexpr long thetas_from_bits_on_balls = 360448;
inline constexpr long thetas_from_power_in_mpfr = 160;
inline constexpr long thetas_from_bits_in_mpfr = 65536;

/// Sums over singularities instead of the recurrence: from this power on.
inline constexpr long sums_from_power_in_double = 1024;
inline constexpr long sums_from_power_in_long_double = 512;
inline constexpr long sums_from_power_in_quad = 128;

}  // namespace libration::pendulum::tuning
