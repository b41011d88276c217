"""What the types of a wheel must let pass, and what they must find."""

import copy
from typing import Optional

import numpy as np
from numpy.typing import NDArray

import gantry
from gantry import Event, Fault, Gantry, Jacobian, Linearisation, Pose, Results, Snapshot

m = Gantry(load=2.0, mass=3.0, start={"bar.angle": 0.5}, method="dop853", tolerance=1e-8)
m.push = 3.0
m["push"] = m.push + m.level + m.get("bar.angle")
m.step(0.1)
steps: float = m.stats()["steps"]
poses: NDArray[np.float64] = m.run(1.0, poses=True).poses["bar"]
results: Results = m.run(2.0, every=0.1, outputs=["bar.angle"], progress=lambda time: None)
angles: NDArray[np.float64] = results["bar.angle"]
linear: Linearisation = m.linearise()
a: NDArray[np.float64] = linear.A
names: tuple[str, ...] = linear.states + linear.coordinates + m.state_names
jacobian: Jacobian = m.jacobian(inputs=[])
m.state = m.state + 0.1 * m.rates()
pose: Pose = m.pose("bar")
events: tuple[Event, ...] = results.events
known: bool = "bar.angle" in m
version: str = gantry.__version__
unit: str = m.outputs["bar.angle"].unit
saved: Snapshot = m.save()
m.restore(saved)
m.restore(bytes(saved))
m.level = 3.0
other: Gantry = copy.copy(m)
try:
    m.run(1.0)
except Fault as fault:
    kept: Optional[Results] = fault.results

m.time = 3.0  # type: ignore[misc]
m.pusch  # type: ignore[attr-defined]
m.pusch = 3.0  # type: ignore[attr-defined]
Gantry()  # type: ignore[call-arg]
Gantry(load=2.0, mas=3.0)  # type: ignore[call-arg]
Gantry(load="heavy")  # type: ignore[arg-type]
