"""Looks at the FMU of FMI 2.0 of the press of tests/foreign.rs, beside that of 3.0: two.py FMU_OF_2 FMU_OF_3 ROWS, where the rows
are the outputs of Rust every 10 ms."""

import os
import sys
import zipfile

import fmpy
import modes
import numpy as np
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model
from fmpy.validation import validate_fmu
from lxml import etree

file, three, rows = sys.argv[1:]
native = np.loadtxt(rows, delimiter=",")
H = 0.01


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


problems = validate_fmu(file)
expect(not problems, f"FMPy has no message {problems}")
schema = os.path.join(os.path.dirname(fmpy.__file__), "schema", "fmi2", "fmi2ModelDescription.xsd")
schema = etree.XMLSchema(file=schema)
description = etree.fromstring(zipfile.ZipFile(file).read("modelDescription.xml"))
expect(schema.validate(description), f"the XML schemas of FMI 2.0 have no message {schema.error_log}")

about, of_three = fmpy.read_model_description(file), fmpy.read_model_description(three)
folder = fmpy.extract(file)
number = {variable.name: variable.valueReference for variable in about.modelVariables}
same = [(v.name, v.valueReference, v.causality, v.unit, v.start) for v in about.modelVariables]
expect(
    same == [(v.name, v.valueReference, v.causality, v.unit, v.start) for v in of_three.modelVariables],
    f"the {len(same)} variables are those of 3.0",
)
outputs = [v.valueReference for v in about.modelVariables if v.causality == "output"]


def made(kind, **arguments):
    fmu = kind(guid=about.guid, unzipDirectory=folder, modelIdentifier=about.coSimulation.modelIdentifier)
    fmu.instantiate()
    fmu.setupExperiment(**arguments)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    return fmu


def run(fmu, first, last):
    values = []
    for k in range(first, last):
        if k == 100:
            fmu.setReal([number["push"]], [-7.5])
        values.append(fmu.getReal(outputs))
        fmu.doStep(currentCommunicationPoint=k * H, communicationStepSize=H)
    return np.array(values)


fmu = made(FMU2Slave)
expect(np.array_equal(run(fmu, 0, 200), native), "co-simulation has the bits of Rust")
fmu.reset()
fmu.setupExperiment()
fmu.enterInitializationMode()
fmu.exitInitializationMode()
run(fmu, 0, 50)
state = fmu.getFMUState()
saved = fmu.serializeFMUState(state)
once = run(fmu, 50, 120)
fmu.setFMUState(state)
fmu.freeFMUState(state)
again = run(fmu, 50, 120)
expect(np.array_equal(once, again) and np.array_equal(once, native[50:120]), "roll-back is equal to the bit")
state = fmu.deserializeFMUState(saved)
fmu.setFMUState(state)
fmu.freeFMUState(state)
expect(np.array_equal(run(fmu, 50, 120), once), f"a state in {len(saved)} bytes is equal to the bit")


def fails(call):
    before = fmu.getReal([0] + outputs)
    try:
        call()
    except Exception:
        return fmu.getReal([0] + outputs) == before
    return False


expect(fails(lambda: fmu.doStep(0.0, H)), "a step back in time is refused")
expect(fails(lambda: fmu.setReal([number["push"]], [float("nan")])), "an input of NaN is refused")
expect(fails(lambda: fmu.setReal([outputs[0]], [1.0])), "an output that is set is refused")
expect(fails(lambda: fmu.getReal([number["plm(method)"]])), "a method is no real number")
expect(fails(lambda: fmu.setInteger([number["plm(method)"]], [3])), "a method is refused once it runs")
expect(fails(lambda: fmu.doStep(120 * H, 100.0)), "a requirement that fails is told, and the run stays")

# Derivatives beside those of 3.0, which check.py holds against quotients.
model = made(FMU2Model)
model.newDiscreteStates()
model.enterContinuousTimeMode()
other = FMU3Model(
    guid=of_three.instantiationToken,
    unzipDirectory=fmpy.extract(three),
    modelIdentifier=of_three.modelExchange.modelIdentifier,
)
other.instantiate()
other.enterInitializationMode()
other.exitInitializationMode()
other.updateDiscreteStates()
other.enterContinuousTimeMode()
rates = [v.valueReference for v in about.modelVariables if v.derivative is not None]
states = [v.derivative.valueReference for v in about.modelVariables if v.derivative is not None]
for known in [number["push"], number["stiff"], *states]:
    tangents = [one.getDirectionalDerivative(rates + outputs, [known], [1.0]) for one in (model, other)]
    if not np.array_equal(*tangents):
        expect(False, f"derivatives by {known}: {tangents}")
expect(True, "derivatives are those of 3.0, to the bit")


def simulated(of, kind, interval, **arguments):
    return fmpy.simulate_fmu(of, fmi_type=kind, stop_time=0.9, output_interval=interval, record_events=False, **arguments)


for kind, interval in (("CoSimulation", 0.01), ("ModelExchange", 0.01), ("ModelExchange", 0.3)):
    own, others = (simulated(of, kind, interval, relative_tolerance=1e-9) for of in (file, three))
    expect(np.array_equal(own, others), f"FMPy's {kind} every {interval} s is that of 3.0, to the bit")

modes.check(folder, about, number["push"], outputs[0], expect)
