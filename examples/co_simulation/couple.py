"""Couples the FMUs of an arm and of its controller by FMPy, and compares with the one mechanism that has both: couple.py FOLDER.

Outputs are handed over every h, and inputs held in between: what the controller does comes late by half of h on average, so that the
coupling is off by a multiple of h. With half of h it has to be half as far off."""

import os
import sys

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave

folder = sys.argv[1]
whole = np.loadtxt(os.path.join(folder, "whole.csv"), delimiter=",")


class Slave:
    """An FMU, by names."""

    def __init__(self, name):
        about = fmpy.read_model_description(os.path.join(folder, name + ".fmu"))
        self.number = {variable.name: variable.valueReference for variable in about.modelVariables}
        place = fmpy.extract(os.path.join(folder, name + ".fmu"))
        identifier = about.coSimulation.modelIdentifier
        self.fmu = FMU3Slave(guid=about.instantiationToken, unzipDirectory=place, modelIdentifier=identifier)
        self.fmu.instantiate()
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def get(self, name):
        return self.fmu.getFloat64([self.number[name]])[0]

    def set(self, name, value):
        self.fmu.setFloat64([self.number[name]], [value])

    def step(self, time, h):
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=h)


def coupled(h):
    """The angle of the arm at the times of the whole mechanism."""
    arm, controller = Slave("arm"), Slave("controller")
    angles, every = [], round(whole[1, 0] / h)
    for k in range(every * (len(whole) - 1) + 1):
        if k % every == 0:
            angles.append(arm.get("arm.angle"))
        for quantity in ("angle", "omega"):
            controller.set(quantity, arm.get("arm." + quantity))
        arm.set("torque", controller.get("torque"))
        arm.step(k * h, h)
        controller.step(k * h, h)
    return np.array(angles)


steps = [0.002, 0.001, 0.0005]
errors = [np.max(np.abs(coupled(h) - whole[:, 1])) for h in steps]
for h, error in zip(steps, errors):
    print(f"h = {h} s: the angle is off by at most {error:.2e} rad")
final = np.degrees(whole[-1, 1])
ratios = [errors[k] / errors[k + 1] for k in range(2)]
print(f"half the step, {ratios[0]:.3f} and {ratios[1]:.3f} times less; the arm ends at {final:.2f} deg")
# Of first order, but for what is left of the second: it halves with each step.
off = [abs(ratio - 2.0) for ratio in ratios]
if not (off[1] < 0.6 * off[0] + 1e-3 and off[1] < 0.05 and np.max(np.abs(whole[:, 1])) > 1.0):
    sys.exit("the coupling does not converge to the whole mechanism")
