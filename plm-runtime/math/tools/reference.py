"""Writes the reference values of plm-math, computed by mpmath with 200 bits and more (pip install mpmath).

    python3 tools/reference.py                              the tables in tests/reference/, f64.txt and f32.txt
    python3 tools/reference.py --count 20000 --out DIR      larger ones; PLM_MATH_REFERENCE=DIR cargo test reads them

A line `= function range` opens a section. Each further line is one case: the bits of the arguments in hex, the bits of
the result rounded towards zero, and the rest of the result in 1/4096 units in the last place (three hex digits).
"""

import argparse
import random
import struct
from pathlib import Path

from mpmath import mp, mpf, pi, sin, cos, tan, asin, acos, atan, atan2, sqrt, exp, log, hypot, floor, nint

mp.prec = 200
WIDE = 1400  # bits that hold a reduction of the largest double modulo pi


class Type:
    def __init__(self, name, digits, top, pack, unpack, bound, hardest):
        self.name, self.digits, self.top = name, digits, top  # top: the largest number is below 2^top
        self.pack, self.unpack, self.bound, self.hardest = pack, unpack, bound, hardest
        self.bottom = 3 - top - digits  # exponent of the smallest subnormal number

    def bits(self, x):
        """Bits of x rounded towards zero, and what is left in 1/4096 of its last place."""
        if abs(x) >= mpf(2) ** self.top:
            return self.pack(mpf("inf") if x > 0 else mpf("-inf")), 0
        if x == 0:
            return self.pack(mpf(0)), 0
        exponent = max(mp.frexp(x)[1] - self.digits, self.bottom)
        scaled = abs(x) * mpf(2) ** -exponent
        whole = floor(scaled)
        sign = 0 if x > 0 else self.pack(mpf("-inf")) ^ self.pack(mpf("inf"))
        return self.pack(whole * mpf(2) ** exponent) | sign, int((scaled - whole) * 4096)

    def nearest(self, x):
        """The number of this type next to x, towards zero, by its bits."""
        return self.unpack(self.bits(x)[0])

    def power(self, low, high):
        """A random number with an exponent between low and high, and a random sign."""
        x = mpf(random.getrandbits(self.digits) | 1 << self.digits - 1) * mpf(2) ** (1 - self.digits)
        return self.nearest(random.choice((1, -1)) * x * mpf(2) ** random.randint(low, high))

    def between(self, low, high):
        return self.nearest(mpf(low) + (mpf(high) - mpf(low)) * random.getrandbits(64) / 2**64)


def converter(code, integer, size):
    def pack(x):
        return struct.unpack(">" + integer, struct.pack(">" + code, float(x)))[0]

    def unpack(bits):
        return mpf(struct.unpack(">" + code, struct.pack(">" + integer, bits))[0])

    return pack, unpack


F64 = Type("f64", 53, 1024, *converter("d", "Q", 8), mpf(411774), mpf(6381956970095103) * mpf(2) ** 797)
F32 = Type("f32", 24, 128, *converter("f", "I", 4), mpf(402), mpf(16367173) * mpf(2) ** 72)


def angles(t, count):
    """Half of them next to multiples of pi/2, where all bits of the reduction count."""
    last = int(t.bound / (pi / 2))
    for i in range(count):
        if i < count // 8:
            yield t.nearest((i + 1) * pi / 2)
        elif i < count // 2:
            k = random.randint(1, last)
            yield t.nearest(k * pi / 2 * (1 + random.choice((0, 1)) * mpf(2) ** (1 - t.digits)))
        elif i < 3 * count // 4:
            yield t.between(-10, 10)
        else:
            yield t.between(-t.bound, t.bound) if i % 2 else t.power(-40, 0)
    yield from (t.bound, -t.bound, t.nearest(t.bound / 3))


def large_angles(t, count):
    yield from (t.hardest, -t.hardest, t.nearest(mpf(2) ** t.top * (1 - mpf(2) ** -t.digits)))
    for i in range(count):
        lowest = mp.frexp(t.bound)[1]
        if i % 3 == 0:
            yield t.nearest(nint(abs(t.power(lowest, lowest + 40))) * pi / 2)
        else:
            yield t.power(lowest, t.top - 1)


def any_number(t, count):
    for i in range(count):
        yield t.power(t.bottom, t.top - 1) if i % 2 else t.power(-8, 8)


def ratio(t, count):
    for i in range(count):
        if i % 3 == 0:
            yield t.between(-1, 1)
        elif i % 3 == 1:
            yield t.nearest(random.choice((1, -1)) * (1 - abs(t.power(-t.digits, -1))))
        else:
            yield t.nearest(t.power(-30, -1))
    yield from map(mpf, (0.5, -0.5, 1, -1))


def exponents(t, count):
    limit = t.top * log(2)
    for i in range(count):
        if i % 3 == 0:
            yield t.between(-limit, limit)
        else:
            yield t.between(-1, 1) if i % 3 == 1 else t.power(-60, 0)


def tiny_exponents(t, count):
    for _ in range(count):
        yield t.between((t.bottom + 2) * log(2), (t.bottom + t.digits + 1) * log(2))


def positive(t, count):
    for i in range(count):
        yield t.between(0.5, 2) if i % 3 == 0 else abs(t.power(t.bottom, t.top - 1) if i % 3 == 1 else t.power(-8, 8))


def pairs(t, count):
    for i in range(count):
        if i % 4 == 0:
            yield t.power(t.bottom, t.top - 3), t.power(t.bottom, t.top - 3)
        elif i % 4 == 1:
            exponent = random.randint(t.bottom + t.digits, t.top - 5)
            yield t.power(exponent - 2, exponent + 2), t.power(exponent - 2, exponent + 2)
        else:
            yield t.power(-4, 4), t.power(-4, 4)


def powers(limit):
    def arguments(t, count):
        for i in range(count):
            yield (t.power(-2, 2) if i % 2 else t.power(-1, 0)), mpf(random.randint(-limit, limit))

    return arguments


def halves(t, count):
    for i in range(count):
        yield t.nearest(nint(t.power(0, t.digits + 1)) / 2) if i % 2 else t.power(-3, t.digits + 2)


def atan2_of(y, x):
    return atan2(y, x)


SECTIONS = [  # function, range, result, arguments, share of the count
    ("sin", "direct", sin, angles, 1), ("sin", "large", sin, large_angles, 0.5),
    ("cos", "direct", cos, angles, 1), ("cos", "large", cos, large_angles, 0.5),
    ("tan", "direct", tan, angles, 1), ("tan", "large", tan, large_angles, 0.5),
    ("asin", "all", asin, ratio, 1), ("acos", "all", acos, ratio, 1), ("atan", "all", atan, any_number, 1),
    ("atan2", "all", atan2_of, pairs, 1), ("sqrt", "all", sqrt, positive, 0.5),
    ("exp", "normal", exp, exponents, 1), ("exp", "subnormal", exp, tiny_exponents, 0.25),
    ("ln", "all", log, positive, 1), ("hypot", "all", hypot, pairs, 1),
    ("powi", "|n|<=4", lambda x, n: x ** int(n), powers(4), 0.5),
    ("powi", "|n|<=16", lambda x, n: x ** int(n), powers(16), 0.5),
    ("abs", "all", abs, any_number, 0.1), ("floor", "all", floor, halves, 0.25),
    ("round_ties_even", "all", nint, halves, 0.25),
    ("copysign", "all", lambda x, s: abs(x) if s > 0 else -abs(x), pairs, 0.1),
    ("min", "all", min, pairs, 0.1), ("max", "all", max, pairs, 0.1),
]


def write(t, count, path):
    digits = (t.digits + 11) // 4
    with open(path, "w") as out:
        for function, label, result, arguments, share in SECTIONS:
            out.write(f"= {function} {label}\n")
            random.seed(f"{t.name} {function} {label}")
            for case in arguments(t, int(count * share)):
                case = case if isinstance(case, tuple) else (case,)
                mp.prec = WIDE if label in ("direct", "large") else 200
                value, rest = t.bits(result(*case))
                mp.prec = 200
                words = [t.pack(x) for x in case] + [value]
                out.write(" ".join(f"{w:0{digits}x}" for w in words) + f" {rest:03x}\n")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=240)
    parser.add_argument("--out", type=Path, default=Path(__file__).parent.parent / "tests" / "reference")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for t in (F64, F32):
        write(t, options.count, options.out / f"{t.name}.txt")
