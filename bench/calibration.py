"""Times `groundbeam.calibrate` beside `scipy.optimize.least_squares` with differences of the same solves.

    python bench/calibration.py             # needs the Python package groundbeam, numpy and scipy
"""

import time

import groundbeam as gb
import numpy as np
from groundbeam._solution import Solution
from scipy.optimize import least_squares

RUNS = 30
NOISE = 3e-5
"""Standard deviation of the measurements [m]."""


def model(k, mu, EI=1.28e9):
    loads = [gb.Load.point(900e3, 1.5), gb.Load.distributed(10e3, 0.0, 12.0)]
    return gb.Model(gb.Beam(12.0, EI), gb.Foundation(k, mu), loads=loads)


def segmented(values):
    ends = np.linspace(0.0, 12.0, len(values) + 1)
    segments = [
        {"from": float(a), "to": float(b), "k": float(k), "mu": 9e6}
        for a, b, k in zip(ends, ends[1:], values)
    ]
    loads = [gb.Load.point(900e3, 1.5), gb.Load.point(700e3, 7.0), gb.Load.distributed(10e3, 0.0, 12.0)]
    ground = gb.Foundation(40e6, 9e6, segments=segments)
    return gb.Model(gb.Beam(12.0, 1.28e9), ground, loads=loads)


def cases():
    yield "k, mu", model(40e6, 9e6), model(10e6, 30e6), ["k", "mu"], 13
    yield "k, mu, EI", model(40e6, 9e6), model(20e6, 15e6, 1e9), ["k", "mu", "EI"], 13
    own = 40e6 * np.exp(np.random.default_rng(2).normal(0.0, 0.3, 6))
    yield "k of 6 segments", segmented(own), segmented([30e6] * 6), [f"k[{i}]" for i in range(6)], 25


def least(job):
    """The shortest time [ms], and the result."""
    times = []
    for _ in range(RUNS):
        begin = time.perf_counter()
        result = job()
        times.append(time.perf_counter() - begin)
    return 1e3 * min(times), result


def row(name, truth, guess, unknown, count):
    at = np.linspace(0.0, 12.0, count)
    measured = truth.solve().deflection(at) + np.random.default_rng(1).normal(0.0, NOISE, count)
    start = np.log([guess._inner.number(each, None) for each in unknown])

    def residual(theta):
        numbers = [(each, float(value)) for each, value in zip(unknown, np.exp(theta))]
        return (Solution(guess._inner.solve_with(numbers, None)).deflection(at) - measured) / NOISE

    own, found = least(lambda: gb.calibrate(guess, {"deflection": (at, measured)}, unknown, noise=NOISE))
    cells = [name, f"{own:.2f}", str(found.steps)]
    for method in ("lm", "trf"):
        theirs, other = least(lambda: least_squares(residual, start, method=method))
        squares = sum(float(each @ each) for each in found.residuals.values()) / NOISE**2
        assert abs(0.5 * squares / other.cost - 1.0) < 1e-6, "both find the same minimum"
        cells.append(f"**{theirs / own:.2f}**")
    print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    print("| unknowns | calibrate ms | solves | lm / calibrate | trf / calibrate |\n|---|---|---|---|---|")
    for case in cases():
        row(*case)
