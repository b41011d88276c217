"""Constants and reference values of DoubleDouble numbers, computed by mpmath with 400 bits (pip install mpmath).

    python3 tools/double_double.py constants                      the tables of src/double_double/constants.rs
    python3 tools/double_double.py                                 tests/reference/double_double_f64.txt and double_double_f32.txt
    python3 tools/double_double.py --count 20000 --out DIR         larger ones; PLM_TWOFOLD_REFERENCE=DIR cargo test reads them

A line `= function range` opens a section. Each further line is one case: the arguments as two words each, the result as
three, each word the bits of an f64 or f32 in hex, the largest first.
"""

import argparse
import random
import struct
from pathlib import Path

from mpmath import mp, mpf, pi, sin, cos, tan, asin, acos, atan2, sqrt, exp, log, ln, floor, nint, factorial

mp.prec = 400


class Type:
    def __init__(self, name, digits, code, integer, angle, power):
        self.name, self.digits, self.code, self.integer = name, digits, code, integer
        self.angle, self.power = angle, power  # largest angle to test, exponents from -power to power

    def nearest(self, x):
        """The number of this type next to x, ties to even (all of them far from subnormal)."""
        if x == 0:
            return mpf(0)
        scale = mpf(2) ** (self.digits - mp.frexp(x)[1])
        return nint(x * scale) / scale

    def words(self, x, count):
        words = []
        for _ in range(count):
            word = self.nearest(x)
            words.append(word)
            x -= word
        return words

    def double_double(self, x):
        """x rounded to two words."""
        return sum(self.words(x, 2))

    def hex(self, words):
        pack = lambda w: struct.unpack(">" + self.integer, struct.pack(">" + self.code, float(w)))[0]
        return " ".join(f"{pack(word):x}" for word in words)

    def between(self, low, high):
        return self.double_double(mpf(low) + (mpf(high) - mpf(low)) * random.getrandbits(300) / mpf(2) ** 300)

    def sized(self, low, high):
        """Random sign, exponent and digits; now and then a low word that is much smaller, or zero."""
        x = (1 + mpf(random.getrandbits(300)) / mpf(2) ** 300) * mpf(2) ** random.randint(low, high)
        kind = random.randrange(8)
        if kind == 0:
            x = self.nearest(x)
        elif kind == 1:
            x = self.nearest(x) * (1 + random.choice((-1, 1)) * mpf(2) ** -random.randint(self.digits + 2, 90))
        return random.choice((-1, 1)) * self.double_double(x)

    def any(self):
        return self.sized(-self.power, self.power)


F64 = Type("f64", 53, "d", "Q", 1000000, 300)
F32 = Type("f32", 24, "f", "I", 1000000, 40)


def sums(t):
    a = t.any()
    kind = random.randrange(4)
    if kind == 0:
        return a, t.any()
    if kind == 1:  # nearly the same size
        return a, t.double_double(a * t.between(-2, 2))
    if kind == 2:  # the first words cancel
        return a, t.double_double(-t.nearest(a) + t.nearest(a) * mpf(2) ** -t.digits * t.between(-4, 4))
    return a, t.double_double(-a * (1 + mpf(2) ** -random.randint(1, 2 * t.digits)))


def pairs(t):
    return t.sized(-t.power // 2, t.power // 2), t.sized(-t.power // 2, t.power // 2)


def angle(t):
    kind = random.randrange(4)
    if kind == 0:
        return (t.between(-t.angle, t.angle),)
    if kind == 1:
        return (t.between(-10, 10),)
    if kind == 2:  # near multiples of a quarter turn
        k = random.randint(-int(t.angle * 2 / pi), int(t.angle * 2 / pi)) if random.randrange(2) else random.randint(-8, 8)
        if random.randrange(2):
            return (t.double_double(k * pi / 2),)
        return (t.double_double(t.nearest(k * pi / 2) * (1 + random.choice((0, 1)) * mpf(2) ** (1 - t.digits))),)
    return (t.sized(-t.power, 0),)


def within_one(t):
    kind = random.randrange(3)
    if kind == 0:
        return (t.between(-1, 1),)
    if kind == 1:  # near the ends
        return (t.double_double(random.choice((-1, 1)) * (1 - t.between(1, 2) * mpf(2) ** -random.randint(2, 2 * t.digits - 2))),)
    return (t.sized(-t.power, -1),)


def point(t):
    kind = random.randrange(3)
    if kind == 0:
        return t.between(-1, 1), t.between(-1, 1)
    if kind == 1:
        return t.sized(-20, 20), t.sized(-20, 20)
    return t.sized(-t.power // 2, t.power // 2), t.sized(-t.power // 2, t.power // 2)


def logarithm(t):
    kind = random.randrange(3)
    if kind == 0:
        return (t.between(0.01, 10),)
    if kind == 1:  # near 1
        return (t.double_double(1 + random.choice((-1, 1)) * t.between(1, 2) * mpf(2) ** -random.randint(1, 2 * t.digits - 2)),)
    return (abs(t.any()),)


SECTIONS = [
    ("add", "any", lambda a, b: a + b, sums),
    ("sub", "any", lambda a, b: a - b, lambda t: (lambda a, b: (a, -b))(*sums(t))),
    ("mul", "any", lambda a, b: a * b, pairs),
    ("div", "any", lambda a, b: a / b, pairs),
    ("sqrt", "any", sqrt, lambda t: (abs(t.any()),)),
    ("floor", "to 2^60", floor, lambda t: (t.sized(-2, 60) if random.randrange(2) else t.double_double(t.nearest(t.sized(0, t.digits)) + t.between(-1, 1) * mpf(2) ** -t.digits),)),
    ("sin", "to 1e6", sin, angle),
    ("cos", "to 1e6", cos, angle),
    ("tan", "to 1e6", tan, angle),
    ("asin", "[-1, 1]", asin, within_one),
    ("acos", "[-1, 1]", acos, within_one),
    ("atan2", "any", lambda y, x: atan2(y, x), point),
    ("exp", "normal", exp, lambda t: (t.between(-t.power * 0.69, t.power * 0.69) if random.randrange(2) else t.sized(-t.power, 1),)),
    ("ln", "any", log, logarithm),
]


def reference(t, count, out):
    random.seed(1)
    with open(out / f"double_double_{t.name}.txt", "w") as file:
        for name, range_, function, arguments in SECTIONS:
            file.write(f"= {name} {range_}\n")
            for _ in range(count):
                case = arguments(t)
                words = [word for x in case for word in t.words(x, 2)]
                assert all(sum(t.words(x, 2)) == x for x in case), (name, case)
                file.write(f"{t.hex(words)} {t.hex(t.words(function(*case), 3))}\n")


def constants():
    def literal(t, word):
        # As many digits as tell the number from its neighbours.
        if t is F64:
            return repr(float(word))
        for digits in range(1, 12):
            text = f"{float(word):.{digits}e}"
            if struct.pack("f", float(text)) == struct.pack("f", float(word)):
                break
        mantissa, exponent = text.split("e")
        return mantissa + (f"e{int(exponent)}" if int(exponent) else "")

    def table(name, doc, values, count):
        print(f"\n/// {doc}\npub(super) const {name}: Words = Words {{")
        for field, t in (("double", F64), ("single", F32)):
            print(f"    {field}: &[")
            for value in values:
                # A word below the normal numbers of f32 belongs to a term that f32 does not need.
                least = mpf(2) ** -120 if t is F32 else 0
                words = [w if abs(w) >= least else mpf(0) for w in t.words(value, count)]
                print("        " + ", ".join(literal(t, word) for word in words) + ",")
            print("    ],")
        print("};")

    table("PI_OVER_2", "pi/2 in four words.", [pi / 2], 4)
    table("LN_2", "ln 2 in three words.", [ln(2)], 3)
    table("INVERSE_FACTORIALS", "1/n! in two words each, from n = 0.", [1 / factorial(n) for n in range(29)], 2)


parser = argparse.ArgumentParser()
parser.add_argument("what", nargs="?", default="reference", choices=("reference", "constants"))
parser.add_argument("--count", type=int, default=150)
parser.add_argument("--out", type=Path, default=Path(__file__).parent.parent / "tests/reference")
arguments = parser.parse_args()
if arguments.what == "constants":
    constants()
else:
    for t in (F64, F32):
        reference(t, arguments.count, arguments.out)
