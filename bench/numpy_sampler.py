#!/usr/bin/env python3
"""theta and omega on an array of NumPy: the sampler of the package compared with scipy.special.ellipj with arcsin.

    ./run python && PYTHON bench/numpy_sampler.py

where PYTHON has the wheel, NumPy and SciPy. Both sides in turns in one process on one thread; medians of nine. The
two are compared first: SciPy loses some digits, but no more than 10^-12 here.
"""

import statistics
import time

import libration
import numpy
import scipy
from scipy.special import ellipj

POINTS = 10**6
ROUNDS = 9
ENERGY = "1.71"


def main():
    swing = libration.motion(energy=ENERGY)
    times = numpy.linspace(0, 10, POINTS)
    parameter = float(ENERGY) / 2
    k = numpy.sqrt(parameter)
    complement = numpy.sqrt(1 - parameter)

    def ours():
        return swing(times)

    # From rest at the top of the arc: theta = 2 asin(k cd), omega = -2 k k' sd.
    def theirs():
        sn, cn, dn, _ = ellipj(times, parameter)
        return 2 * numpy.arcsin(k * cn / dn), -2 * k * complement * sn / dn

    for mine, other in zip(ours(), theirs()):
        assert numpy.max(numpy.abs(mine - other)) < 1e-12

    def seconds(work):
        begin = time.perf_counter()
        work()
        return time.perf_counter() - begin

    rounds = [(seconds(ours), seconds(theirs)) for _ in range(ROUNDS)]
    ratios = sorted(other / mine for mine, other in rounds)
    print(f"theta and omega at {POINTS} times, E = {ENERGY}, NumPy {numpy.__version__}, SciPy {scipy.__version__}")
    for name, column in (("libration", 0), ("scipy.special.ellipj", 1)):
        print(f"{name:<22}{statistics.median(row[column] for row in rounds) / POINTS * 1e9:8.1f} ns a time")
    print(f"ratio {statistics.median(ratios):.0f}, from {ratios[0]:.0f} to {ratios[-1]:.0f}")


if __name__ == "__main__":
    main()
