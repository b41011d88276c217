# %% A run, and its curves
import matplotlib.pyplot as plt
import numpy as np

from pendulum import Fault, Pendulum

m = Pendulum(friction=0.3, start={"bar.angle": np.radians(60)})
free = m.run(until=4.0, every=0.01)
m.drive = 2.0
driven = m.run(until=8.0, every=0.01)

figure, (angle, damping, answer) = plt.subplots(1, 3, figsize=(11, 3.2), layout="constrained")
angle.plot(free["time"], np.degrees(free["bar.angle"]), label="free")
angle.plot(driven["time"], np.degrees(driven["bar.angle"]), label="driven")
angle.set(xlabel="time, s", ylabel="angle of the bar, deg")
angle.legend()

# %% Many runs
for friction in (0.1, 0.5, 2.0, 8.0):
    results = Pendulum(friction=friction).run(until=4.0)
    damping.plot(results["time"], np.degrees(results["bar.angle"]), label=f"{friction} N m s/rad")
damping.set(xlabel="time, s", title="friction")
damping.legend()

# %% The linear system at rest, and its answer to the drive
m = Pendulum(start={"bar.angle": 0.0})
A, B, C, D = m.linearise(outputs=["bar.angle"])[:4]
print("eigenvalues", np.linalg.eigvals(A))
omega = np.geomspace(0.5, 50, 400)
one = np.eye(len(A))
gain = [abs((C @ np.linalg.solve(1j * w * one - A, B) + D)[0, 0]) for w in omega]
answer.loglog(omega, np.degrees(gain))
answer.set(xlabel="frequency of the drive, rad/s", ylabel="answer of the angle, deg/(N m)")

# %% What was found before a fault is not lost
m = Pendulum()
m.drive = 30.0
try:
    m.run(until=10.0)
except Fault as fault:
    print(fault)
    print(f"{fault.part!r} at {fault.time:.3f} s, after {len(fault.results['time'])} rows")

# %%
figure.savefig("pendulum.svg")
