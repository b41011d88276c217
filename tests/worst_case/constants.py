"""Which constants registers hold, and which ways a function does not go with them."""

import re

REGISTER = re.compile(r"\b(?:r\d+|lr)\b")
IMMEDIATE = re.compile(r"(r\d+|lr), #(0x[0-9a-f]+|\d+)")
COPY = re.compile(r"(r\d+|lr), (r\d+|lr)")
# They write no register, but for the base that they move.
READERS = re.compile(r"cmp|cmn|tst|teq|it|push|str|stm")
TWO_RESULTS = re.compile(r"ldrd|[us]mull|[us]mlal|umaal|vmov")
LOST_BY_CALLS = ("r0", "r1", "r2", "r3", "r12", "lr")
COMPARED = "compared"


class Constants:
    """What registers hold before each instruction of a function that can be reached: the least and the most of a value."""

    def __init__(self, function, at_entry):
        self.before, self.function = {function.address: at_entry}, function
        todo = [function.address]
        while todo:
            address = todo.pop()
            after = self._after(function.instructions[address])
            for target in self.successors(address):
                known = self.before.get(target)
                merged = after if known is None else {key: value for key, value in known.items() if after.get(key) == value}
                if merged != known:
                    self.before[target] = merged
                    todo.append(target)

    def successors(self, address):
        """Where an instruction can go on, with what is known there."""
        instruction = self.function.instructions[address]
        taken = self._is_taken(instruction, self.before[address])
        if taken is None:
            return instruction.targets
        # A conditional jump has its target before the next instruction.
        return instruction.targets[:1] if taken else instruction.targets[1:]

    @staticmethod
    def _is_taken(instruction, before):
        """Whether a comparison of numbers without sign decides a jump; None if it is not known."""
        if COMPARED not in before or len(instruction.targets) != 2:
            return None
        (least, most), bound = before[COMPARED]
        below, above = most < bound, least >= bound
        decided = {"blo": (below, above), "bhs": (above, below)}.get(instruction.mnemonic, (False, False))
        return True if decided[0] else False if decided[1] else None

    def _after(self, instruction):
        after = dict(self.before[instruction.address])
        mnemonic, operands = instruction.mnemonic, instruction.operands
        # What is compared is only used by the jump after it.
        after.pop(COMPARED, None)
        constant = IMMEDIATE.fullmatch(operands)
        least, most = after.get(constant[1], (0, 1)) if constant else (0, 1)
        if mnemonic == "cmp" and constant and constant[1] in after:
            after[COMPARED] = (after[constant[1]], int(constant[2], 0))
        elif mnemonic in ("mov", "movs", "movw") and constant:
            after[constant[1]] = (int(constant[2], 0),) * 2
        elif mnemonic == "movt" and constant and least == most:
            after[constant[1]] = (least & 0xFFFF | int(constant[2], 0) << 16,) * 2
        elif mnemonic in ("mov", "movs") and (copy := COPY.fullmatch(operands)) and copy[2] in after:
            after[copy[1]] = after[copy[2]]
        else:
            for register in self._written(instruction):
                after.pop(register, None)
        return after

    @staticmethod
    def _written(instruction):
        """Registers that an instruction writes."""
        if instruction.call is not None:
            return LOST_BY_CALLS
        mnemonic, operands = instruction.mnemonic, instruction.operands
        if "!" in operands or "]," in operands or "{" in operands:
            # Bases that move, and lists.
            return REGISTER.findall(operands)
        if READERS.match(mnemonic):
            return ()
        return REGISTER.findall(operands.split("[")[0])[: 2 if TWO_RESULTS.match(mnemonic) else 1]
