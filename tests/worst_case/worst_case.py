"""Instructions of a step at most: the longest path through the machine code of examples/firmware, beside what was measured.

    python3 -B tests/worst_case/worst_case.py OBJDUMP PROGRAM REPORT [PROGRAM REPORT]...

OBJDUMP is that of LLVM, REPORT what the program printed. For each report it writes a file with the ending `.worst` beside it, with
the name of each mechanism, instructions of its `step_rk4` at most, and those while angles are of few turns.
"""

import pathlib
import re
import subprocess
import sys

from constants import Constants
from program import NotUnderstood, read
from walk import Rules, Walk, copies_memory, short

# SysTick's counter, which is read before a step and after it: examples/firmware/machine/src/bare/cortex_m.rs.
COUNTER = 0xE000E018

# Rounds of loops at most, of those within others after them.
ROUNDS = {
    # Bodies whose turns are counted or remembered. A table is gone through once, by rounds that go on at the outer head or, past
    # what is not due, at an inner one; the longest path has all at the outer one. Of a body, the coordinates of a chart that are
    # its angle: one at most.
    "FourBar::update": (3, 1),
    "Limits::update": (3, 1),
    "SliderCrank::update": (3, 1),
    "Andrews::update": (7, 1),
    # Conditions of the arm, which are gone through once more than there are: plm_runtime::events::switch_each.
    "step::arrive": (5,),
    # Angles side by side: plm_math::sin_cos_lanes.
    "sin_cos::sin_cos_each": (8,),
}
# Bytes at most that copies of words leave to one of bytes.
RESTS = {"__aeabi_memcpy4": 3, "__aeabi_memcpy8": 3}
# A step that comes there ends in a fault.
FAULTS = {"method::unhealthy"}
# Modes by events, which steps of Moreau and Jean have not: their discrete state says so, and their guards are then constants. Without
# conditions of its own a mechanism then has no event.
EVENTS = {"multipliers::multipliers_above", "violated::switch_violated", "impact::is_shared"}
# The same of a mechanism whose events set states: plm_runtime::contact::event::Event::commit finds modes, and Names::marked names
# conditions that switch for ever, in a fault.
SETTING = {"multipliers::multipliers_above", "impact::is_shared", "_::commit", "Names::marked"}
# Sines of angles of 64 turns and more, in f64 of 65536. A state has its angles within three quarters of a turn.
FAR_TURNED = {"sin_cos::sin_cos_large", "sin_cos::sin_cos_each"}
# Mechanisms whose steps are those of Moreau and Jean, which are no straight line, with their rows of contact.
STEPPED = {"four-bar with limits": 2, "rack with backlash": 2, "ratchet": 1}
# Of these, mechanisms whose events set states.
SETTERS = {"ratchet"}
# Rules of steps that are a straight line, and of that line alone.
LINE_STEPS, LINE = "steps", "line"
# Where a step goes that is no straight line, or has something to do after it.
ASIDE = {"step::rk4", "step::arrive"}


def rounds_of(rows):
    """Rounds of the loops of a step of Moreau and Jean: rows, rounds of their small problem, sweeps after these."""
    return ROUNDS | {
        "solver::look": (rows, rows),
        "solver::solve": (4*rows + 2, rows, rows),
        "solver::swept": (32, rows, rows),
        "multipliers::equation": (rows, rows),
        # Five guards, which are gone through once more than there are.
        "violated::switch_violated": (6, 5),
        # An event sets the tooth, the next round finds the side of its condition, the last one that nothing else follows: less than a
        # pitch passes in a step. Conditions, events and guards within.
        "M::switch_after": (3, 2, 5, 5),
    }


def reads(constants):
    """The instructions that read the counter."""
    found = set()
    for address, known in constants.before.items():
        instruction = constants.function.instructions[address]
        place = re.search(r"\[(\w+)(?:, #(\w+))?\]$", instruction.operands)
        if instruction.mnemonic == "ldr" and place and place[1] in known:
            least, most = known[place[1]]
            if least == most == COUNTER - int(place[2] or "0", 0):
                found.add(address)
    return found


class Step:
    """What is measured in a function: the way from a reading of the counter to the next one. A step that fails is the last one:
    its way is not one of them."""

    def __init__(self, function):
        self.constants = Constants(function, {})
        self.reads = reads(self.constants)
        begins = self._next_reads([function.address])
        if len(begins) != 1:
            raise NotUnderstood(f"{len(begins)} readings of the counter begin a step in {function.name}")
        self.entry = self.constants.successors(*begins)[0]
        self.ends = {end for end in self._next_reads([self.entry]) if self._next_reads(self._after(end)) == begins}

    def _after(self, address):
        return self.constants.successors(address)

    def _next_reads(self, addresses):
        seen, todo = set(), list(addresses)
        while todo:
            address = todo.pop()
            if address not in seen:
                seen.add(address)
                todo += [] if address in self.reads else self._after(address)
        return seen & self.reads

    def cost(self, walk):
        """The cost of its best path."""
        return walk.between(
            self.constants, self.entry, self.ends, lambda address: [] if address in self.ends else self._after(address))


def measuring(functions, function):
    """The functions that measure a run each, in the order of the runs: each run is made only if those before have succeeded."""
    constants, seen, order = Constants(function, {}), set(), []
    way = [(None, iter([function.address]))]
    while way:
        address = next((target for target in way[-1][1] if target not in seen), None)
        if address is None:
            order.append(way.pop()[0])
        else:
            seen.add(address)
            way.append((address, iter(constants.successors(address))))
    for address in order[-2::-1]:
        called = functions.get(function.instructions[address].call)
        if called and short(called.name) == "cortex_m::stack":
            yield called
        elif called and short(called.name) == "steps::steps":
            yield from measuring(functions, called)


def walk_board(functions, report, rules):
    """Prints what is found of each mechanism of a board; the lines of its file."""
    runs = [line[2:].split(",") for line in report if line.startswith("# ") and not line.startswith("# program")]
    program = next(function for function in functions.values() if function.name == "program")
    steps = list(measuring(functions, program))
    if len(steps) != len(runs):
        raise NotUnderstood(f"{len(steps)} functions measure {len(runs)} runs")
    longest = {key: Walk(functions, rules[key], True) for key in rules}
    shortest = Walk(functions, rules[LINE], False)
    for (name, scalar, by, fewest, most, *_), function in zip(runs, steps):
        if by == "step":
            step, kind = Step(function), name if name in STEPPED else LINE_STEPS
            everything, usual = (step.cost(longest[kind, turns]) for turns in ("all", "few turns"))
            check(name, everything and usual, "what is left out leaves no path")
            straight = "no straight line"
            if kind == LINE_STEPS:
                shortest_line, line = step.cost(shortest), step.cost(longest[LINE]).count
                least = shortest_line.count
                straight = f"{least} straight on" if least == line else f"{least} to {line} straight on"
                # Of a copy the shortest path has one round of each loop.
                copies = any(copies_memory(part) for part in shortest_line.shares)
                is_met = least <= int(fewest) <= line if copies else least == int(fewest)
                check(name, is_met, f"the line of {straight} is not the fewest that were measured, {fewest}")
            describe(f"{name}, {scalar}: {straight}", usual)
            check(name, usual.count >= int(most), f"{usual.count} at most is less than was measured, {most}")
            yield f"{name},{everything.count},{usual.count}\n"


def describe(what, cost):
    """Prints where the longest path of a step is."""
    shares = sorted(cost.in_function("the step").shares.items(), key=lambda share: -share[1])
    print(f"{what}; {cost.count} at most, of them " + ", ".join(f"{own} in {part}" for part, own in shares[:5]))


def check(name, holds, what):
    """Ends the program where something does not hold."""
    if not holds:
        sys.exit(f"{name}: {what}")


def main(objdump, *boards):
    rules = {LINE: Rules(ROUNDS, RESTS, FAULTS | FAR_TURNED | ASIDE)}
    for kind in (LINE_STEPS, *STEPPED):
        rounds = rounds_of(STEPPED[kind]) if kind in STEPPED else ROUNDS
        events = SETTING if kind in SETTERS else EVENTS
        left_out = FAULTS | (events if kind in STEPPED else set())
        rules[kind, "all"] = Rules(rounds, RESTS, left_out)
        rules[kind, "few turns"] = Rules(rounds, RESTS, left_out | FAR_TURNED)
    for program, report in zip(boards[::2], boards[1::2]):
        # That processor knows all instructions of the other.
        options = ["-d", "-C", "--no-show-raw-insn", "--mcpu=cortex-m7", program]
        text = subprocess.run([objdump, *options], check=True, capture_output=True, text=True).stdout
        lines = walk_board(read(text.splitlines()), pathlib.Path(report).read_text().splitlines(), rules)
        pathlib.Path(report).with_suffix(".worst").write_text("".join(lines))
    known = {name for rule in rules.values() for table in (rule.rounds, rule.rests, rule.left_out) for name in table}
    unused = known - {name for rule in rules.values() for name in rule.used}
    check("the tables of the walk", not unused, f"nothing is called {', '.join(sorted(unused))}")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except NotUnderstood as what:
        sys.exit(f"no worst case: {what}")
