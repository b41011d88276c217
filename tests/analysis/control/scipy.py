"""Riccati's equations, sampling, zeros and responses by scipy, for tests/analysis/control: python3 scipy.py > scipy.json

Each system is one of Newton's: places and velocities, with random symmetric stiffness and damping, so that sizes differ as those of mechanisms.
"""

import json
import sys

# This file is named like the package: its own folder must not be looked at for it.
sys.path = [place for place in sys.path[1:]]
import numpy as np
import scipy
from scipy import linalg, signal

random = np.random.default_rng(20241127)


def mechanism(n, m, p, stiff):
    """A, B, C of n freedoms, m inputs, p outputs."""
    mass = np.diag(random.uniform(0.5, 3.0, n))
    root = random.normal(size=(n, n))
    stiffness = root @ root.T * stiff - 2.0 * np.eye(n)
    damping = 0.1 * np.eye(n)
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]])
    b = np.vstack([np.zeros((n, m)), np.linalg.solve(mass, random.normal(size=(n, m)))])
    c = random.normal(size=(p, 2 * n))
    return a, b, c


def rows(matrix):
    return [[float(entry) for entry in row] for row in np.atleast_2d(matrix)]


def parts(numbers):
    ordered = sorted(numbers, key=lambda number: (round(abs(number), 9), number.imag))
    return [[float(number.real), float(number.imag)] for number in ordered]


cases = []
for n, m, p, stiff in [(1, 1, 1, 0.5), (2, 1, 2, 1.0), (2, 2, 1, 100.0), (3, 1, 2, 30.0), (4, 2, 3, 1e4)]:
    a, b, c = mechanism(n, m, p, stiff)
    q, r = c.T @ c, np.diag(random.uniform(0.1, 2.0, m))
    s = 0.05 * random.normal(size=(2 * n, m))
    q = q + s @ np.linalg.inv(r) @ s.T
    period = 0.02
    sampled = signal.cont2discrete((a, b, c, np.zeros((p, m))), period)
    ad, bd = sampled[0], sampled[1]
    frequencies = [0.3, 1.7, 6.0, 40.0]
    gain = [complex((c[:1] @ np.linalg.solve(1j * w * np.eye(2 * n) - a, b[:, :1]))[0, 0]) for w in frequencies]
    # Zeros are the finite eigenvalues of Rosenbrock's pencil.
    pencil = np.block([[a, b[:, :1]], [c[:1], np.zeros((1, 1))]])
    unit = np.diag([1.0] * (2 * n) + [0.0])
    alpha, beta = linalg.eig(pencil, unit, right=False, homogeneous_eigvals=True)
    zeros = [x / y for x, y in zip(alpha, beta) if abs(y) > 1e-9 * abs(x)]
    cases.append(
        {
            "a": rows(a), "b": rows(b), "c": rows(c), "q": rows(q), "r": rows(r), "n": rows(s),
            "care": rows(linalg.solve_continuous_are(a, b, q, r, s=s)),
            "dare": rows(linalg.solve_discrete_are(ad, bd, q, r, s=s)),
            "period": period, "ad": rows(ad), "bd": rows(bd),
            "frequencies": frequencies, "response": [[g.real, g.imag] for g in gain], "zeros": parts(zeros),
        }
    )

print(json.dumps({"scipy": scipy.__version__, "cases": cases}))
