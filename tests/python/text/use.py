"""What the types of the package plm must let pass, and what they must find."""

from typing import Optional

import numpy as np
from numpy.typing import NDArray

import plm

pendulum = plm.Mechanism("pub Pendulum { }")
results: plm.Results = pendulum.run(2.0, 0.1, ["bob.angle"], parameters={"length": "20 cm"}, inputs={"drive": 1.0})
angles: NDArray[np.float64] = results["bob.angle"]
poses: NDArray[np.float64] = results.poses["bob"]
sim: plm.Sim = pendulum.start(method="rk4", longest_step=1e-3)
sim.step(0.1)
sim["drive"] = sim["bob.angle"] + 1.0
sim.drive = 3.0  # attributes of a text are known when it runs
saved: plm.Snapshot = sim.save()
sim.restore(saved)
linear: plm.Linearisation = sim.linearise()
rolled: plm.Rollouts = pendulum.rollouts({"length": np.linspace(1, 2, 5), "mass": [1.0, 2.0]}, until=1.0, threads=2)
rows: NDArray[np.float64] = rolled["bob.angle"]
gradient: plm.Gradient = pendulum.gradient(["length"], 1.0)
slope: NDArray[np.float64] = gradient["bob.angle"]["length"]
shown: plm.Show = sim.show(1.0)
experiment = plm.Experiment(np.linspace(0, 1, 5), {"bob.angle": np.ones(5)}, inputs={"drive": ([0.0, 0.5], [1.0, 2.0])}, find=["bob.angle"])
fit: plm.Fit = pendulum.identify({"length": plm.Unknown("1 m", least=0.1)}, [experiment])
length: float = fit["length"]
fault: Optional[plm.Fault] = rolled.faults.get(0)

m = plm.Builder("four_bar", gravity=9.81)
ratio: plm.Expression = m.param("ratio", 0.5)
ground = m.ground(a=(0, 0), b=("1 m", ratio * "1 m", "90 deg"))
crank = m.body("crank", mass=1.0, inertia="0.1 kg*m^2", ports={"a": (0, 0)}, start={"angle": 0.5}, locked=["angle"])
m.revolute("pin", ground.a, crank.a, lower_limit=-0.5)
m.part("spring", "coil", ground.b, crank.a, stiffness=100.0)
m.output(crank.angle, unit="deg")
mechanism: plm.Mechanism = m.compile()

try:
    plm.Mechanism("wrong")
except plm.DeclarationError as error:
    code = error.diagnostics[0]["code"]

plm.Mechanism(3)  # type: ignore[arg-type]
pendulum.start(until=1.0)  # type: ignore[call-arg]
pendulum.rollouts(until="1 s")  # type: ignore[arg-type]
results.time  # type: ignore[attr-defined]
