"""Looks at the FMU of the press of tests/foreign.rs: check.py FMU ROWS [STEPS], where the rows are the outputs of Rust every
10 ms, and the memory is looked at over so many steps of co-simulation."""

import os
import subprocess
import sys
import zipfile

import fmpy
import modes
import numpy as np
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

file, rows, *rest = sys.argv[1:]
STEPS = int(rest[0]) if rest else 100_000
native = np.loadtxt(rows, delimiter=",")
H = 0.01


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


def expect_quietly(holds, what):
    if not holds:
        expect(holds, what)


problems = validate_fmu(file)
expect(not problems, f"FMPy has no message {problems}")

# The schemas of the standard, which FMPy brings.
schema = os.path.join(os.path.dirname(fmpy.__file__), "schema", "fmi3", "fmi3ModelDescription.xsd")
schema = etree.XMLSchema(file=schema)
description = etree.fromstring(zipfile.ZipFile(file).read("modelDescription.xml"))
expect(schema.validate(description), f"the XML schemas of FMI 3.0 have no message {schema.error_log}")

about = fmpy.read_model_description(file)
folder = fmpy.extract(file)
number = {variable.name: variable.valueReference for variable in about.modelVariables}
outputs = [v.valueReference for v in about.modelVariables if v.causality == "output"]
token = about.instantiationToken


def slave(early=False):
    fmu = FMU3Slave(guid=token, unzipDirectory=folder, modelIdentifier=about.coSimulation.modelIdentifier)
    fmu.instantiate(eventModeUsed=early, earlyReturnAllowed=early)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    if early:
        fmu.updateDiscreteStates()
        fmu.enterStepMode()
    return fmu


def run(fmu, first, last):
    values = []
    for k in range(first, last):
        if k == 100:
            fmu.setFloat64([number["push"]], [-7.5])
        values.append(fmu.getFloat64(outputs))
        fmu.doStep(currentCommunicationPoint=k * H, communicationStepSize=H)
    return np.array(values)


fmu = slave()
values = run(fmu, 0, 200)
expect(np.array_equal(values, native), "co-simulation has the bits of Rust")

# Back to a state, and a run of another instance beside.
fmu.reset()
fmu.enterInitializationMode()
fmu.exitInitializationMode()
run(fmu, 0, 50)
state = fmu.getFMUState()
saved = fmu.serializeFMUState(state)
once = run(fmu, 50, 120)
fmu.setFMUState(state)
again = run(fmu, 50, 120)
fmu.freeFMUState(state)
expect(np.array_equal(once, again) and np.array_equal(once, native[50:120]), "roll-back is equal to the bit")

# Bytes, in this process and in another one.
state = fmu.deserializeFMUState(saved)
fmu.setFMUState(state)
once = run(fmu, 50, 120)
expect(np.array_equal(once, native[50:120]), f"a state in {len(saved)} bytes is equal to the bit")
with open(file + ".state", "wb") as place:
    place.write(saved)
command = [sys.executable, os.path.join(os.path.dirname(__file__), "resume.py"), file, file + ".state", "50", "100"]
lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
other = [[float.fromhex(word) for word in line.split()] for line in lines]
expect(np.array_equal(other, native[50:100]), "so it is in a process of its own")


def refuses(changed):
    try:
        fmu.deserializeFMUState(bytes(changed))
    except Exception:
        return True
    return False


damaged = [saved[:k] + bytes([saved[k] ^ 16]) + saved[k + 1 :] for k in range(0, len(saved), 37)]
expect(all(map(refuses, damaged + [saved[:-8], b"", saved + b"x"])), "bytes that were changed are refused")


def fails(call):
    before = fmu.getFloat64([0] + outputs)
    try:
        call()
    except Exception:
        return fmu.getFloat64([0] + outputs) == before
    return False


expect(fails(lambda: fmu.doStep(0.0, H)), "a step back in time is refused")
expect(fails(lambda: fmu.doStep(120 * H, float("nan"))), "a step of NaN is refused")
expect(fails(lambda: fmu.setFloat64([number["push"]], [float("nan")])), "an input of NaN is refused")
expect(fails(lambda: fmu.setFloat64([number["start(crank.angle)"]], [1.0])), "a start while it runs is refused")
expect(fails(lambda: fmu.setFloat64([outputs[0]], [1.0])), "an output that is set is refused")
expect(fails(lambda: fmu.getFloat64([10**6])), "an unknown value reference is refused")
expect(fails(lambda: fmu.doStep(120 * H, 100.0)), "a requirement that fails is told, and the run stays")

# Derivatives of all rates and outputs by states, inputs and parameters, beside difference quotients.
model = FMU3Model(guid=token, unzipDirectory=folder, modelIdentifier=about.modelExchange.modelIdentifier)
model.instantiate()
model.enterInitializationMode()
model.exitInitializationMode()
model.enterContinuousTimeMode()
rates = [v.valueReference for v in about.modelVariables if v.derivative is not None]
states = [v.derivative.valueReference for v in about.modelVariables if v.derivative is not None]
unknowns = rates + outputs
worst = 0.0
structure = description.find("ModelStructure")
dependencies = {
    int(element.get("valueReference")): [int(word) for word in element.get("dependencies").split()]
    for element in structure.iter("Output", "ContinuousStateDerivative")
    if element.get("dependencies") is not None
}
expect(len(dependencies) > 0, f"dependencies are listed of {len(dependencies)} unknowns")
for name, reference in number.items():
    known = reference in states or name in ("time", "push", "stiff", "load")
    if not known:
        continue
    value = model.getFloat64([reference])[0]
    h = 6e-6 * max(1.0, abs(value))

    def at(moved):
        if reference in states:
            x = model.getFloat64(states)
            x[states.index(reference)] = moved
            model.setContinuousStates((np.ctypeslib.ctypes.c_double * len(x))(*x), len(x))
        elif name == "time":
            model.setTime(moved)
        else:
            model.setFloat64([reference], [moved])
        return np.array(model.getFloat64(unknowns))

    # Parameters can be set at events alone.
    is_parameter = name in ("stiff", "load")
    if is_parameter:
        model.enterEventMode()
    quotient = (8 * (at(value + h) - at(value - h)) - (at(value + 2 * h) - at(value - 2 * h))) / (12 * h)
    at(value)
    exact = np.array(model.getDirectionalDerivative(unknowns, [reference], [1.0]))
    if is_parameter:
        model.enterContinuousTimeMode()
    worst = max(worst, np.max(np.abs(exact - quotient) / (1.0 + np.abs(exact))))
    # What is not listed as a dependency has no influence.
    for unknown, tangent in zip(unknowns, exact):
        listed = dependencies.get(unknown)
        expect_quietly(listed is None or (reference in listed) or tangent == 0.0, f"{name} moves {unknown}, which does not list it")
expect(worst < 1e-7, f"derivatives are difference quotients within {worst:.1e}")

# Solvers of FMPy.
# The solver's own tolerance bounds what model exchange can give; the forces follow the rates of the states.
cases = (("CoSimulation", 1e-9, 1e-9), ("ModelExchange", 1e-8, 2e-4), ("ModelExchange", 1e-10, 2e-6))
for kind, relative, tolerance in cases:
    result = fmpy.simulate_fmu(
        file, fmi_type=kind, stop_time=0.9, output_interval=H, relative_tolerance=relative, record_events=False
    )
    names = [v.name for v in about.modelVariables if v.causality == "output"]
    found = np.array([[row[name] for name in names] for row in result])
    error = np.max(np.abs(found[:90] - native[:90]) / (1.0 + np.abs(native[:90])))
    expect(error < tolerance, f"FMPy's {kind} is the run of Rust within {error:.1e}")

# A solver that shows the FMU nothing but the ends of long intervals, in which the crank turns by several radians: loops are followed.
turned = np.max(np.abs(np.diff(native[:90:30, 0])))
for interval in (0.1, 0.3, 0.9):
    result = fmpy.simulate_fmu(
        file, fmi_type="ModelExchange", stop_time=0.9, output_interval=interval, relative_tolerance=1e-10, record_events=False
    )
    found, every = np.array([[row[name] for name in names] for row in result]), round(interval / H)
    wanted = native[: 91 : every]
    error = np.max(np.abs(found - wanted) / (1.0 + np.abs(wanted)))
    expect(error < 2e-6, f"looked at every {interval} s it is the run of Rust within {error:.1e}")
expect(turned > 1.0, f"the crank turns by {turned:.1f} rad meanwhile")

# The tolerance that is handed over is that of the method.
errors = []
for tolerance in (1e-3, 1e-6, 1e-9):
    result = fmpy.simulate_fmu(file, fmi_type="CoSimulation", stop_time=0.9, output_interval=0.1, relative_tolerance=tolerance)
    found = np.array([[row[name] for name in names] for row in result])
    errors.append(np.max(np.abs(found[:9] - native[:90:10]) / (1.0 + np.abs(native[:90:10]))))
words = ", ".join(f"{error:.1e}" for error in errors)
is_tighter = errors[0] > 10 * errors[1] > 100 * errors[2]
expect(is_tighter and 1e-2 > errors[0] and 1e-4 > errors[1] and 1e-7 > errors[2], f"tolerances of 1e-3, 1e-6 and 1e-9 leave {words}")

# Methods by number, with their step.
for method, step, tolerance in ((1, 1e-3, 1e-11), (2, 1e-3, 1e-4)):
    start = {"plm(method)": method, "plm(step)": step}
    result = fmpy.simulate_fmu(
        file, fmi_type="CoSimulation", stop_time=0.9, output_interval=H, relative_tolerance=1e-9, start_values=start
    )
    found = np.array([[row[name] for name in names] for row in result])
    error = np.max(np.abs(found[:90] - native[:90]) / (1.0 + np.abs(native[:90])))
    expect(error < tolerance, f"method {method} is the run of Rust within {error:.1e}")

# A spring begins to push while a step is made: it returns there.
early = slave(early=True)
times = []
time = 0.0
while time < 0.9:
    event, _, returned, last = early.doStep(time, 0.9 - time)
    times.append(last)
    expect(event == returned and last > time, f"a step goes to {last:.4f} s{' and returns early' if returned else ''}")
    time = last
    if returned:
        early.enterEventMode()
        early.updateDiscreteStates()
        early.enterStepMode()
expect(len(times) > 1, "steps return early at events")

modes.check(folder, about, number["push"], outputs[0], expect)


def memory():
    """Memory that this process holds, kB."""
    with open("/proc/self/statm") as pages:
        return int(pages.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024


# The spring turns the crank for ever, so that a run of any length is one; the time may not pass 20 s.
fmu.reset()
fmu.enterInitializationMode()
fmu.exitInitializationMode()
begin = fmu.getFMUState()
marks = []
for k in range(STEPS):
    if k == STEPS // 5:
        marks.append(memory())
    step = k % 100_000
    if step == 0:
        fmu.setFMUState(begin)
    fmu.doStep(currentCommunicationPoint=step * 1e-4, communicationStepSize=1e-4)
    if k % 100 == 0:
        state = fmu.getFMUState()
        fmu.freeFMUState(fmu.deserializeFMUState(fmu.serializeFMUState(state)))
        fmu.freeFMUState(state)
marks.append(memory())
expect(marks[1] - marks[0] < 256, f"{STEPS} steps, the last {STEPS - STEPS // 5} of which took {marks[1] - marks[0]} kB more")
