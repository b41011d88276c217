"""Runs the FMU and the wheel of tests/exports.sh as its C program does: compare.py FOLDER."""

import sys
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave

from bouncer import Bouncer

folder = Path(sys.argv[1])
by_c = np.loadtxt(folder / "c.txt")
H = 0.01  # s
pushes = [1.5 if 100 < k <= 200 else 0.0 for k in range(1, len(by_c) + 1)]


def expect(found, what, most=0.0):
    apart = np.abs(np.array(found) - by_c).max()
    if not apart <= most:
        sys.exit(f"DOES NOT HOLD: {what}: {apart} apart")
    print(f"holds: {what}")


wheel = Bouncer()
by_python = []
for push in pushes:
    wheel.push = push
    wheel.step(H)
    by_python.append(wheel["block.x"])
expect(by_python, "the wheel has the bits of the library for C")

file = str(folder / "bouncer.fmu")
about = fmpy.read_model_description(file)
number = {variable.name: variable.valueReference for variable in about.modelVariables}
fmu = FMU3Slave(
    guid=about.instantiationToken,
    unzipDirectory=fmpy.extract(file),
    modelIdentifier=about.coSimulation.modelIdentifier,
)
fmu.instantiate()
fmu.enterInitializationMode()
fmu.exitInitializationMode()
by_fmu, time = [], 0.0
for push in pushes:
    fmu.setFloat64([number["push"]], [push])
    fmu.doStep(currentCommunicationPoint=time, communicationStepSize=H)
    time += H
    by_fmu += fmu.getFloat64([number["block.x"]])
fmu.terminate()
# It chooses the length of its first step anew in each interval. The motion is a polynomial between events: all steps are exact.
expect(by_fmu, "the FMU has the numbers of the library for C", 1e-12)
