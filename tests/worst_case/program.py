"""Functions of a Thumb-2 program, from the text of llvm-objdump: instructions, and where each goes on."""

import re

CONDITIONS = "eq|ne|hs|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le"
JUMP = re.compile(rf"(b|bl|cbn?z|bx|blx|pop|ldm|ldr|tb[bh]|mov|add)({CONDITIONS})?")
TARGET = re.compile(r"0x([0-9a-f]+) <")


class NotUnderstood(Exception):
    """Code that cannot be walked."""


class Instruction:
    """One instruction. `targets` are where it can go on in its function, `call` is the function that it calls."""

    def __init__(self, address, mnemonic, operands):
        self.address, self.operands = address, operands
        # Widths of the encoding do not matter.
        self.mnemonic = mnemonic.removesuffix(".w").removesuffix(".n")
        self.targets, self.call, self.returns, self.is_known = [], None, False, True

    def follow(self, inside, after):
        """Finds where it goes on; `inside` are the instructions of its function, `after` is the address of the next one."""
        jump = JUMP.fullmatch(self.mnemonic)
        kind, condition = jump.groups() if jump else ("", None)
        goes_on = condition is not None or kind in ("cbz", "cbnz", "bl")
        target = TARGET.search(self.operands)
        into_pc = re.search(r"\bpc\b", self.operands if kind in ("pop", "ldm") else self.operands.split(",")[0])
        if kind in ("b", "cbz", "cbnz", "bl") and target:
            self._jump(kind, int(target[1], 16), inside)
        elif kind in ("pop", "ldm", "ldr") and into_pc or (kind, self.operands) == ("bx", "lr"):
            self.returns = True
        elif kind in ("b", "cbz", "cbnz", "bl", "bx", "blx", "tbb", "tbh") or into_pc and kind in ("mov", "add"):
            self.is_known = False
        else:
            goes_on = True
        if goes_on and after is not None:
            self.targets.append(after)

    def follow_table(self, data, inside):
        """Finds where a jump by a table goes on, which has `data` after it: distances in halfwords, of a byte or two each."""
        # What is aligned has no operations before it, `00 bf`.
        while data.endswith(b"\x00\xbf"):
            data = data[:-2]
        size, base = (1 if self.mnemonic == "tbb" else 2), self.address + 4
        places = range(0, len(data) - size + 1, size)
        targets = {base + 2*int.from_bytes(data[place:place + size], "little") for place in places}
        # A byte that fills the table up is zero: it goes to the table.
        self.targets = sorted(targets & inside.keys())
        self.is_known = bool(self.targets) and targets <= inside.keys() | {base}

    def _jump(self, kind, target, inside):
        if kind == "bl":
            self.call = target
        elif target in inside:
            self.targets.append(target)
        else:
            # A call in the place of a return.
            self.call, self.returns = target, True
            self.is_known = kind == "b"


class Function:
    """The instructions of a symbol by address, in their order."""

    def __init__(self, address, name):
        # The hash tells instances apart and changes with every version.
        self.address, self.name = address, re.sub(r"::h[0-9a-f]{16}$", "", name)
        self.instructions, self.data = {}, {}

    def link(self):
        """Finds where its instructions go on."""
        addresses = list(self.instructions)
        for address, after in zip(addresses, addresses[1:] + [None]):
            instruction = self.instructions[address]
            instruction.follow(self.instructions, after)
            if instruction.mnemonic in ("tbb", "tbh"):
                instruction.follow_table(self._data_at(address + 4), self.instructions)

    def _data_at(self, address):
        """The bytes of data from an address to the next instruction."""
        found = b""
        while address + len(found) in self.data:
            found += self.data[address + len(found)]
        return found

    def successors(self, address):
        """Where an instruction goes on in the function."""
        return self.instructions[address].targets


def read(lines):
    """The functions of a program by address."""
    functions, function = {}, None
    for line in lines:
        if head := re.match(r"([0-9a-f]+) <(.+)>:$", line):
            function = functions.setdefault(int(head[1], 16), Function(int(head[1], 16), head[2]))
        elif code := re.match(r" *([0-9a-f]+):\s+\t([a-z]\S*)\s*(.*)", line):
            # After @ stand remarks.
            operands = code[3].split("@")[0].strip()
            function.instructions[int(code[1], 16)] = Instruction(int(code[1], 16), code[2], operands)
        elif data := re.match(r" *([0-9a-f]+):((?: [0-9a-f]{2})+)\s+\t\.", line):
            function.data[int(data[1], 16)] = bytes.fromhex(data[2])
    for function in functions.values():
        function.link()
    return functions
