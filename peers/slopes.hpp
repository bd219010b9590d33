// The right-hand sides of the problems of the benchmark `equations`, for solvers of first-order systems: the slopes of
// a state x1, x1', x2, x2', ...
#pragma once

#include <cmath>

namespace peers {

template <class T>
using slope_function = void (*)(const T* x, T* slope);

template <class T>
void lorenz(const T* x, T* slope) {
    slope[0] = 10 * (x[1] - x[0]);
    slope[1] = x[0] * (28 - x[2]) - x[1];
    slope[2] = x[0] * x[1] - 8 * x[2] / 3;
}

template <class T>
void kepler(const T* x, T* slope) {
    using std::sqrt;
    const T square = x[0] * x[0] + x[2] * x[2];
    const T cube = square * sqrt(square);
    slope[0] = x[1];
    slope[1] = -x[0] / cube;
    slope[2] = x[3];
    slope[3] = -x[2] / cube;
}

template <class T>
void pendulum(const T* x, T* slope) {
    using std::sin;
    slope[0] = x[1];
    slope[1] = -sin(x[0]);
}

template <class T>
void four_body(const T* x, T* slope) {
    using std::sqrt;
    for (int i = 0; i < 16; i += 2) {
        slope[i] = x[i + 1];
        slope[i + 1] = T(0);
    }
    for (int i = 0; i < 16; i += 4) {
        for (int j = i + 4; j < 16; j += 4) {
            const T dx = x[j] - x[i];
            const T dy = x[j + 2] - x[i + 2];
            const T square = dx * dx + dy * dy;
            const T cube = square * sqrt(square);
            const T fx = dx / cube;
            const T fy = dy / cube;
            slope[i + 1] += fx;
            slope[i + 3] += fy;
            slope[j + 1] -= fx;
            slope[j + 3] -= fy;
        }
    }
}

}  // namespace peers
