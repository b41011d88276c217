"""A page of the book as files and commands: a block after a paragraph that begins with `NAME` is a file, lines of `console` that begin with
`$ ` are commands, and the others are what they print. Commands of the system's packages (`sudo`) are left out.

    python page.py PAGE FOLDER      # writes the files, commands.sh and shown.txt
"""

import re
import sys
from pathlib import Path

page, folder = Path(sys.argv[1]).read_text(), Path(sys.argv[2])
commands, shown = [], []
for paragraph, language, block in re.findall(r"([^\n]*)\n\n```(\w+)\n(.*?)```", page, re.DOTALL):
    name = re.match(r"`([\w.]+)` ", paragraph)
    if language == "console":
        for line in block.splitlines():
            if not line.startswith("$ "):
                shown.append(line)
            elif not line.startswith("$ sudo "):
                commands.append(line[2:])
    else:
        assert name, f"a block without the name of a file: {paragraph}"
        (folder / name[1]).write_text(block)
assert commands, "the page has no commands"
(folder / "commands.sh").write_text("\n".join(commands) + "\n")
(folder / "shown.txt").write_text("\n".join(shown) + "\n")
