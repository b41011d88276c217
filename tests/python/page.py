"""Runs what the page of the book shows, and compares what is printed: page.py PAGE FOLDER; `plm` stands in that folder."""

import doctest
import re
import subprocess
import sys
from pathlib import Path

# What differs from machine to machine.
PLATFORM = re.compile(r"-(many|musl)?(linux|macosx|win)\w*\.whl")
MARK = "--- what follows was printed by line "


def blocks(page, kind):
    return re.findall(rf"^```{kind}\n(.*?)^```$", page, re.M | re.S)


def commands(block):
    """Each command, what the page shows after it, and the session of Python that it begins."""
    found = []
    for line in block.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], [], []))
        else:
            _, shown, session = found[-1]
            (session if session or line.startswith(">>> ") else shown).append(line)
    return found


def main(page, folder):
    text = Path(page).read_text()
    script, expected = [], []
    for command, shown, session in [each for block in blocks(text, "console") for each in commands(block)]:
        script.append(f"echo; echo '{MARK}{len(expected)}'")
        if session:
            file = Path(folder, f"session{len(expected)}.txt")
            file.write_text("\n".join(session) + "\n")
            command += f" {Path(__file__).resolve()} --session {file}"
        script.append(command)
        expected.append((command, shown))
        if command.startswith("cargo new"):
            (source,) = blocks(text, "rust,no_run")
            script.append("cat > src/main.rs <<'END OF SOURCE'\n" + source + "END OF SOURCE")
    for number, block in enumerate(blocks(text, "pycon")):
        file = Path(folder, f"page{number}.txt")
        file.write_text(block)
        script.append(f"python {Path(__file__).resolve()} --session {file}")
    bash = ["bash", "-e", "-o", "pipefail", "-c", "\n".join(script)]
    done = subprocess.run(bash, cwd=folder, stdout=subprocess.PIPE, text=True)
    print(done.stdout)
    printed = dict(re.findall(rf"^{MARK}(\d+)\n(.*?)(?=^\n{MARK}|\Z)", done.stdout, re.M | re.S))
    wrong = []
    for number, (command, shown) in enumerate(expected):
        said = PLATFORM.sub("-PLATFORM.whl", printed.get(str(number), "NOT RUN"))
        lines = said.splitlines()
        shown = [PLATFORM.sub("-PLATFORM.whl", line) for line in shown]
        wrong += [f"$ {command}: the page shows {line!r}" for line in shown if line not in lines]
    if done.returncode or wrong:
        sys.exit("\n".join(["the page says otherwise:", *wrong, f"exit {done.returncode}"]))


def session(file):
    test = doctest.DocTestParser().get_doctest(Path(file).read_text(), {}, "the page", file, 0)
    print(f"{len(test.examples)} lines of a session")
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test)
    sys.exit(1 if result.failed or not result.attempted else 0)


if sys.argv[1] == "--session":
    session(sys.argv[2])
else:
    main(*sys.argv[1:])
