#!/usr/bin/env python3
"""Length, damping and start of a pendulum by 60 readings, identified by MuJoCo's toolbox for system identification: error and time.

    pip install 'mujoco[sysid]'
    cargo run --release -p plm-studies --example pictures -- --time
    python3 benches/peers/by_mujoco_sysid.py

The problem is that of `by_scipy.py`: the same guess, and readings of SciPy's DOP853 at a tolerance of 1e-13. The toolbox compiles a model
for each trial and differentiates by differences, by its own search, as its documentation has it. MuJoCo steps by RK4 with a fixed step;
the readings lie on its grid. The residual is written here, since the toolbox takes initial states as known.
"""

import contextlib
import io
import logging
import math
import time

import mujoco
import numpy as np
from mujoco import rollout, sysid

from by_scipy import GUESS, TIMES, TRUTH, angles

MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.81"><flag contact="disable"/></option>
  <worldbody><body name="bob">
    <inertial pos="0 0 -0.7" mass="1" diaginertia="0.01 0.01 0.01"/>
    <joint name="hinge" type="hinge" axis="0 -1 0" damping="0"/>
  </body></worldbody>
  <sensor><jointpos name="angle" joint="hinge"/></sensor>
</mujoco>
"""


def set_length(spec, parameter):
    """Puts the centre of gravity below the hinge."""
    spec.body("bob").ipos = [0.0, 0.0, -parameter.value[0]]


def set_damping(spec, parameter):
    """Damps the hinge."""
    # The first number is that of the speed, others are those of its powers.
    damping = np.zeros_like(spec.joint("hinge").damping)
    damping[0] = parameter.value[0]
    spec.joint("hinge").damping = damping


def parameters():
    """The unknowns at their guess."""
    found = sysid.ParameterDict()
    bounds = [(0.1, 3.0), (-1.0, 1.0), (-2.0, 2.0)]
    for name, guess, (least, most), modifier in zip(["length", "damping", "start"], GUESS, bounds, [set_length, set_damping, None]):
        found.add(sysid.Parameter(name, guess, least, most, modifier=modifier))
    return found


def identified(step, readings):
    """Unknowns that the toolbox finds."""
    spec = mujoco.MjSpec.from_string(MODEL.format(step=step))
    every = round(TIMES[1] / step)
    count = every * (len(TIMES) - 1)

    def residual(x, found):
        # Columns are the trials of a difference; the threads of rollout share them.
        columns = np.reshape(x, (len(x), -1)).T
        models, states = [], []
        for column in columns:
            found.update_from_vector(column)
            models.append(sysid.apply_param_modifiers(found, spec))
            states.append(sysid.create_initial_state(models[-1], column[2:], np.zeros(1), np.zeros(0)))
        data = [mujoco.MjData(models[0]) for _ in range(2)]
        runs, _ = rollout.rollout(models, data, np.array(states), nstep=count)
        off = np.column_stack([columns[:, 2], runs[:, every - 1 :: every, 1]]) - readings
        return [off.T if np.ndim(x) > 1 else off[0]], None, None

    # The search tells each iteration.
    with contextlib.redirect_stdout(io.StringIO()):
        found, _ = sysid.optimize(parameters(), residual, optimizer="mujoco", verbose=False)
    return found.as_vector()


def main():
    """Prints the largest relative error of an unknown, and the time."""
    logging.disable(logging.WARNING)
    readings = angles(TRUTH, 1e-13)
    for step in [0.01, 0.001]:
        best = math.inf
        for _ in range(5):
            begun = time.perf_counter()
            found = identified(step, readings)
            best = min(best, time.perf_counter() - begun)
        error = np.max(np.abs(found / TRUTH - 1.0))
        print(f"MuJoCo {mujoco.__version__} with steps of {step:g} s: error {error:.1e} after {1e3 * best:.1f} ms")


if __name__ == "__main__":
    main()
