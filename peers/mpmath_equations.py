#!/usr/bin/env python3
# Initial value problems by mpmath's odefun, Taylor series in any precision, for the benchmark `equations`.
#
#   stdin    problem digits end count, then count starts: x, x', y, y', ...
#   stdout   the CPU time in nanoseconds, then count values at the end
import sys
import time

import mpmath


def lorenz(t, x):
    return [10 * (x[1] - x[0]), x[0] * (28 - x[2]) - x[1], x[0] * x[1] - 8 * x[2] / 3]


def kepler(t, x):
    cube = (x[0] * x[0] + x[2] * x[2]) ** mpmath.mpf(1.5)
    return [x[1], -x[0] / cube, x[3], -x[2] / cube]


def pendulum(t, x):
    return [x[1], -mpmath.sin(x[0])]


def four_body(t, x):
    slope = [x[i + 1] if i % 2 == 0 else mpmath.mpf(0) for i in range(16)]
    for i in range(0, 16, 4):
        for j in range(i + 4, 16, 4):
            dx, dy = x[j] - x[i], x[j + 2] - x[i + 2]
            cube = (dx * dx + dy * dy) ** mpmath.mpf(1.5)
            slope[i + 1] += dx / cube
            slope[i + 3] += dy / cube
            slope[j + 1] -= dx / cube
            slope[j + 3] -= dy / cube
    return slope


words = sys.stdin.read().split()
mpmath.mp.dps = int(words[1])
slope = {"lorenz": lorenz, "kepler": kepler, "pendulum": pendulum, "four_body": four_body}[words[0]]
start = [mpmath.mpf(word) for word in words[4:4 + int(words[3])]]
begin = time.process_time()
values = mpmath.odefun(slope, 0, start)(mpmath.mpf(words[2]))
print((time.process_time() - begin) * 1e9)
for value in values:
    print(mpmath.nstr(value, mpmath.mp.dps + 5))
