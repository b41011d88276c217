"""Looks at the wheel of the gantry of tests/python.rs: check.py FOLDER, where the rows of Rust are."""

import copy
import inspect
import math
import pickle
import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np

import gantry
from common import expect, refused
from gantry import Fault, Gantry, Results

folder = Path(sys.argv[1])


def rows(name):
    return np.loadtxt(folder / f"{name}.csv", delimiter=",")


names = list(Gantry(load=2.0).outputs)


def observed(m):
    return [m[name] for name in names]


# The bits of Rust.
m = Gantry(load=2.0)
found = []
for k in range(1000):
    if k == 300:
        m.push = -7.5
    if k == 500:
        m["run"] = 55.0
    m.step(0.001)
    found.append(observed(m))
expect(np.array_equal(found, rows("steps")), "1000 steps have the bits of Rust")
changed = dict(load=2.0, tilt=0.5, start={"trolley.x": -0.02})
for method, options in (
    ("dop853", dict(tolerance=1e-8)),
    ("RadauIia5", dict(tolerance=1e-7)),
    ("rk4", dict(longest_step=1e-3)),
):
    m = Gantry(**changed, method=method, **options)
    results = m.run(1.0, every=0.01, outputs=names)
    columns = np.column_stack([results[name] for name in names])
    expect(np.array_equal(columns, rows(method.lower())), f"a run by {method} has the bits of Rust")
expect(
    np.array_equal(Gantry(**changed, method="dop853:1e-8").run(1.0, 0.01, names)[names[0]], rows("dop853")[:, 0]),
    "a method is named as on the command line",
)

# Results are arrays.
m = Gantry(load=2.0)
results = m.run(0.5)
expect(isinstance(results, Results) and isinstance(results, dict), "results are a dict")
expect(list(results) == ["time", "bar.angle", "hinge.force.x", "hinge.force.y", "trolley.x"], "with what was declared")
for name, column in results.items():
    expect(column.shape == (1001,) and column.dtype == np.float64 and column.flags.writeable, f"{name} is an array")
expect(results.units["trolley.x"] == "m" and results.units["bar.angle"] == "rad", "in SI")
expect(results["time"][0] == 0.0 and results["time"][-1] == 0.5 == m.time, "from the start to the end")
expect(results["bar.angle"][-1] == m["bar.angle"], "whose last row is the present")

moved = m.run(0.7, 0.1, poses=True)
expect(moved.poses["bar"].shape == (3, 6) and moved.poses["bar"][-1].tolist() == list(m.pose("bar")), "poses are had")
expect(moved.stats == m.stats() and m.stats()["steps"] > 0 and m.stats()["switches"] >= 0, "and counters")
m = Gantry(load=2.0)
m.run(0.5)

# What a mechanism tells of itself.
expect(m.parameters["tilt"].unit == "rad" and m.parameters["tilt"].declared_unit == "deg", "units are told")
expect(math.isclose(m.tilt, math.radians(20.0)) and m.parameters["tilt"].docs == "At the start.", "values are SI")
expect(m.outputs["trolley.x"].declared_unit == "mm" and m.starts["bar.omega"].unit == "rad/s", "of all quantities")
expect(math.isclose(m.starts["bar.angle"].default, m.tilt) and m.starts["trolley.x"].default == 0.1, "starts are told")
expect(m.bodies == ("trolley", "bar") and m.pose("bar").angle == m["bar.angle"], "poses are had by name")
expect('Quotes "in" \\ text.' in Gantry.__doc__ and "Of the trolley." in Gantry.__doc__, "its documentation is there")
expect("mass" in inspect.signature(Gantry).parameters, "parameters are keywords of its signature")
expect(m.level == m["level"], "a state is read")
expect(m.run(m.time)["time"].tolist() == [0.5], "a run to the present is one row")


class Heavy(Gantry):
    """A class of a user's own."""

    def __init__(self):
        super().__init__(load=20.0)
        self.log = []


expect(Heavy().load == 20.0 and Heavy().run(0.1)["time"].size == 1001 and Heavy().log == [], "a class can be built upon")

# Save, restore, copies.
m = Gantry(load=2.0)
m.push = 3.0
m.run(0.3)
saved, twin = m.save(), copy.copy(m)
once = m.run(0.6, 0.01)
m.restore(saved)
again, beside = m.run(0.6, 0.01), copy.deepcopy(twin).run(0.6, 0.01)
expect(all(np.array_equal(once[k], again[k]) and np.array_equal(once[k], beside[k]) for k in once), "to the bit")
expect(twin.time == 0.3 and m.time == 0.6, "a copy stands for itself")
refused(TypeError, "must have been saved by a Gantry", lambda: m.restore(twin))

# Linearised at its equilibrium, beside the difference quotient of two runs: y(T) of a push from T = 0 on.
REST = dict(load=2.0, tilt=0.0, start={"trolley.x": 0.0})
T, H = 0.4, 1e-3
m = Gantry(**REST)
linear = m.linearise()
states = linear.A.shape[0]
expect(linear.A.shape == (5, 5) and linear.B.shape == (5, 1) and linear.C.shape == (4, 5), "of five states")
expect(linear.inputs == ("push",) and linear.outputs == tuple(results)[1:], "inputs and outputs have names")
flow = np.zeros((states + 1, states + 1))
flow[:states, :states], flow[:states, states:] = linear.A * T, linear.B * T
# The exponential by scaling, Taylor's sum, and squaring: of a matrix of norm below 1e-2 eight terms leave 1e-21.
scaled, power, exponential = flow / 2**14, np.eye(states + 1), np.eye(states + 1)
expect(np.linalg.norm(scaled) < 1e-2, "the matrix is scaled")
for k in range(1, 9):
    power = power @ scaled / k
    exponential += power
for _ in range(14):
    exponential = exponential @ exponential
response = linear.C @ exponential[:states, states:] + linear.D


def after(push):
    m = Gantry(**REST, tolerance=1e-12)
    m.push = push
    m.run(T)
    return np.array([m[name] for name in linear.outputs])


# The error of the quotient falls as H^2; that of Richardson's extrapolation is left, and rounding of some 1e-10 / H.
quotient = (8 * (after(H) - after(-H)) - (after(2 * H) - after(-2 * H))) / (12 * H)
error = np.max(np.abs(response[:, 0] - quotient) / (1e-3 + np.abs(response[:, 0])))
expect(error < 1e-6, f"the linear system answers as the difference quotient of runs does, within {error:.1e}")
some = m.linearise(inputs=[], outputs=["trolley.x"])
expect(some.B.shape == (5, 0) and np.array_equal(some.C, linear.C[3:]), "of some inputs and outputs")

# Bad use.
m = Gantry(load=2.0)
before = observed(m)
refused(TypeError, "there is no parameter 'mas'; did you mean 'mass'?", lambda: Gantry(load=2.0, mas=3.0))
refused(TypeError, "must be given: load", lambda: Gantry())
refused(TypeError, "", lambda: Gantry(2.0))
refused(TypeError, "", lambda: Gantry(load="heavy"))
refused(ValueError, "mass must be a finite number", lambda: Gantry(load=2.0, mass=math.nan))
refused(ValueError, "time must be a finite number", lambda: Gantry(load=2.0, time=math.inf))
refused(KeyError, "did you mean 'bar.angle'", lambda: Gantry(load=2.0, start={"bar.angel": 0.5}))
refused(Fault, "the mass must be positive", lambda: Gantry(load=2.0, mass=-1.0))
refused(ValueError, "no method 'rk5'; did you mean 'rk4'?", lambda: Gantry(load=2.0, method="rk5", longest_step=1))
refused(ValueError, "longest_step, not tolerance", lambda: Gantry(load=2.0, method="rk4", tolerance=1e-8))
refused(ValueError, "tolerance, not longest_step", lambda: Gantry(load=2.0, longest_step=1e-3))
refused(ValueError, "which must be given: longest_step=1e-3", lambda: Gantry(load=2.0, method="rk4"))
refused(ValueError, "tolerance must be a positive number, not -1.0", lambda: Gantry(load=2.0, tolerance=-1))
refused(TypeError, "longest_step must be a number", lambda: Gantry(load=2.0, method="rk4", longest_step="1e-3"))
refused(TypeError, "method must be a name", lambda: Gantry(load=2.0, method=4))
refused(TypeError, "'tilt' is given twice", lambda: Gantry(load=2.0, tilt=0.1, parameters={"tilt": 0.2}))
refused(ValueError, "tolerance must be a finite number, not nan", lambda: Gantry(load=2.0, tolerance=math.nan))
refused(KeyError, "did you mean 'trolley.x'", lambda: m["troley.x"])
refused(KeyError, "there is no quantity 7", lambda: m[7])
refused(AttributeError, "did you mean 'push'", lambda: m.pusch)
refused(AttributeError, "did you mean 'push'", lambda: setattr(m, "pusch", 1.0))
refused(AttributeError, "can be read, not set", lambda: m.set("bar.angle", 1.0))
refused(AttributeError, "", lambda: setattr(m, "time", 1.0))
refused(AttributeError, "", lambda: setattr(m, "run", 1.0))
refused(ValueError, "push must be a finite number", lambda: m.set("push", math.nan))
refused(TypeError, "push must be a number, not None", lambda: m.set("push", None))
refused(ValueError, "dt must not be negative: -0.1", lambda: m.step(-0.1))
refused(ValueError, "dt must be a finite number, not nan", lambda: m.step(math.nan))
refused(ValueError, "dt must be a finite number, not inf", lambda: m.step(math.inf))
refused(TypeError, "dt must be a number, not '0.1'", lambda: m.step("0.1"))
refused(ValueError, "until must not be before the time of the run, 0.0 s: -1.0", lambda: m.run(-1.0))
refused(ValueError, "until must be a finite number", lambda: m.run(math.nan))
refused(ValueError, "every must be positive: 0.0", lambda: m.run(1.0, every=0.0))
refused(ValueError, "every must be a finite number", lambda: m.run(1.0, every=math.nan))
refused(ValueError, "an interval of 1e-300 s cannot be integrated", lambda: m.run(1.0, every=1e-300))
refused(TypeError, "a list of names", lambda: m.run(1.0, outputs="bar.angle"))
refused(KeyError, "did you mean 'bar.angle'", lambda: m.run(1.0, outputs=["bar.angl"]))
refused(KeyError, "there is no body 'arm'", lambda: m.pose("arm"))
refused(KeyError, "no declared output 'trolley.vx'", lambda: m.linearise(outputs=["trolley.vx"]))
refused(KeyError, "no input 'pull'", lambda: m.linearise(inputs=["pull"]))
refused(KeyError, "did you mean 'trolley.x'", lambda: results["trolley"])
native = Gantry._native
refused(TypeError, "", lambda: native())
refused(ValueError, "no such kind", lambda: m._run.get(99, 0))
refused(ValueError, "no such kind, number", lambda: m._run.get(0, 10**6))
refused(OverflowError, "", lambda: m._run.get(0, -1))
refused(ValueError, "no such kind, number", lambda: m._run.pose(2))
refused(ValueError, "can be read", lambda: m._run.set(3, 0, 1.0))
refused(ValueError, "not a number", lambda: m._run.set(1, 0, math.nan))
refused(TypeError, "", lambda: m._run.restore(None))
expect(observed(m) == before and m.time == 0.0, "nothing of this has changed anything")

# Names that Python has for itself.
other = Gantry(load=2.0, **{"lambda": 0.5}, run=50.0, parameters={"method": 3.0})
expect([other[name] for name in ("lambda", "run", "method")] == [0.5, 50.0, 3.0], "are had by their full names")
expect(not hasattr(other, "lambda") and callable(other.run) and other.method == 3.0, "and methods stay methods")

# Faults.
m = Gantry(load=2.0)
m.mass = -2.0
before = observed(m)
fault = refused(Fault, "the mass must be positive", lambda: m.step(0.1))
expect(m.time == 0.0 and fault.time == 0.0, "a step that fails changes nothing")
m.mass = 3.0
m.step(0.1)
expect(m.time == 0.1, "and once it is mended it goes on")
m = Gantry(load=2.0)
m.push = 1e5
fault = refused(Fault, "near: this requirement does not hold", lambda: m.run(1.0, every=1e-3))
last = fault.results["time"][-1]
expect(fault.part == "near" and abs(last - fault.time) < 1e-9 and m.time == last, "a run that fails stays where it came")
expect(abs(fault.results["trolley.x"][-1] - 2.0) < 1e-6 and len(fault.results["time"]) > 30, "with its results")
expect(np.all(np.isfinite(fault.results["bar.angle"])), "all of which are numbers")
again = pickle.loads(pickle.dumps(fault))
expect((str(again), again.time, again.part) == (str(fault), fault.time, "near"), "faults go to other processes")
expect(type(fault).__module__ == "gantry" and type(fault) is gantry.Fault, "by the name under which they are imported")

# Progress, and what ends a run.
LONG = 1e6
m = Gantry(load=2.0)
told = []


def patient(time):
    told.append(time)
    if len(told) == 3:
        raise LookupError("enough")


error = refused(LookupError, "enough", lambda: m.run(LONG, every=1.0, progress=patient))
expect(len(told) == 3 and told == sorted(told) and m.time >= told[-1], "progress tells the time, and may end a run")
expect(error.results["time"][-1] == m.time, "which stays where it came")
middle = m.time
m.run(middle + 0.5)
expect(m.time == middle + 0.5, "and goes on")
# In the background of a shell the signal is ignored from the start.
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT)).start()
clock = time.perf_counter()
# A million steps, after which any run is ended, take a good while with a hundred samples in each.
interrupt = refused(KeyboardInterrupt, "", lambda: m.run(LONG, every=0.01))
expect(time.perf_counter() - clock < 5.0, "Ctrl+C ends a run at once")
expect(len(interrupt.results["time"]) > 1 and interrupt.results["time"][-1] == m.time, "which keeps its results")
threading.Timer(0.03, lambda: signal.raise_signal(signal.SIGINT)).start()
refused(KeyboardInterrupt, "", lambda: m.step(LONG))
m.step(0.1)
expect(m.run(m.time + 0.01, progress=True)["time"].size == 1001, "a line shows the progress")

# Set while it runs, by progress and from threads.
m = Gantry(load=2.0)
refused(RuntimeError, "copy.copy(it)", lambda: m.run(LONG, every=1.0, progress=lambda time: m.set("push", 1.0)))
refused(RuntimeError, "copy.copy(it)", lambda: m.run(LONG, every=1.0, progress=lambda time: m.time))
said, ends = [], threading.Event()


def until_ended(time):
    if ends.is_set():
        raise StopIteration


def run():
    try:
        m.run(LONG, every=1.0, progress=until_ended)
    except StopIteration:
        said.append("ended")


thread = threading.Thread(target=run)
thread.start()
time.sleep(0.2)
for call in (lambda: m.push, lambda: m.step(0.1), lambda: m.run(1.0), lambda: copy.copy(m), lambda: m.restore(saved)):
    refused(RuntimeError, "Gantry runs, in another thread", call)
ends.set()
thread.join()
expect(said == ["ended"], "a thread that runs is not disturbed")
m.step(0.1)

# Threads with objects of their own run side by side, and have the same numbers.
many = [Gantry(load=2.0) for _ in range(4)]
columns = {}
threads = [threading.Thread(target=lambda k=k: columns.update({k: many[k].run(5.0, 0.01)})) for k in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
expect(all(np.array_equal(columns[k]["bar.angle"], columns[0]["bar.angle"]) for k in range(4)), "threads run apart")

# Memory.
import resource

marks = []
for k in range(3000):
    if k in (1000, 2999):
        marks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    Gantry(load=2.0).run(0.01)
expect(marks[1] - marks[0] < 2048, f"2000 objects with a run took {marks[1] - marks[0]} kB more")
