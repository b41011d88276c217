"""Times 100 000 steps of Rk4 of the double pendulum: speed.py FOLDER, where the repository is."""

import sys
import time
from pathlib import Path

import plm

STEPS = 100_000
mechanism = plm.Mechanism.from_file(Path(sys.argv[1]) / "tests/snapshots/double_pendulum.plm")
best = float("inf")
for _ in range(5):
    sim = mechanism.start(method="rk4", longest_step=1e-4)
    begin = time.process_time()
    sim.run(1e-4 * STEPS, every=1e-4 * STEPS)
    best = min(best, time.process_time() - begin)
    assert sim.stats()["steps"] == STEPS
print(f"plm from text: {best:.4f} s, {best / STEPS * 1e9:.0f} ns a step")
try:
    from double_pendulum import DoublePendulum
except ImportError:
    print("the wheel double_pendulum is not installed here: no ratio")
    sys.exit()
of_compiled = float("inf")
for _ in range(5):
    run = DoublePendulum(method="rk4", longest_step=1e-4)
    begin = time.process_time()
    run.run(1e-4 * STEPS, every=1e-4 * STEPS)
    of_compiled = min(of_compiled, time.process_time() - begin)
assert run.get("arm.angle") == sim["arm.angle"]
print(f"compiled by rustc: {of_compiled:.4f} s, {of_compiled / STEPS * 1e9:.0f} ns a step; ratio {best / of_compiled:.2f}")
