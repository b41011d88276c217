"""What the types of a wheel must let pass, and what they must find."""

import copy
from typing import Optional

import numpy as np
from numpy.typing import NDArray

from gantry import Fault, Gantry, Linearisation, Pose, Results

m = Gantry(load=2.0, mass=3.0, start={"bar.angle": 0.5}, method="dop853", tolerance=1e-8)
m.push = 3.0
m["push"] = m.push + m.level + m.get("bar.angle")
m.step(0.1)
results: Results = m.run(2.0, every=0.1, outputs=["bar.angle"], progress=lambda time: None)
angles: NDArray[np.float64] = results["bar.angle"]
linear: Linearisation = m.linearise()
a: NDArray[np.float64] = linear.A
pose: Pose = m.pose("bar")
unit: str = m.outputs["bar.angle"].unit
m.restore(m.save())
other: Gantry = copy.copy(m)
try:
    m.run(1.0)
except Fault as fault:
    kept: Optional[Results] = fault.results

m.level = 3.0  # type: ignore[misc]
m.pusch  # type: ignore[attr-defined]
m.pusch = 3.0  # type: ignore[attr-defined]
Gantry()  # type: ignore[call-arg]
Gantry(load=2.0, mas=3.0)  # type: ignore[call-arg]
Gantry(load="heavy")  # type: ignore[arg-type]
