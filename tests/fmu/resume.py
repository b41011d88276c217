"""Goes on from a saved state in a process of its own: resume.py FMU BYTES FIRST LAST prints the bits of the outputs."""

import sys

import fmpy
from fmpy.fmi3 import FMU3Slave

file, saved, first, last = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
about = fmpy.read_model_description(file)
outputs = [v.valueReference for v in about.modelVariables if v.causality == "output"]
fmu = FMU3Slave(
    guid=about.instantiationToken,
    unzipDirectory=fmpy.extract(file),
    modelIdentifier=about.coSimulation.modelIdentifier,
)
fmu.instantiate()
with open(saved, "rb") as bytes_:
    state = fmu.deserializeFMUState(bytes_.read())
fmu.setFMUState(state)
fmu.freeFMUState(state)
for k in range(first, last):
    print(*(number.hex() for number in fmu.getFloat64(outputs)))
    fmu.doStep(currentCommunicationPoint=k * 0.01, communicationStepSize=0.01)
