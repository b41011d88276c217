"""The longest or the shortest path through functions and what they call."""

import re

from constants import Constants
from paths import Cost, Graph
from program import NotUnderstood

MEMORY = re.compile(r"(__aeabi_)?mem(cpy|move|set|clr)[48]?")
# Bytes by instruction; what a condition may skip counts nothing.
STORED = {"strb": 1, "strh": 2, "str": 4, "strd": 8}
MARKS = {"$LT$": "<", "$GT$": ">", "$LP$": "(", "$RP$": ")", "$C$": ",", "$u20$": " ", "..": "::"}


def short(name):
    """The last part of a name, after its type or module."""
    for mark, sign in MARKS.items():
        name = name.replace(mark, sign)
    return "::".join(re.findall(r"\w+", name.replace("<S>", ""))[-2:])


def copies_memory(name):
    """Whether this short name is that of a function of memory."""
    return bool(MEMORY.fullmatch(name.split("::")[-1]))


def bytes_in(function):
    """The register with the number of bytes of a function of memory; none of others."""
    name = short(function.name).split("::")[-1]
    if copies_memory(name):
        return "r1" if "memclr" in name or "aeabi_memset" in name else "r2"
    return None


class Rules:
    """What is known beside the code, by short names of functions. `rounds` are those of loops at most, the outer ones first;
    `rests` are bytes at most that a function of memory leaves to another one; paths end before functions that are `left_out`."""

    def __init__(self, rounds, rests, left_out):
        self.rounds, self.rests, self.left_out = rounds, rests, left_out
        self.used = set()

    def find(self, table, function, what):
        """What a table has for a function."""
        name = short(function.name)
        if name not in table:
            raise NotUnderstood(f"nothing bounds {what} in {name}")
        self.used.add(name)
        return table[name]

    def leave_out(self, function):
        """Whether paths end before a function."""
        name = short(function.name)
        if name in self.left_out:
            self.used.add(name)
        return name in self.left_out


class Walk:
    """Costs of paths through a program."""

    def __init__(self, functions, rules, longest):
        self.functions, self.rules, self.longest = functions, rules, longest
        self._calls = {}

    def between(self, constants, entry, ends, successors):
        """The cost of the best path from an instruction to one of the ends, both included; none if there is no way."""
        function = constants.function
        costs, todo = {}, [entry]
        while todo:
            address = todo.pop()
            if address not in costs:
                costs[address] = self._instruction(constants, function.instructions[address])
                todo += successors(address) if costs[address] else []
        ends = [end for end in ends if costs.get(end)]
        nodes = leading_to(ends, {address: successors(address) for address in costs if costs[address]})
        if entry not in nodes:
            return None
        graph = Graph(successors, costs.__getitem__, self._rounds_in(constants), self.longest)
        found = graph.paths(entry, nodes)
        reached = [found[end] for end in ends if end in found]
        return graph.best(reached) if reached else None

    def _rounds_in(self, constants):
        function = constants.function
        length = constants.before[function.address].get(bytes_in(function))

        def rounds(graph, head, loop):
            if length:
                return rounds_by_bytes(function, graph, head, loop, length[1])
            known = self.rules.find(self.rules.rounds, function, f"the loop at {head:x}")
            if graph.depth >= len(known):
                raise NotUnderstood(f"nothing bounds the inner loop at {head:x} in {short(function.name)}")
            # Its head is come to once more where it ends there.
            return known[graph.depth] + 1

        return rounds

    def _instruction(self, constants, instruction):
        """The cost of an instruction with what it calls; none if that is left out or does not come back."""
        where = f"{instruction.address:x} in {constants.function.name}"
        if not instruction.is_known:
            raise NotUnderstood(f"a jump to what is not known, at {where}")
        if instruction.call is None:
            return Cost(1)
        if instruction.call not in self.functions:
            raise NotUnderstood(f"a call of {instruction.call:x}, where no function is, at {where}")
        called = self.functions[instruction.call]
        if self.rules.leave_out(called):
            return None
        length = None
        if register := bytes_in(called):
            length = constants.before[instruction.address].get(register)
            if length is None:
                length = (0, self.rules.find(self.rules.rests, constants.function, "the bytes that are left"))
        cost = self.call(called, length)
        return cost and Cost(1).plus(cost)

    def call(self, function, length):
        """The cost of a call; `length` are the least and the most bytes of a function of memory."""
        key = (function.address, length)
        if key not in self._calls:
            self._calls[key] = "under way"
            constants = Constants(function, {bytes_in(function): length} if length else {})
            returns = [address for address in constants.before if function.instructions[address].returns]
            cost = self.between(constants, function.address, returns, constants.successors)
            self._calls[key] = cost and cost.in_function(short(function.name))
        if self._calls[key] == "under way":
            raise NotUnderstood(f"{function.name} calls itself")
        return self._calls[key]


def leading_to(ends, ways):
    """The nodes from which an end can be reached."""
    before = {}
    for node, targets in ways.items():
        for target in targets:
            before.setdefault(target, []).append(node)
    nodes, todo = set(ends), list(ends)
    while todo:
        found = set(before.get(todo.pop(), [])) - nodes
        nodes |= found
        todo += found
    return nodes


def rounds_by_bytes(function, graph, head, loop, length):
    """How often the head of a loop is come to that stores no more than so many bytes in all."""

    def stored(address):
        instruction = function.instructions[address]
        # Not what is put aside in the frame.
        is_copy = not re.search(r"\[(sp|r7)\b", instruction.operands)
        return Cost(is_copy * STORED.get(instruction.mnemonic, 0))

    within = Graph(graph.successors, stored, graph.rounds, False).once(head, loop)
    around = min(within[node].count for node in within if head in graph.successors(node))
    leaving = min(within[node].count for node in within if set(graph.successors(node)) - loop)
    if around == 0:
        raise NotUnderstood(f"the loop at {head:x} in {function.name} stores nothing")
    return (length - leaving) // around + 1 if length >= leaving else 0
