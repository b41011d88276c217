#!/usr/bin/env python3
"""Length, damping and start of a pendulum by 60 readings, identified by plm and by SciPy's least_squares: error and time.

    pip install scipy
    cargo run --release -p plm-studies --example pictures -- --time
    python3 benches/peers/by_scipy.py

Both begin at the same guess and have the same readings, of a run with a tolerance of 1e-13. SciPy's Jacobian is by differences, as
users have it that write no derivatives; the right-hand side is that of a pendulum, of two numbers.
"""

import math
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

GRAVITY, MASS, INERTIA = 9.81, 1.0, 0.01
TRUTH = np.array([1.0, 0.2, math.radians(60.0)])
GUESS = np.array([0.7, 0.0, 0.9])
TIMES = 0.05 * np.arange(60)


def angles(unknowns, tolerance):
    """Angles of the pendulum at the times of the readings, rad."""
    length, damping, start = unknowns
    inertia = INERTIA + MASS * length * length

    def rate(_, x):
        return [x[1], -(MASS * GRAVITY * length * math.sin(x[0]) + damping * x[1]) / inertia]

    run = solve_ivp(rate, (0.0, TIMES[-1]), [start, 0.0], "DOP853", TIMES, rtol=tolerance, atol=1e-3 * tolerance)
    return run.y[0]


def main():
    """Prints the largest relative error of an unknown, and the time."""
    readings = angles(TRUTH, 1e-13)
    for tolerance in [1e-8, 1e-11]:
        best = math.inf
        for _ in range(10):
            begun = time.perf_counter()
            fit = least_squares(
                lambda unknowns: angles(unknowns, tolerance) - readings,
                GUESS,
                bounds=([0.1, -np.inf, -np.inf], [3.0, np.inf, np.inf]),
                x_scale=np.array([0.7, 0.2, 0.9]),
                xtol=1e-14,
                ftol=1e-15,
                gtol=1e-15,
            )
            best = min(best, time.perf_counter() - begun)
        error = np.max(np.abs(fit.x / TRUTH - 1.0))
        print(f"SciPy at {tolerance:g}: error {error:.1e} after {1e3 * best:.1f} ms")


if __name__ == "__main__":
    main()
