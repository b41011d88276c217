"""Looks at what the wheel of the gantry of tests/python.rs does with states, bytes, records and notebooks: more.py FOLDER."""

import copy
import importlib.metadata
import math
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np

import gantry
from common import expect, refused
from gantry import Event, Gantry, Snapshot

folder = Path(sys.argv[1])

expect(gantry.__version__ == importlib.metadata.version("gantry"), f"its version is {gantry.__version__}")

# Names.
m = Gantry(load=2.0)
expect("bar.angle" in m and "push" in m and "level" in m and "lambda" in m, "what m[...] has is in m")
expect("bar.angel" not in m and 0 not in m, "and nothing else")
expect(list(m) == list(m.parameters) + list(m.inputs) + list(m.outputs) + list(m.states), "which can be listed")
expect({name: m[name] for name in m}["tilt"] == m.tilt, "and read one by one")

# Whatever is read can be recorded, once.
m.push = 3.0
first = m.run(0.5, 0.1, outputs=["push", "level", "mass", "bar.angle", "push", "time"])
m.push = -1.0
second = m.run(1.0, 0.1, outputs=["push"])
expect(list(first) == ["time", "push", "level", "mass", "bar.angle"], "inputs, states and parameters have columns")
expect(np.all(first["push"] == 3.0) and np.all(second["push"] == -1.0), "an input is recorded as it was set")
expect(first["level"][-1] != 3.0 and abs(first["level"][-1] - 3.0 * (1 - math.exp(-5.0))) < 1e-8, "a state as it moved")
expect(first.units == {"time": "s", "push": "N", "level": "N", "mass": "kg", "bar.angle": "rad"}, "each with its unit")

# Events: the stop of the trolley acts beyond 0.05 m, where it starts; behind it a wall throws it back.
expect(all(isinstance(event, Event) and event.name == "stop" for event in first.events), "events have the name of a part")
expect([event.name for event in second.events] == ["wall", "wall"], "or of a row of contact")
stops = [event.time for event in first.events]
crossings = np.interp(stops, first["time"], first["time"])
fine = Gantry(load=2.0)
fine.push = 3.0
x = fine.run(0.5, 1e-4, outputs=["trolley.x"])
over = x["trolley.x"] > 0.05
switched = x["time"][1:][np.diff(over.astype(int)) != 0]
expect(
    len(switched) == len(stops) > 0 and np.max(np.abs(switched - crossings)) <= 1.01e-4,
    f"{len(switched)} events are where the trolley passes 0.05 m",
)

# First-order states, and the state as a whole.
m = Gantry(load=2.0)
m.level = 2.5
m["level"] += 0.5
expect(m.level == 3.0 == m["level"], "a first-order state is set")
refused(AttributeError, "'bar.angle' is an output: it can be read, not set", lambda: m.set("bar.angle", 1.0))
refused(ValueError, "level must be a finite number", lambda: m.set("level", math.inf))
names = m.state_names
expect(names == ("guide.displacement", "bar.angle", "guide.speed", "bar.omega", "level"), f"states have names: {names}")
state = m.state
expect(state.shape == (5,) and state[0] == m["trolley.x"] and state[1] == m["bar.angle"], "and numbers")
m.state = [0.0, 0.5, -0.25, 1.0, 0.0]
expect([m["trolley.x"], m["bar.angle"], m.level] == [0.0, 0.5, 0.0], "which are set")
pose = m.pose("bar")
expect(abs(pose.vx - (-0.25 + 0.4 * math.cos(0.5))) < 1e-14 and pose.omega == 1.0, "so that bodies are there")
start = {"trolley.x": 0.0, "trolley.vx": -0.25, "bar.vx": pose.vx, "bar.vy": pose.vy, "bar.omega": 1.0}
other = Gantry(load=2.0, tilt=0.5, start=start)
found, known = m.run(1.0), other.run(1.0)
error = max(np.max(np.abs(found[name] - known[name]) / (1 + np.abs(known[name]))) for name in known)
expect(error < 1e-8, f"a run from there is one from such start values, within {error:.1e}")
refused(ValueError, "the state has 5 numbers, not 4: guide.displacement, ", lambda: setattr(m, "state", [0.0] * 4))
refused(ValueError, "bar.omega must be a finite number, not nan", lambda: setattr(m, "state", [0, 0, 0, math.nan, 0]))

# Rates and derivatives, beside difference quotients of order 4.
m = Gantry(load=2.0)
m.state = [0.02, 0.3, 0.1, -0.4, 0.5]
m.push = 0.7
rates = m.rates()
expect(rates[:2].tolist() == [0.1, -0.4] and abs(rates[4] - (0.7 - 0.5) / 0.1) < 1e-12, "rates follow the names")
jacobian = m.jacobian()
expect(jacobian.states == names and jacobian.inputs == ("push",) and len(jacobian.outputs) == 4, "derivatives have names")


def moved(j, by):
    other = copy.copy(m)
    if j < 5:
        other.state = other.state + by * (np.arange(5) == j)
    else:
        other.push += by
    return np.concatenate([other.rates(), [other[name] for name in jacobian.outputs]])


H = 1e-3
for j in range(6):
    quotient = (8 * (moved(j, H) - moved(j, -H)) - (moved(j, 2 * H) - moved(j, -2 * H))) / (12 * H)
    matrices = (
        (jacobian.rates_by_states, jacobian.outputs_by_states)
        if j < 5
        else (jacobian.rates_by_inputs, jacobian.outputs_by_inputs)
    )
    column = np.concatenate([matrix[:, j % 5] for matrix in matrices])
    error = np.max(np.abs(column - quotient) / (1 + np.abs(column)))
    expect(error < 1e-8, f"derivatives along {(*names, 'push')[j]} are difference quotients within {error:.1e}")
some = m.jacobian(inputs=[], outputs=["trolley.x"])
expect(some.rates_by_inputs.shape == (5, 0) and some.outputs_by_states.tolist() == [[1.0, 0, 0, 0, 0]], "some of them")
linear = m.linearise()
expect(linear.states == linear.coordinates == names, "a linear system has the names of its states")
expect(np.array_equal(linear.A, jacobian.rates_by_states), "and is the same where nothing is constrained")

# Bytes, here and in another process, by every kind of method.
for method in (dict(), dict(method="adams"), dict(method="radauiia5"), dict(method="rk4", longest_step=1e-3)):
    m = Gantry(load=2.0, mass=4.0, **method)
    m.push = 3.0
    m.run(0.3)
    data, pickled, of_snapshot = bytes(m.save()), pickle.dumps(m), pickle.dumps(m.save())
    (folder / "saved").write_bytes(pickled)
    program = (
        "import pickle, sys; m = pickle.loads(open(sys.argv[1], 'rb').read()); "
        "m.run(0.7, 0.01); print(repr([m.time, *m.state.tolist(), m.mass, m.push]))"
    )
    said = subprocess.run([sys.executable, "-c", program, folder / "saved"], capture_output=True, text=True, check=True)
    again, fresh, third = Gantry.from_bytes(data), Gantry(load=1.0), Gantry(load=7.0, method="vern9")
    fresh.restore(data)
    third.restore(pickle.loads(of_snapshot))
    for one in (m, again, fresh, third):
        one.run(0.7, 0.01)
    known = [m.time, *m.state.tolist(), m.mass, m.push]
    for one in (again, fresh, third):
        expect([one.time, *one.state.tolist(), one.mass, one.push] == known, f"bytes go on to the bit, {method}")
    expect(said.stdout.strip() == repr(known), "in another process too")
expect(isinstance(pickle.loads(of_snapshot), Snapshot), "a snapshot is pickled")
refused(ValueError, "not a saved run", lambda: m.restore(data[:-1]))
refused(ValueError, "not a saved run", lambda: Gantry.from_bytes(b"nothing"))
flipped = bytearray(data)
flipped[40] ^= 1
refused(ValueError, "not a saved run", lambda: m.restore(flipped))
expect(m.time == 0.7, "what is refused changes nothing")


def accepted(data):
    try:
        m.restore(data)
    except ValueError:
        return False
    return True


damaged = [data[:k] + bytes([data[k] ^ 1 << k % 8]) + data[k + 1 :] for k in range(len(data))]
shorter = [data[:k] for k in range(len(data))]
expect(accepted(data) and not any(map(accepted, damaged + shorter)), f"each of {len(data)} bytes counts")


class Logged(Gantry):
    """A class of a user's own, with attributes."""

    def __init__(self):
        super().__init__(load=2.0)
        self.log = ["made"]


one = Logged()
one.step(0.1)
two, shared, apart = pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)
one.log.append("more")
expect(two.log == apart.log == ["made"] and shared.log is one.log and two.time == 0.1, "attributes go with it")
expect(type(two) is type(apart) is Logged and two.state.tolist() == one.state.tolist(), "and its class")
refused(TypeError, "was saved by a Logged, not by a Gantry", lambda: m.restore(one.save()))

# Notebooks, and curves where matplotlib is.
m = Gantry(load=2.0)
table, results = m._repr_html_(), m.run(0.5)
expect("<td>bar.angle</td>" in table and "<td>rad</td>" in table and "At the start." in table, "a mechanism is a table")
expect("<td>trolley.x</td>" in results._repr_html_() and "1001 rows, 1 event" in results._repr_html_(), "so are results")
linear = m.linearise(outputs=["trolley.x"])
text = [line.split() for line in str(linear).splitlines()]
expect(text[0] == ["A", *names] and text[2][0] == "(bar.angle)'" and float(text[2][4]) == 1.0, "a linear system is text")
expect(["C", *names] in text and ["trolley.x", "1", "0", "0", "0", "0"] in text, "with names on rows and columns")
expect("<th>bar.omega</th>" in m.linearise()._repr_html_() and "(bar.omega)&#x27;" in m.jacobian()._repr_html_(), "and matrices")
try:
    import matplotlib

    matplotlib.use("svg")
except ImportError:
    print("not checked: curves, without matplotlib")
else:
    drawn = results.plot()
    labels = [[line.get_label() for line in axes.get_legend_handles_labels()[0]] for axes in drawn]
    expect(labels == [["bar.angle"], ["hinge.force.x", "hinge.force.y"], ["trolley.x"]], "a diagram for each unit")
    expect([axes.get_ylabel() for axes in drawn] == ["rad", "N", "m"], "which tells it")
    expect(np.array_equal(drawn[2].lines[0].get_ydata(), results["trolley.x"]), "has the numbers")
    expect(len(drawn[0].lines) == 1 + len(results.events), "and the events")
    own = matplotlib.pyplot.figure().subplots()
    expect(results.plot("trolley.x", axes=own) is own and len(own.lines) == 2, "or axes of one's own")
    refused(KeyError, "did you mean 'trolley.x'", lambda: results.plot("trolley"))
hidden = {name: sys.modules.pop(name) for name in list(sys.modules) if name.split(".")[0] == "matplotlib"}
sys.modules["matplotlib"] = None
refused(ImportError, "plot needs matplotlib, which cannot be imported: pip install matplotlib", lambda: results.plot())
del sys.modules["matplotlib"]
sys.modules.update(hidden)
