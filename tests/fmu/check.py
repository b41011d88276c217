"""Looks at the FMU of the press of tests/foreign.rs: check.py FMU ROWS, where the rows are the outputs of Rust every 10 ms."""

import resource
import sys

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu

file, rows = sys.argv[1:]
native = np.loadtxt(rows, delimiter=",")
H = 0.01


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


problems = validate_fmu(file)
expect(not problems, f"FMPy has no message {problems}")

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
once = run(fmu, 50, 120)
fmu.setFMUState(state)
again = run(fmu, 50, 120)
fmu.freeFMUState(state)
expect(np.array_equal(once, again) and np.array_equal(once, native[50:120]), "roll-back is equal to the bit")


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
for name, reference in number.items():
    known = reference in states or name in ("push", "stiff", "load")
    if not known:
        continue
    value = model.getFloat64([reference])[0]
    h = 6e-6 * max(1.0, abs(value))

    def at(moved):
        if reference in states:
            x = model.getFloat64(states)
            x[states.index(reference)] = moved
            model.setContinuousStates((np.ctypeslib.ctypes.c_double * len(x))(*x), len(x))
        else:
            model.setFloat64([reference], [moved])
        return np.array(model.getFloat64(unknowns))

    quotient = (8 * (at(value + h) - at(value - h)) - (at(value + 2 * h) - at(value - 2 * h))) / (12 * h)
    at(value)
    exact = np.array(model.getDirectionalDerivative(unknowns, [reference], [1.0]))
    worst = max(worst, np.max(np.abs(exact - quotient) / (1.0 + np.abs(exact))))
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

# A spring begins to push while a step is made: it returns there.
early = slave(early=True)
times = []
time = 0.0
while time < 0.9:
    event, _, returned, last = early.doStep(time, 0.9 - time)
    times.append(last)
    expect(event == returned and last > time, f"a step goes to {last:.4f} s{' and returns early' if returned else ''}")
    time = last
expect(len(times) > 1, "steps return early at events")

# Memory.
fmu.reset()
fmu.enterInitializationMode()
fmu.exitInitializationMode()
marks = []
for k in range(100_000):
    if k in (20_000, 99_999):
        marks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    fmu.doStep(currentCommunicationPoint=k * 1e-4, communicationStepSize=1e-4)
expect(marks[1] - marks[0] < 1024, f"80 000 steps took {marks[1] - marks[0]} kB more")
