"""Holds the walk against programs that are made with their costs: random ones, and what is to be refused.

    python3 -B tests/worst_case/check.py [SEED]
"""

import random
import sys

from program import NotUnderstood, read
from walk import Rules, Walk

ROUNDS = (5, 3, 2)
PROGRAMS = 300


class Piece:
    """A piece of code. `through` is what its best path to the end takes, `out` to a return within it, none if there is none."""

    def __init__(self, lines, through, out=None):
        self.lines, self.through, self.out = lines, through, out


class Maker:
    """Makes code from blocks, branches, loops and returns, and its costs from how they stand in each other."""

    def __init__(self, chance, best):
        self.chance, self.best, self.labels, self.made = chance, best, 0, []

    def label(self):
        self.labels += 1
        return f"label{self.labels}"

    def after(self, count, out):
        return None if out is None else count + out

    def either(self, *counts):
        counts = [count for count in counts if count is not None]
        return self.best(counts) if counts else None

    def block(self):
        count = self.chance.randrange(1, 5)
        return Piece(["nop"] * count, count)

    def leave(self):
        # The return stands under a condition.
        return Piece(["it eq", "popeq {r4, pc}"], 2, 2)

    def call(self):
        if not self.made:
            return self.block()
        name, cost = self.chance.choice(self.made)
        return Piece([f"bl {name}"], 1 + cost)

    def branch(self, depth, loops):
        one, other, there, end = self.code(depth, loops), self.code(depth, loops), self.label(), self.label()
        lines = [f"bne {there}", *one.lines, f"b {end}", f"{there}:", *other.lines, f"{end}:"]
        outs = self.either(self.after(1, one.out), self.after(1, other.out))
        return Piece(lines, self.either(one.through + 2, other.through + 1), outs)

    def loop(self, depth, loops):
        if loops == len(ROUNDS):
            return self.block()
        body, head, end = self.code(depth, loops + 1), self.label(), self.label()
        if self.chance.random() < 0.5:
            lines = [f"{head}:", f"cbz r0, {end}", *body.lines, f"b {head}", f"{end}:"]
            around, through, out = body.through + 2, 1, self.after(1, body.out)
        else:
            # A head of its own, which no loop within begins with.
            lines = [f"{head}:", "nop", *body.lines, f"bhi {head}"]
            around = through = body.through + 2
            out = self.after(1, body.out)
        again = 0 if self.best is min else ROUNDS[loops] * around
        return Piece(lines, again + through, self.after(again, out))

    def code(self, depth, loops=0):
        """Some pieces, one after the other; the last one is a block, so that every label has an instruction."""
        kinds = [self.block, self.leave, self.call]
        if depth:
            kinds += 2 * [lambda: self.branch(depth - 1, loops), lambda: self.loop(depth - 1, loops)]
        whole = Piece([], 0)
        for piece in [*(self.chance.choice(kinds)() for _ in range(self.chance.randrange(3))), self.block()]:
            out = self.either(whole.out, self.after(whole.through, piece.out))
            whole = Piece(whole.lines + piece.lines, whole.through + piece.through, out)
        return whole

    def program(self):
        """The lines of some functions, and the cost of the last."""
        lines = []
        for number in range(3):
            body = self.code(3)
            last = [] if number == 1 and self.made else ["bx lr"]
            end, count = (["bx lr"], 1) if last else ([f"b {self.made[0][0]}"], 1 + self.made[0][1])
            self.made.append((f"function{number}", self.either(body.through + count, body.out)))
            lines += [f"function{number}:", *body.lines, *end]
        return lines, self.made[-1][1]


def listing(lines):
    """The text of llvm-objdump: labels are addresses."""
    places, address = {}, 0x100
    for line in lines:
        if line.endswith(":"):
            places[line[:-1]] = address
        else:
            address += 2
    address = 0x100
    for line in lines:
        if line.startswith("function") and line.endswith(":"):
            yield f"{address:08x} <{line[:-1]}>:"
        elif not line.endswith(":"):
            mnemonic, _, operands = line.partition(" ")
            *others, last = operands.split(", ")
            if last in places:
                operands = ", ".join([*others, f"0x{places[last]:x} <{last}> @ imm = #0x2"])
            yield f"    {address:x}:      \t{mnemonic}\t{operands}"
            address += 2


def cost(lines, longest, name):
    """What the walk finds for a function."""
    functions = read(listing(lines))
    rules = Rules({f"function{number}": ROUNDS for number in range(3)}, {}, {"function9"})
    walk = Walk(functions, rules, longest)
    found = walk.call(next(function for function in functions.values() if function.name == name), None)
    return found and found.count


def check_random(seed):
    for number in range(PROGRAMS):
        for best in (min, max):
            maker = Maker(random.Random(seed * PROGRAMS + number), best)
            lines, expected = maker.program()
            found = cost(lines, best is max, maker.made[-1][0])
            assert found == expected, f"program {number} of seed {seed}: {found}, not {expected}\n" + "\n".join(lines)


def check_bytes():
    """Copies of so many bytes: words in rounds of two, the length looked at before, and a word put aside."""
    for length, expected in [(4, 3), (8, 2 + 6 + 1), (20, 2 + 2 * 6 + 1), (64, 2 + 8 * 6 + 1)]:
        call = ["function0:", f"movs r2, #{length}", "bl function1", "bx lr"]
        copied = ["str r3, [r0], #4", "str r4, [sp, #0x8]", "str r3, [r0], #4", "subs r2, #0x8", "cmp r2, #0x8"]
        copy = ["function1:", "cmp r2, #0x8", "blo end", "again:", *copied, "bhs again", "end:", "bx lr"]
        functions = read(line.replace("<function1>", "<memcpy>") for line in listing(call + copy))
        walk = Walk(functions, Rules({}, {}, set()), True)
        found = walk.call(functions[0x100], None).count
        assert found == 3 + expected, f"a copy of {length} bytes: {found}, not {3 + expected}"


def check_refusals():
    refused = {
        "calls itself": ["function0:", "bl function0", "bx lr"],
        "what is not known": ["function0:", "blx r3", "bx lr"],
        "nothing bounds": ["function9:", "label0:", "nop", "bne label0", "bx lr"],
        "is entered at": ["function0:", "beq label1", "label0:", "nop", "label1:", "bne label0", "bx lr"],
    }
    for reason, lines in refused.items():
        try:
            found = cost(lines, True, lines[0][:-1])
        except NotUnderstood as refusal:
            assert reason in str(refusal), f"{refusal}, not: {reason}"
        else:
            raise AssertionError(f"{reason}: {found}")
    left_out = ["function9:", "bx lr", "function0:", "beq label0", "nop", "bl function9", "label0:", "bx lr"]
    assert cost(left_out, True, "function0") == 2, "a path that is left out"


if __name__ == "__main__":
    chosen = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    check_random(chosen)
    check_bytes()
    check_refusals()
    print(f"the walk: {PROGRAMS} random programs of seed {chosen} have the paths that they were made with")
