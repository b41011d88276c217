"""heyoka, which integrates by Taylor series and compiles them at run time, on the equations of src/minimal.rs.

    python3 -m venv target/tools/heyoka && target/tools/heyoka/bin/pip install heyoka==7.13.2
    target/tools/heyoka/bin/python benches/peers/by_heyoka.py target/plm/heyoka.csv
    cargo run --release -p plm-speed --bin work_precision -- --beside target/plm/heyoka.csv

Rows: scene, method, tolerance, error at the end, time in s, steps. Compilation comes before; what it takes to be called
from Python is measured by a call that has nothing to do, and taken off.
"""

import csv
import math
import sys
import time
from pathlib import Path

import heyoka as hy

GRAVITY = 9.81
REFERENCES = Path(__file__).parent.parent / "data/references.csv"


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class Point:
    """A point that moves with one angle: its place, and its first and second derivative by that angle."""

    def __init__(self, place, lever=(0.0, 0.0), lever_rate=(0.0, 0.0)):
        self.place, self.lever, self.lever_rate = place, lever, lever_rate


class Turn:
    """The direction of a bar: sine, cosine, how far it turns for a radian of the angle, and the derivative of that."""

    def __init__(self, sin, cos, ratio=1.0, ratio_rate=0.0):
        self.sin, self.cos, self.ratio, self.ratio_rate = sin, cos, ratio, ratio_rate

    def angle(self, bar):
        """The angle of a body whose bar is inclined by `bar` at its angle 0."""
        return math.remainder(math.atan2(self.sin, self.cos) - bar, math.tau)

    def point(self, begin, along, across=0.0):
        x, y = self.cos * along - self.sin * across, self.sin * along + self.cos * across
        square = self.ratio * self.ratio
        return Point(
            (begin.place[0] + x, begin.place[1] + y),
            (begin.lever[0] - self.ratio * y, begin.lever[1] + self.ratio * x),
            (
                begin.lever_rate[0] - self.ratio_rate * y - square * x,
                begin.lever_rate[1] + self.ratio_rate * x - square * y,
            ),
        )


def dyad(begin, pivot, lengths, side, sqrt):
    """Two bars from a point that moves and from a pivot to a common joint."""
    d = (pivot[0] - begin.place[0], pivot[1] - begin.place[1])
    ee, ff = lengths[0] ** 2, lengths[1] ** 2
    square = dot(d, d)
    along = 0.5 * (square + (ee - ff))
    across = side * sqrt(ee * square - along * along)
    e = ((along * d[0] - across * d[1]) / square, (along * d[1] + across * d[0]) / square)
    f = (e[0] - d[0], e[1] - d[1])
    cross = e[0] * f[1] - e[1] * f[0]

    def solve(g):
        return -dot(g, f) / cross, -dot(g, e) / cross

    u, w = solve(begin.lever)
    u_rate, w_rate = solve([begin.lever_rate[i] - u * u * e[i] + w * w * f[i] for i in (0, 1)])
    return (
        Turn(e[1] / lengths[0], e[0] / lengths[0], u, u_rate),
        Turn(f[1] / lengths[1], f[0] / lengths[1], w, w_rate),
    )


def bar(begin, turn, length):
    """A uniform bar whose mass in kg is its length in m: centre of gravity, turn, mass, inertia."""
    return turn.point(begin, 0.5 * length), turn, length, length**3 / 12.0


def eksergian(bodies, omega, moment):
    inertia = sum(m * dot(p.lever, p.lever) + j * turn.ratio * turn.ratio for p, turn, m, j in bodies)
    half_rate = sum(m * dot(p.lever, p.lever_rate) + j * turn.ratio * turn.ratio_rate for p, turn, m, j in bodies)
    return (moment - half_rate * omega * omega) / inertia


def weights(bodies):
    return sum(-m * GRAVITY * p.lever[1] for p, _, m, _ in bodies)


def four_bar(sin, cos, sqrt):
    ground, crank, pivot = Point((0.0, 0.0)), Turn(sin, cos), Point((1.0, 0.0))
    tip = crank.point(ground, 0.3)
    coupler, rocker = dyad(tip, pivot.place, (0.9, 0.7), 1.0, sqrt)
    return [bar(ground, crank, 0.3), bar(tip, coupler, 0.9), bar(pivot, rocker, 0.7)]


def slider_crank(sin, cos, sqrt):
    ground, crank = Point((0.0, 0.0)), Turn(sin, cos)
    pin = crank.point(ground, 0.2)
    rod_sin = (-0.2 / 0.6) * sin
    rod_cos = sqrt(1.0 - rod_sin * rod_sin)
    ratio = -0.2 * cos / (0.6 * rod_cos)
    rod = Turn(rod_sin, rod_cos, ratio, ((0.2 / 0.6) * sin + rod_sin * ratio * ratio) / rod_cos)
    wrist = rod.point(pin, 0.6)
    return [bar(ground, crank, 0.2), bar(pin, rod, 0.6), (wrist, rod, 0.5, 0.0)]


def andrews(sin, cos, sqrt):
    """The bodies, and the point of K3 that the spring pulls at."""
    ground, k1 = Point((0.0, 0.0)), Turn(sin, cos)
    b, c = Point((-0.03635, 0.03273)), Point((-0.06934, -0.00227))
    tip = k1.point(ground, 0.007)
    k2, k3 = dyad(tip, b.place, (0.028, 0.035), 1.0, sqrt)
    pin = k3.point(b, 0.035)
    k4, k5 = dyad(pin, c.place, (0.02, 0.04), -1.0, sqrt)
    k6, k7 = dyad(pin, c.place, (0.02, 0.04), 1.0, sqrt)
    bodies = [
        (k1.point(ground, 0.00092), k1, 0.04325, 2.194e-6),
        (k2.point(tip, 0.0115), k2, 0.00365, 4.41e-7),
        (k3.point(b, 0.01874, 0.01043), k3, 0.02373, 5.255e-6),
        (k4.point(pin, 0.01421), k4, 0.00706, 5.667e-7),
        (k5.point(c, 0.02308, 0.00916), k5, 0.0705, 1.169e-5),
        (k6.point(pin, 0.01421), k6, 0.00706, 5.667e-7),
        (k7.point(c, 0.00449, 0.01228), k7, 0.05498, 1.912e-5),
    ]
    return bodies, k3.point(b, 0.018, 0.02)


def angles_of_andrews(beta):
    bodies, _ = andrews(math.sin(beta), math.cos(beta), math.sqrt)
    quarters = (None, 2, -1, 1, 0, 2, -1)
    k2, k3, k4, k5, k6, k7 = (bodies[i][1].angle(quarters[i] * math.pi / 2) for i in range(1, 7))
    return [beta, k2 - beta, k3, k4 - k5, k5, k6 - k7, k7]


def places(bodies):
    return [coordinate for point, *_ in bodies for coordinate in point.place]


def of_one_angle(bodies, moment):
    angle, omega = hy.make_vars("angle", "omega")
    parts = bodies(hy.sin(angle), hy.cos(angle), hy.sqrt)
    moment, parts = moment(parts)
    return [(angle, omega), (omega, eksergian(parts, omega, moment))]


def spring_and_torque(parts):
    bodies, hook = parts
    length = (hook.place[0] - 0.014, hook.place[1] - 0.072)
    pull = 4530.0 * (0.07785 / hy.sqrt(dot(length, length)) - 1.0)
    return 0.033 + pull * dot(length, hook.lever), bodies


def double_pendulum():
    first, second, omega, second_omega = hy.make_vars("first", "second", "omega", "second_omega")
    a, b = 0.01 + 10.0 * 0.25 + 10.0, 0.01 + 10.0
    sin, coupling = hy.sin(first - second), 10.0 * hy.cos(first - second)
    right = -10.0 * sin * second_omega * second_omega - GRAVITY * 15.0 * hy.cos(first)
    second_right = 10.0 * sin * omega * omega - GRAVITY * 10.0 * hy.cos(second)
    determinant = a * b - coupling * coupling
    return [
        (first, omega),
        (second, second_omega),
        (omega, (b * right - coupling * second_right) / determinant),
        (second_omega, (a * second_right - coupling * right) / determinant),
    ]


def bars(x):
    (sin, cos), (second_sin, second_cos) = ((math.sin(angle), math.cos(angle)) for angle in x[:2])
    return [0.5 * cos, 0.5 * sin, cos + second_cos, sin + second_sin]


def at(bodies):
    return lambda x: places(bodies(math.sin(x[0]), math.cos(x[0]), math.sqrt))


# Equations, start, end in s, what is measured, and whether errors are relative.
SCENES = {
    "S1": (double_pendulum, [math.radians(45), 0.0, 0.0, 0.0], 1.0, bars, False),
    "S2": (
        lambda: of_one_angle(four_bar, lambda bodies: (weights(bodies), bodies)),
        [math.radians(60), 0.0],
        1.0,
        at(four_bar),
        False,
    ),
    "S5": (
        lambda: of_one_angle(andrews, spring_and_torque),
        [-0.06171389001427645, 0.0],
        0.03,
        lambda x: angles_of_andrews(x[0]),
        True,
    ),
    "S6": (
        lambda: of_one_angle(slider_crank, lambda bodies: (1.0 + weights(bodies), bodies)),
        [math.radians(60), 0.0],
        1.0,
        at(slider_crank),
        False,
    ),
}


def references(scene):
    rows = csv.reader(line for line in REFERENCES.read_text().splitlines() if not line.startswith("#"))
    return [float(row[2]) for row in rows if row[0] == scene]


def error(found, expected, relative):
    return max(abs(a - b) / (abs(b) if relative else 1.0) for a, b in zip(found, expected, strict=True))


def run(integrator, start, until):
    """Least time of many runs, and the steps of one."""

    def once(end):
        integrator.time, integrator.state[:] = 0.0, start
        begin = time.perf_counter()
        outcome = integrator.propagate_until(end)
        return time.perf_counter() - begin, outcome[3]

    for _ in range(3):
        once(until)
    seconds, spent, count = math.inf, 0.0, 0
    while count < 20 or (spent < 0.02 and count < 1000):
        last, steps = once(until)
        seconds, spent, count = min(seconds, last), spent + last, count + 1
    call = min(once(0.0)[0] for _ in range(50))
    once(until)
    return seconds - call, steps


def compiled():
    """All runs: scene, tolerance, error, integrator, start, end."""
    for scene, (equations, start, until, measured, relative) in SCENES.items():
        for k in range(8, 53):
            tolerance = 10.0 ** (-k / 4)
            integrator = hy.taylor_adaptive(equations(), start, tol=tolerance)
            run(integrator, start, until)
            off = error(measured(integrator.state), references(scene), relative)
            yield scene, tolerance, off, integrator, start, until
        print(scene, "smallest error reached at 1e-13:", f"{off:.1e}")


def main(target, rounds=3):
    """What disturbs a machine for seconds or minutes is over in another round."""
    runs = list(compiled())
    timed = [[run(integrator, start, until) for *_, integrator, start, until in runs] for _ in range(rounds)]
    target.parent.mkdir(parents=True, exist_ok=True)
    with target.open("w", newline="") as file:
        write = csv.writer(file, lineterminator="\n").writerow
        write(["scene", "method", "setting", "error", "seconds", "evaluations"])
        for (scene, tolerance, off, *_), times in zip(runs, zip(*timed, strict=True), strict=True):
            seconds, steps = min(times)
            write([scene, "heyoka", f"{tolerance:.3e}", f"{off:.3e}", f"{seconds:.3e}", steps])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
