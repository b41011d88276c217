"""Prints the polynomial coefficients of plm-math: python3 minimax.py (needs mpmath; about a minute).

Each polynomial is the minimax approximation of its row in `POLYNOMIALS`, found by Remez exchange (J.-M. Muller,
Elementary Functions, 3rd ed., section 3.3). Coefficients are rounded to the type one after the other, lowest degree
first, and where the interval has one sign the rest is fitted again to what the rounding left.
The two figures per polynomial are log2 of the largest relative error of the function, ideal and rounded.
"""

from mpmath import mp, mpf, matrix, lu_solve, polyval, workprec, pi, sqrt, sin, cos, atan, asin, exp, log, log1p

mp.prec = 300
WIDER = mpf(1) + mpf(2) ** -12  # the reduced argument can exceed its nominal bound by rounding

QUARTER_TURN = (pi / 4 * WIDER) ** 2
HALF_OCTAVE = log(2) / 2 * WIDER
LOG_RANGE = ((sqrt(2) - 1) / (sqrt(2) + 1) * WIDER) ** 2


def root(f):
    """Of an odd f(x) = x g(x^2): the function g."""
    return lambda z: f(sqrt(z)) / sqrt(z) if z != 0 else mpf(1)


def two_atanh(x):
    return log1p(x) - log1p(-x)


# name: (target F, weight W, factor B, interval, terms for f64, terms for f32): |W (B p - F)| is made small.
POLYNOMIALS = {
    "SIN  sin r = r - r z p(z), z = r^2": (
        lambda z: 1 - root(sin)(z), lambda z: 1 / root(sin)(z), lambda z: z, (0, QUARTER_TURN), 6, 3),
    "COS  cos r = 1 - z/2 + z^2 p(z), z = r^2": (
        lambda z: cos(sqrt(z)) - 1 + z / 2, lambda z: 1 / cos(sqrt(z)), lambda z: z**2, (0, QUARTER_TURN), 6, 3),
    "ATAN atan u = u - u z p(z), z = u^2": (
        lambda z: 1 - root(atan)(z), lambda z: 1 / root(atan)(z), lambda z: z, (0, mpf(1) / 4), 12, 6),
    "ASIN asin s = s + s z p(z), z = s^2": (
        lambda z: root(asin)(z) - 1, lambda z: 1 / root(asin)(z), lambda z: z, (0, mpf(1) / 4), 13, 5),
    "EXP  exp r = 1 + r + r^2 p(r)": (
        lambda r: exp(r) - 1 - r, lambda r: exp(-r), lambda r: r**2, (-HALF_OCTAVE, HALF_OCTAVE), 11, 6),
    "LN   ln((1+s)/(1-s)) = 2 s + s z p(z), z = s^2": (
        lambda z: root(two_atanh)(z) - 2 if z != 0 else mpf(0), lambda z: mpf(1) / 2, lambda z: z,
        (0, LOG_RANGE), 7, 3),
}


def remez(target, weight, factor, interval, terms):
    """Coefficients and largest weighted error of the best polynomial with that many terms."""
    a, b = map(mpf, interval)
    chebyshev = lambda i, n: (a + b) / 2 - (b - a) / 2 * cos(pi * i / n)
    grid = [chebyshev(i, 60 * terms + 60) for i in range(60 * terms + 61)]
    nodes = [chebyshev(i + mpf(1) / 2, terms + 1) for i in range(terms + 1)]
    for _ in range(20):
        system, right = matrix(terms + 1, terms + 1), matrix(terms + 1, 1)
        for row, x in enumerate(nodes):
            for j in range(terms):
                system[row, j] = weight(x) * factor(x) * x**j
            system[row, terms] = (-1) ** row
            right[row] = weight(x) * target(x)
        solution = lu_solve(system, right)
        c = [solution[j] for j in range(terms)]
        error = [weight(x) * (factor(x) * polyval(c[::-1], x) - target(x)) for x in grid]
        peaks = extrema(error)
        while len(peaks) > terms + 1:
            peaks.pop(0 if abs(error[peaks[0]]) < abs(error[peaks[-1]]) else -1)
        largest = max(abs(e) for e in error)
        if len(peaks) < terms + 1 or largest < min(abs(error[i]) for i in peaks) * mpf("1.01"):
            break
        nodes = [grid[i] for i in peaks]
    return c, largest


def extrema(error):
    """Index of the largest value in each run of equal sign."""
    runs = [[0]]
    for i in range(1, len(error)):
        if error[i] * error[i - 1] < 0:
            runs.append([])
        runs[-1].append(i)
    return [max(run, key=lambda i: abs(error[i])) for run in runs]


def fit(target, weight, factor, interval, terms, bits):
    """Coefficients of `bits` bits, with the ideal and the reached error."""
    a, b = map(mpf, interval)
    fixed = []
    c, ideal = remez(target, weight, factor, interval, terms)
    while c:
        with workprec(bits):
            fixed.append(+c.pop(0))
        k = len(fixed)
        if c and a == 0:  # over a zero in the middle x^k changes sign, and the error need not alternate
            rest = lambda x: target(x) - factor(x) * polyval(fixed[::-1], x)
            again, largest = remez(rest, weight, lambda x: factor(x) * x**k, interval, terms - k)
            if largest < 2 * ideal:  # else the exchange found too few extrema, and the first fit stands
                c = again
    points = [a + (b - a) * i / 2000 for i in range(2001)]
    reached = max(abs(weight(x) * (factor(x) * polyval(fixed[::-1], x) - target(x))) for x in points)
    return fixed, ideal, reached


if __name__ == "__main__":
    for name, (target, weight, factor, interval, double, single) in POLYNOMIALS.items():
        for label, bits, terms in (("f64", 53, double), ("f32", 24, single)):
            coefficients, ideal, reached = fit(target, weight, factor, interval, terms, bits)
            print(f"{name}   {label}: 2^{float(log(ideal, 2)):.2f} 2^{float(log(reached, 2)):.2f}")
            for c in coefficients:
                print(f"    {float(c)!r},")
