"""Reference values of the scenes with contact (docs/src/running/contact-peers.md): closed forms, and quadratures with 30 digits.

    python3 -m pip install mpmath==1.4.1
    python3 benches/data/contact.py > benches/data/contact.csv

Nothing here is shared with plm. A row has the scene, the name of a value, and the value in SI units.
"""

import mpmath as mp

mp.mp.dps = 30
GRAVITY = mp.mpf("9.81")


def block():
    """A block that is pushed by 99 % of what friction can bear: it stays."""
    yield "x", mp.mpf(0)


def oscillator():
    """1 kg on 100 N/m, released at 0.1 m, against 0.981 N: half cosines around +-F/k until the turning point is within F/k."""
    omega, band, x, begin = mp.mpf(10), mp.mpf("0.00981"), mp.mpf("0.1"), mp.mpf(0)
    while abs(x) > band:
        centre = mp.sign(x) * band
        if begin <= 1 < begin + mp.pi / omega:
            yield "x_at_1", centre + (x - centre) * mp.cos(omega * (1 - begin))
        x, begin = 2 * centre - x, begin + mp.pi / omega
    yield "rest_time", begin
    yield "x", x


def ball():
    """A ball that falls 1 m, with a restitution of 0.8: its height at 3 s, and when it comes to rest."""
    e, fall = mp.mpf("0.8"), mp.sqrt(2 / GRAVITY)
    begin, speed = fall, e * GRAVITY * fall
    for k in range(6):
        yield f"impact_{k}", begin
        begin, speed = begin + 2 * speed / GRAVITY, e * speed
    begin, speed = fall, e * GRAVITY * fall
    while begin + 2 * speed / GRAVITY < 3:
        begin, speed = begin + 2 * speed / GRAVITY, e * speed
    yield "y", speed * (3 - begin) - GRAVITY * (3 - begin) ** 2 / 2
    yield "rest_time", fall * (1 + e) / (1 - e)


def rocking():
    """Housner's block, 0.2 m by 1 m, tilted by half of alpha: quarter periods by quadrature, the angle at 1.2 s by Taylor series."""
    b, h = mp.mpf("0.1"), mp.mpf("0.5")
    alpha, radius = mp.atan(b / h), mp.hypot(b, h)
    square = 3 * GRAVITY / (4 * radius)
    ratio = 1 - mp.mpf(3) / 2 * mp.sin(alpha) ** 2

    def quarter(amplitude):
        # From the turning point theta = a: with theta = a - s^2 the integrand is smooth. omega^2 = 2 p^2 (cos A - cos(A + s^2)),
        # A = alpha - a, and the difference of cosines is 2 sin(A + s^2/2) sin(s^2/2).
        def integrand(s):
            half = s * s / 2
            return mp.sqrt(2 / (square * mp.sin(alpha - amplitude + half) * mp.sinc(half)))

        return mp.quad(integrand, mp.linspace(0, mp.sqrt(amplitude), 5))

    amplitude = alpha / 2
    time = quarter(amplitude)
    yield "energy_ratio", ratio**2
    for k in range(4):
        yield f"impact_{k}", time
        # Energy: omega^2 = 2 p^2 (cos(alpha - a) - cos alpha), and omega falls to `ratio` times itself.
        level = mp.cos(alpha) + ratio**2 * (mp.cos(alpha - amplitude) - mp.cos(alpha))
        amplitude = alpha - mp.acos(level)
        yield f"amplitude_{k}", amplitude
        leg = quarter(amplitude)
        if k == 1:
            # After the second impact it turns to the first side: at 1.2 s from its turning point.
            def motion(t, y):
                return [y[1], -square * mp.sin(alpha - y[0])]

            turn = mp.odefun(motion, 0, [amplitude, mp.mpf(0)])
            yield "angle", turn(abs(mp.mpf("1.2") - time - leg))[0]
        time += 2 * leg


def slider_crank():
    """Crank 0.1 m (0.02 kg m^2), rod 0.3 m (0.5 kg), slider 2 kg with 3 N against it; 20 rad/s at 1 rad: the angle at 1 s."""
    r, l, rod, slider, inertia, friction = (mp.mpf(s) for s in ("0.1", "0.3", "0.5", "2", "0.02", "3"))

    def shape(phi):
        """Derivatives by phi of the slider's place, of the rod's centre and of its angle, and theirs again."""
        s, c = mp.sin(phi), mp.cos(phi)
        sin = r * s / l
        cos = mp.sqrt(1 - sin * sin)
        turn = -r * c / (l * cos)
        turn_rate = r * s / (l * cos) - turn * turn * sin / cos
        x = [-r * s - r * c * sin / cos]
        x.append(-r * c + r * s * sin / cos - r * c * (r * c / l) / cos**3)
        return x, (turn, turn_rate), (s, c, sin, cos)

    def acceleration(phi, omega, sign):
        x, (turn, turn_rate), (s, c, _, _) = shape(phi)
        # Centre of the rod: half way between crank pin (r c, r s) and slider (x, 0).
        gx, gy = ((-r * s + x[0]) / 2, r * c / 2)
        gx_rate, gy_rate = ((-r * c + x[1]) / 2, -r * s / 2)
        own = rod * l * l / 12
        mass = inertia + slider * x[0] ** 2 + rod * (gx * gx + gy * gy) + own * turn**2
        half = slider * x[0] * x[1] + rod * (gx * gx_rate + gy * gy_rate) + own * turn * turn_rate
        return (-half * omega**2 - sign * friction * x[0]) / mass

    # Between dead centres the friction is smooth. The way is the variable: time and speed are integrated over the angle.
    phi, time, omega = mp.mpf(1), mp.mpf(0), mp.mpf(20)
    mp.mp.dps = 20
    while True:
        to = (mp.floor(phi / mp.pi + mp.mpf("1e-12")) + 1) * mp.pi
        sign = mp.sign(shape((phi + to) / 2)[0][0])
        begin = phi

        def motion(way, y):
            return [1 / y[1], acceleration(begin + way, y[1], sign) / y[1]]

        solve = mp.odefun(motion, 0, [time, omega])
        end, speed = solve(to - phi)
        if end > 1:
            way = mp.findroot(lambda s: solve(s)[0] - 1, (to - phi) * (1 - time) / (end - time))
            yield "angle", phi + way
            yield "omega", solve(way)[1]
            return
        phi, time, omega = to, end, speed


print("scene,name,value")
for scene in (block, oscillator, ball, rocking, slider_crank):
    for name, value in scene():
        print(f"{scene.__name__.replace('_', '-')},{name},{mp.nstr(value, 17)}")
