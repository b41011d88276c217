"""Looks at an FMU with sources as an importer: fmu.py FOLDER STEPS RUN TOLERANCE FAILURE [NAME=VALUE]...

FOLDER has the files of the FMU. STEPS has the outputs after every tenth step of 1 ms from text, RUN those of a run with error control at
the same times; each line begins with the time. FAILURE is in the message with which co-simulation ends after these rows, or empty. The
values of parameters and inputs are those of the rows. FMPy compiles by CMake, or the C compiler does where there is none."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import fmpy
import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.build import build_platform_binary
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

folder, steps, run, tolerance, failure, *values = sys.argv[1:]
folder, tolerance = Path(folder), float(tolerance)
start = {name: float(value) for name, value in (pair.split("=") for pair in values)}
H, EVERY = 1e-3, 10


def expect(holds, what):
    if not holds:
        print(f"DOES NOT HOLD: {folder.name}: {what}")
        sys.exit(1)


def table(file):
    return np.loadtxt(file, delimiter=",", ndmin=2)


file = folder.with_suffix(".fmu")
with zipfile.ZipFile(file, "w") as archive:
    for path in sorted(folder.rglob("*")):
        archive.write(path, path.relative_to(folder))

problems = validate_fmu(file)
expect(not problems, f"FMPy has a message: {problems}")
about = read_model_description(file)
two = about.fmiVersion == "2.0"
schemas = Path(fmpy.__file__).parent / "schema" / ("fmi2" if two else "fmi3")
kinds = [("modelDescription.xml", f"fmi{2 if two else 3}ModelDescription.xsd")]
if not two:
    kinds.append(("sources/buildDescription.xml", "fmi3BuildDescription.xsd"))
for name, schema in kinds:
    schema = etree.XMLSchema(file=str(schemas / schema))
    expect(schema.validate(etree.fromstring((folder / name).read_bytes())), f"{name}: {schema.error_log}")

made = extract(file)
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
identifier = about.coSimulation.modelIdentifier
if shutil.which("cmake"):
    with open(os.devnull, "w") as nowhere:
        out = os.dup(1)
        os.dup2(nowhere.fileno(), 1)
        build_platform_binary(made)
        os.dup2(out, 1)
else:
    print("no CMake: compiled by the C compiler alone")
    binary = Path(made) / "binaries" / (fmpy.platform if two else fmpy.platform_tuple) / f"{identifier}.so"
    binary.parent.mkdir(parents=True)
    headers = Path(fmpy.__file__).parent / "c-code"
    source = Path(made) / "sources" / f"{identifier}_fmi.c"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", f"-I{headers}", "-o", binary, source], check=True)

outputs = [variable.name for variable in about.modelVariables if variable.causality == "output"]
number = {variable.name: variable.valueReference for variable in about.modelVariables}
heard = []


def hear(*words):
    heard.append(words[-1].decode() if isinstance(words[-1], bytes) else str(words[-1]))


def simulate(kind, until, **more):
    return simulate_fmu(made, fmi_type=kind, stop_time=until, output_interval=EVERY * H, output=outputs,
                        start_values=start, logger=hear, **more)


def slave():
    fmu = (FMU2Slave if two else FMU3Slave)(guid=about.guid if two else about.instantiationToken,
                                            unzipDirectory=made, modelIdentifier=identifier)
    fmu.instantiate()
    if two:
        fmu.setupExperiment()
    for name, value in start.items():
        (fmu.setReal if two else fmu.setFloat64)([number[name]], [value])
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    return fmu


def read(fmu):
    return list((fmu.getReal if two else fmu.getFloat64)([number[name] for name in outputs]))


def step(fmu, k, count):
    for j in range(k, k + count):
        fmu.doStep(j * H, H)


# Co-simulation: the bits of steps from text.
rows = table(steps)
fmu = slave()
expect(read(fmu) == list(rows[0][1:]), f"the start: {read(fmu)} {rows[0]}")
for k, row in enumerate(rows[1:]):
    step(fmu, k * EVERY, EVERY)
    expect(read(fmu) == list(row[1:]), f"the bits after {row[0]} s: {read(fmu)}, not {list(row[1:])}")
if failure:
    try:
        simulate("CoSimulation", rows[-1][0] + 0.1, step_size=H)
        expect(False, "the run ends")
    except Exception:
        expect(any(failure in message for message in heard), f"a message has `{failure}`: {heard}")
else:
    result = simulate("CoSimulation", rows[-1][0], step_size=H)
    # FMPy makes steps of differences of its times.
    same = all(np.allclose(result[name], rows[:, k + 1], rtol=1e-8, atol=1e-8) for k, name in enumerate(outputs))
    expect(len(result) == len(rows) and same, "a simulation by FMPy has these rows")

# A state of the FMU is taken back, as it is and as bytes.
fmu = slave()
step(fmu, 0, 5)
state = fmu.getFMUstate() if two else fmu.getFMUState()
saved = (fmu.serializeFMUstate if two else fmu.serializeFMUState)(state)
step(fmu, 5, 5)
after = read(fmu)
(fmu.setFMUstate if two else fmu.setFMUState)(state)
step(fmu, 5, 5)
expect(read(fmu) == after, "a state that is set back goes on as before")
other = slave()
state = (other.deSerializeFMUstate if two else other.deserializeFMUState)(saved)
(other.setFMUstate if two else other.setFMUState)(state)
step(other, 5, 5)
expect(read(other) == after, "bytes of a state go on in another instance")
fmu.reset()

# Model exchange: near a run with error control.
if about.modelExchange is not None and Path(run).exists():
    rows = table(run)
    result = simulate("ModelExchange", rows[-1][0], relative_tolerance=1e-10)
    times = {round(time, 9): k for k, time in enumerate(result["time"])}
    off = 0.0
    for k, name in enumerate(outputs):
        size = max(1.0, float(np.max(np.abs(rows[:, k + 1]))))
        # Of the rows at an event the last one is after it.
        own = np.array([result[name][times[round(row[0], 9)]] for row in rows])
        off = max(off, float(np.max(np.abs(own - rows[:, k + 1]))) / size)
    expect(off <= tolerance, f"model exchange is off by {off:.1e}, at most {tolerance:.0e}")
    print(f"{folder.name}: the bits of {len(table(steps))} rows; model exchange is off by {off:.1e}")
else:
    print(f"{folder.name}: the bits of {len(table(steps))} rows; no model exchange")
