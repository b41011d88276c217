"""References of scenes S3, S4 and A01 to 20 digits (needs mpmath; a quarter of an hour, less with gmpy2).

Independent of this project: Lagrange's equations written by hand, and Gragg-Bulirsch-Stoer extrapolation (E. Hairer,
S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.9) of order 24 with 34 digits.
"""

from mpmath import asin, cos, ellipfun, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 34
G = mpf("9.81")
ROWS = 12


def chain(y):
    """Rates of the angles and angular velocities of n uniform bars of 1/n m and 1/n kg."""
    n = len(y) // 2
    l = m = mpf(1) / n
    s, c = [sin(t) for t in y[:n]], [cos(t) for t in y[:n]]
    # What hangs on bar k: the bars behind it whole, itself by its half (and by a third in its own inertia).
    weight = lambda i, j: m * l * l * ((mpf(1) / 3 if i == j else mpf(1) / 2) + n - 1 - max(i, j))
    a = [[weight(i, j) * (c[i] * c[j] + s[i] * s[j]) for j in range(n)] for i in range(n)]
    b = []
    for i in range(n):
        turn = sum(weight(i, j) * (s[i] * c[j] - c[i] * s[j]) * y[n + j] ** 2 for j in range(n) if j != i)
        b.append(-m * G * l * (mpf(1) / 2 + n - 1 - i) * c[i] - turn)
    return y[n:] + solve(a, b)


def solve(a, b):
    """Solution of a x = b by Cholesky's decomposition, in place."""
    n = len(b)
    for j in range(n):
        a[j][j] = sqrt(a[j][j] - sum(a[j][k] ** 2 for k in range(j)))
        for i in range(j + 1, n):
            a[i][j] = (a[i][j] - sum(a[i][k] * a[j][k] for k in range(j))) / a[j][j]
        b[j] = (b[j] - sum(a[j][k] * b[k] for k in range(j))) / a[j][j]
    for i in reversed(range(n)):
        b[i] = (b[i] - sum(a[k][i] * b[k] for k in range(i + 1, n))) / a[i][i]
    return b


def ladder(windows):
    """Rates of the common angle of the uprights: ((N + 1)/3 + N) angle'' = -g ((N + 1)/2 + N) cos angle."""
    n = mpf(windows)
    return lambda y: [y[1], -G * ((n + 1) / 2 + n) / ((n + 1) / 3 + n) * cos(y[0])]


def extrapolated(rate, y, until, steps):
    """The state at `until`, in so many steps, each extrapolated from the modified midpoint rule."""
    big = mpf(until) / steps
    for _ in range(steps):
        table = []
        for k in range(ROWS):
            parts = 2 * (k + 1)
            h = big / parts
            old, new = y, [a + h * f for a, f in zip(y, rate(y))]
            for _ in range(parts - 1):
                old, new = new, [a + 2 * h * f for a, f in zip(old, rate(new))]
            row = [[(a + b + h * f) / 2 for a, b, f in zip(old, new, rate(new))]]
            for j in range(1, k + 1):
                ratio = (mpf(k + 1) / (k - j + 1)) ** 2 - 1
                row.append([a + (a - b) / ratio for a, b in zip(row[j - 1], table[k - 1][j - 1])])
            table.append(row)
        y = table[-1][-1]
    return y


def show(scene, name, value):
    print(f"{scene},{name},{nstr(value, 20)}")


def main():
    n = 16
    y = extrapolated(chain, [mpf(0)] * (2 * n), 1, 500)
    x = height = mpf(0)
    for i, angle in enumerate(y[:n]):
        show("S3", f"bar[{i}].position.x", x + cos(angle) / (2 * n))
        show("S3", f"bar[{i}].position.y", height + sin(angle) / (2 * n))
        x, height = x + cos(angle) / n, height + sin(angle) / n

    angle, _ = extrapolated(ladder(2), [pi / 2, mpf(-1)], mpf("0.6"), 40)
    for i in range(3):
        show("S4", f"up[{i}].position.x", i + cos(angle) / 2)
        show("S4", f"up[{i}].position.y", sin(angle) / 2)
    for i in (1, 2):
        show("S4", f"top[{i}].position.x", i - mpf(1) / 2 + cos(angle))
        show("S4", f"top[{i}].position.y", sin(angle))

    swing = 2 * asin(sqrt(mpf(1) / 2) * ellipfun("cd", 10 * sqrt(G), m=mpf(1) / 2))
    show("A01", "tip.x", -sin(swing))
    show("A01", "tip.y", -cos(swing))


if __name__ == "__main__":
    main()
