// Several doubles as one number, so that what is written for every field computes several solutions at once.
#pragma once

#include <array>
#include <cstddef>

namespace libration::ode {

/// The number of solutions in lock step, a multiple of the lanes of every SIMD vector of doubles.
inline constexpr std::size_t batch_lanes = 16;

/// Doubles side by side. Each operation is that of double in each lane, rounded separately: a lane depends on no other
/// one, and has the bits that double would have.
struct alignas(64) lane_numbers {
    std::array<double, batch_lanes> lane{};

    lane_numbers() = default;
    /// The same number in all lanes.
    lane_numbers(double all) { lane.fill(all); }  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)

    double& operator[](std::size_t i) { return lane[i]; }
    const double& operator[](std::size_t i) const { return lane[i]; }

    lane_numbers& operator+=(const lane_numbers& other) {
        for (std::size_t i = 0; i < batch_lanes; ++i) {
            lane[i] += other.lane[i];
        }
        return *this;
    }
    lane_numbers& operator-=(const lane_numbers& other) {
        for (std::size_t i = 0; i < batch_lanes; ++i) {
            lane[i] -= other.lane[i];
        }
        return *this;
    }
    lane_numbers& operator*=(const lane_numbers& other) {
        for (std::size_t i = 0; i < batch_lanes; ++i) {
            lane[i] *= other.lane[i];
        }
        return *this;
    }
    lane_numbers& operator/=(const lane_numbers& other) {
        for (std::size_t i = 0; i < batch_lanes; ++i) {
            lane[i] /= other.lane[i];
        }
        return *this;
    }
    friend lane_numbers operator+(const lane_numbers& a, const lane_numbers& b) {
        lane_numbers result = a;
        return result += b;
    }
    friend lane_numbers operator-(const lane_numbers& a, const lane_numbers& b) {
        lane_numbers result = a;
        return result -= b;
    }
    friend lane_numbers operator*(const lane_numbers& a, const lane_numbers& b) {
        lane_numbers result = a;
        return result *= b;
    }
    friend lane_numbers operator/(const lane_numbers& a, const lane_numbers& b) {
        lane_numbers result = a;
        return result /= b;
    }
    friend lane_numbers operator-(const lane_numbers& a) {
        lane_numbers result;
        for (std::size_t i = 0; i < batch_lanes; ++i) {
            result.lane[i] = -a.lane[i];
        }
        return result;
    }
    /// Whether the numbers are the same in every lane.
    friend bool operator==(const lane_numbers& a, const lane_numbers& b) { return a.lane == b.lane; }
};

static_assert(sizeof(lane_numbers) == batch_lanes * sizeof(double));

}  // namespace libration::ode
