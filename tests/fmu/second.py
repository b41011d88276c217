"""Runs an FMU of the press of tests/foreign.rs, of FMI 2.0 or 3.0, by fmi-sim, an importer of another family: second.py FMI_SIM FMU
ROWS, where the rows are the outputs of Rust every 10 ms."""

import csv
import os
import re
import subprocess
import sys
import zipfile

importer, file, rows = sys.argv[1:]
END = 0.99
with open(rows) as lines:
    known = [[float(word) for word in line] for line in csv.reader(lines)]


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


def as_it_reads():
    """fmi-sim 0.7.0 refuses attributes of FMI 3.0 that it does not know: units and nominals are left out for it."""
    path = file + ".plain.fmu"
    with zipfile.ZipFile(file) as whole, zipfile.ZipFile(path, "w") as plain:
        for name in whole.namelist():
            data = whole.read(name)
            if name == "modelDescription.xml":
                head, variables = data.split(b"<ModelVariables")
                data = head + b"<ModelVariables" + re.sub(rb' (unit|displayUnit|nominal)="[^"]*"', b"", variables)
            plain.writestr(name, data)
    return path


def run(mode, interval):
    out = file + ".csv"
    options = ["--output-interval", str(interval), "-f", str(END)]
    subprocess.run([importer, "--model", plain, "-o", out, mode, *options], check=True, env={**os.environ, "RUST_BACKTRACE": "0"})
    with open(out) as lines:
        return [[float(word) for word in line] for line in list(csv.reader(lines))[1:]]


plain = as_it_reads()
found = run("co-simulation", 0.01)
expect(len(found) == 100, f"{len(found)} rows of co-simulation")
# Its times are sums of intervals, and end in other digits than those of Rust.
far = max(abs(a - b) / (1 + abs(b)) for row, other in zip(found, known) for a, b in zip(row[1:], other))
expect(far < 1e-11, f"co-simulation has the numbers of Rust within {far:.1e}")

# Model exchange by Euler's method: a tenth of the interval, a tenth of the error.
errors = [abs(run("model-exchange", interval)[-1][1] - known[99][0]) for interval in (1e-4, 1e-5)]
expect(errors[0] < 0.05, f"model exchange by Euler's method is off by {errors[0]:.1e} rad")
expect(6 < errors[0] / errors[1] < 14, f"and {errors[0] / errors[1]:.1f} times less with a tenth of the step")
