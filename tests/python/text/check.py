"""Looks at the package plm, which compiles declarations without Rust: check.py FOLDER, where the repository is."""

import copy
import inspect
import math
import os
import pickle
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
from html.parser import HTMLParser
from pathlib import Path

import numpy as np

import plm

root = Path(sys.argv[1])


def expect(holds, what):
    print(("holds: " if holds else "DOES NOT HOLD: ") + what)
    if not holds:
        sys.exit(1)


def refused(kind, said, call):
    """A call is refused with these words."""
    try:
        call()
    except kind as error:
        expect(said in str(error), f"{kind.__name__}: {str(error)[:400]}")
        return error
    expect(False, f"nothing was wrong where {kind.__name__} was expected: {said}")


expect(not any(map(shutil.which, ("rustc", "cargo"))), "no Rust is on the path")

# A pendulum, beside the period of large swings: 2 pi sqrt(k) / agm(1, cos(a/2)), k = (m l^2 + I)/(m g l).
PENDULUM = """
/// A bob on a bar without mass.
pub Pendulum {
    gravity: 9.81 m/s^2;
    /// Of the bar.
    param length: m = 1 m;
    param mass: kg;
    /// Of a motor.
    input drive: N*m = 0;
    ground { port o: (0, 0) m; }
    body bob { mass: mass; inertia: 0.01 kg*m^2; port pivot: (0 m, length); start angle: 30 deg, locked; }
    revolute hinge(ground.o, bob.pivot) { drive: drive; }
    require below: bob.angle < 170 deg;
    output bob.angle in deg, hinge.force;
}
"""
LENGTH, MASS = 0.7, 2.0


def agm(a, b):
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


pendulum = plm.Mechanism(PENDULUM)
period = 2 * math.pi * math.sqrt((MASS * LENGTH**2 + 0.01) / (MASS * 9.81 * LENGTH)) / agm(1, math.cos(math.radians(15)))
given = dict(parameters={"length": "70 cm", "mass": MASS}, tolerance=1e-11)
results = pendulum.run(3 * period, period / 4, poses=True, **given)
expect(list(results) == ["time", "bob.angle", "hinge.force.x", "hinge.force.y"], "a run has the declared outputs")
expect(np.max(np.abs(results["bob.angle"][::4] - math.pi / 6)) < 1e-7, "after each period it is where it began")
expect(np.max(np.abs(results["bob.angle"][1::4])) < 1e-8, "after a quarter it hangs down")
pose = results.poses["bob"]
expect(pose.shape == (13, 6) and np.array_equal(pose[:, 2], results["bob.angle"]), "poses are had")
expect(np.allclose(pose[:, 0], LENGTH * np.sin(pose[:, 2]), atol=1e-12), "x is l sin(a)")
expect(results.units["hinge.force.x"] == "N" and results.stats["steps"] > 10, "with units and counters")

# What it tells of itself.
expect((pendulum.name, pendulum.docs) == ("Pendulum", "A bob on a bar without mass."), "name and documentation")
row = pendulum.parameters["length"]
expect((row.unit, row.docs, row.default) == ("m", "Of the bar.", 1.0), "parameters are told")
expect(pendulum.parameters["mass"].default is None and pendulum.inputs["drive"].unit == "N*m", "and inputs")
expect(pendulum.outputs["bob.angle"].declared_unit == "deg" and pendulum.bodies == ("bob",), "and outputs")
expect(math.isclose(pendulum.starts["bob.angle"].default, math.pi / 6), "and starts")
expect("Of the bar." in pendulum._repr_html_() and "1 body" in repr(pendulum), "a notebook shows it")
expect(pendulum.diagnostics == [], "nothing is wrong")

# A simulation, step by step.
sim = pendulum.start(parameters={"mass": MASS}, start={"bob.angle": "10 deg"}, inputs={"drive": 0.5})
expect(isinstance(sim, plm.Sim) and sim.mechanism is pendulum and sim.drive == 0.5, "it starts with inputs")
expect(math.isclose(sim["bob.angle"], math.radians(10), rel_tol=1e-15), "and starts")
sim.drive = 0.0
sim.state = [0.0, 0.0]
sim.step(0.5)
expect(sim.time == 0.5 and abs(sim["bob.angle"]) < 1e-12, "at rest it stays at rest")
A = sim.linearise().A
omega2 = MASS * 9.81 / (MASS + 0.01)
expect(np.allclose(A, [[0, 1], [-omega2, 0]], atol=1e-9), "its linear system is that of small swings")
sim.drive = 1.0
saved, twin = sim.save(), copy.copy(sim)
sim.step(0.2)
twin.step(0.2)
once = sim["bob.angle"]
sim.restore(saved)
sim.step(0.2)
expect(once == twin["bob.angle"] == sim["bob.angle"], "copies and what is restored have the same bits")
refused(TypeError, "in memory alone", lambda: bytes(saved))
refused(TypeError, "pickle its mechanism", lambda: pickle.dumps(sim))
again = pickle.loads(pickle.dumps(pendulum))
expect(np.array_equal(again.run(1.0, **given)["bob.angle"], pendulum.run(1.0, **given)["bob.angle"]), "a mechanism is pickled")

# Carets.
wrong = PENDULUM.replace("port o: (0, 0) m", "port o: (0, 0) s").replace("param length: m", "param length: mm/m/m/m")
error = refused(plm.DeclarationError, "^^^", lambda: plm.Mechanism(wrong, "swing.plm"))
expect(str(error).count("error[") == len(error.diagnostics) >= 2, "all mistakes are shown")
lines = str(error).splitlines()
place = next(k for k, line in enumerate(lines) if "port o: (0, 0) s" in line)
at = lines[place].index("(0, 0) s")
expect(lines[place + 1][at : at + 8] == "^" * 8 and lines[place + 1][at + 8 :].strip() == "", "a caret under each character")
first = next(of for of in error.diagnostics if "found (0, 0) s" in of["message"])
span = first["spans"][0]
expect(wrong.encode()[span["byte_start"] : span["byte_end"]] == b"(0, 0) s" and span["file_name"] == "swing.plm", "and its place")
expect(plm.check(PENDULUM) == [] and len(plm.check(wrong)) == len(error.diagnostics), "a text can be checked")
for hostile in ("", "}", "pub", "\0", "(" * 10_000):
    refused(plm.DeclarationError, "", lambda: plm.Mechanism(hostile))
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "pendulum.plm"
    path.write_text(PENDULUM)
    expect(plm.Mechanism.from_file(path).name == "Pendulum", "a file is read")
    page = Path(folder) / "page.html"
    shown = pendulum.show(1.0, parameters={"mass": 1})
    shown.write(page)
    expect(page.read_text() == shown.html and shown.html.startswith("<!doctype html>"), "a page is written")
    done = subprocess.run([sys.executable, "-m", "plm", "check", str(path)], capture_output=True)
    expect(done.returncode == 0, "the command is there")

# The page stands in a notebook as it is.
frames = []
reader = HTMLParser(convert_charrefs=True)
reader.handle_starttag = lambda tag, attributes: frames.append((tag, dict(attributes)))
reader.feed(shown._repr_html_())
expect(len(frames) == 1 and frames[0][0] == "iframe" and frames[0][1]["srcdoc"] == shown.html, "show() is a frame with the page")
expect("Pendulum" in shown.html and 'id="results">' in shown.html, "which has the results")

# Faults.
fault = refused(plm.Fault, "below", lambda: pendulum.run(5.0, 0.01, parameters={"mass": 1}, inputs={"drive": 30.0}))
expect(fault.part == "below" and 0 < fault.time < 5 and fault.results["time"][-1] <= fault.time + 1e-9, "a run that fails tells time and part")
expect(abs(fault.results["bob.angle"][-1] - math.radians(170)) < 1e-6 and len(fault.results["time"]) > 10, "and has what it came to")
refused(plm.Fault, "mass", lambda: pendulum.start(parameters={"mass": -1}))
refused(TypeError, "must be given: mass", lambda: pendulum.start())
refused(KeyError, "did you mean 'length'", lambda: pendulum.start(parameters={"lenght": 1}))
refused(KeyError, "did you mean 'drive'", lambda: pendulum.start(inputs={"drve": 1}, parameters={"mass": 1}))
refused(ValueError, "20 kg is a mass", lambda: pendulum.start(parameters={"length": "20 kg"}))
refused(ValueError, "no method 'rk5'", lambda: pendulum.start(parameters={"mass": 1}, method="rk5"))
refused(ValueError, "finite", lambda: pendulum.start(parameters={"mass": math.nan}))

ROD = """pub Rod {
    gravity: 9.81 m/s^2; param th: rad = 63.43494882292201 deg; param w: rad/s = -4 rad/s;
    ground { port o: (0, 0) m; }
    body rod { mass: 1 kg; inertia: 1 kg*m^2/3; port tip: (-1, 0) m; start angle: th, locked; start omega: w, locked;
        start x: 1 m*cos(th), locked; start y: 1 m*sin(th), locked; start vx: -20 m/s - 1 m*sin(th)*w, locked;
        start vy: 1 m*cos(th)*w, locked; }
    point_on_line tip(ground.o, rod.tip) { friction: 1.6; }
    output rod.angle;
}"""
expect("several ways" in "".join(plm.Mechanism(ROD).run(0.02).notices), "contact that could go on in several ways is a notice")

# What there is no memory for is refused before the run; Ctrl+C ends a page; the keywords of a run are those of a start.
for too_long in (pendulum.run, pendulum.show):
    refused(MemoryError, "rows of", lambda: too_long(1e6, 1e-9, parameters={"mass": 1}))
refused(MemoryError, "rows of", lambda: pendulum.rollouts(until=1e6, every=1e-7, parameters={"mass": np.ones(1000)}))
# A shell starts what runs beside it with this signal ignored.
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    pendulum.show(1e6, 100.0, parameters={"mass": 1})
    expect(False, "the page went on")
except KeyboardInterrupt:
    expect(True, "Ctrl+C ends a page")
expect(set(inspect.signature(pendulum.start).parameters) <= set(inspect.signature(pendulum.run).parameters), "run() says what it takes")

# The bits of compiled code: state and outputs of eight mechanisms after ten steps of Rk4.
snapshots = root / "tests" / "snapshots"
for line in (snapshots / "bits.txt").read_text().splitlines():
    name, words = line.split(": ")
    compiled = [struct.unpack(">d", bytes.fromhex(word))[0] for word in words.split()]
    mechanism = plm.Mechanism.from_file(snapshots / f"{name}.plm")
    sim = mechanism.start(method="rk4", longest_step=1e-4)
    sim.step(1e-3)
    outputs = [sim[row.name] / row.factor if row.factor != 1 else sim[row.name] for row in sim._tables.declared]
    found = [*sim.state, *outputs]
    expect(np.array_equal(np.array(found), np.array(compiled)), f"{name} has the bits of compiled code, {len(found)} numbers")

# A four-bar by the builder, beside the law of cosines.
r, l, s, d = 0.3, 0.9, 0.7, 1.0
m = plm.Builder("four_bar", "Four bars.", gravity=9.81)
ratio = m.param("ratio", 1.0, docs="Of the rocker's mass.")
ground = m.ground(a=(0, 0), d=(d, 0))
ends = dict(crank={"a": (-r / 2, 0), "b": (r / 2, 0)}, coupler={"b": (-l / 2, 0), "c": (l / 2, 0)}, rocker={"d": (-s / 2, 0), "c": (s / 2, 0)})
begin = {"angle": "60 deg", "omega": 2}
crank = m.body("crank", mass=0.3, inertia=0.00225, ports=ends["crank"], start=begin, locked=["angle", "omega"])
coupler = m.body("coupler", mass=0.9, inertia=0.06, ports=ends["coupler"], start={"angle": math.radians(30)})
rocker = m.body("rocker", mass=0.7 * ratio * "1 kg", inertia=0.03, ports=ends["rocker"], start={"x": 1, "angle": "95 deg"})
m.revolute("drive", ground.a, crank.a)
m.revolute("b", crank.b, coupler.b)
m.part("revolute", "c", coupler.c, rocker.c)
m.revolute("pivot", ground.d, rocker.d, stiffness=2.5, rest="90 deg")
m.output(crank.angle)
m.output(rocker.angle, unit="deg")
m.output(crank.angle - rocker.angle, name="between")
print(m)
four_bar = m.compile()
results = four_bar.run(4.0, 0.01, tolerance=1e-10)
crank_angle, rocker_angle = results["crank.angle"], results["rocker.angle"]
x, y = d - r * np.cos(crank_angle), -r * np.sin(crank_angle)
reach = np.hypot(x, y)
# From b to d, and from there by the angle of the triangle of sides reach, s, l.
theory = np.arctan2(y, x) + math.pi - np.arccos((reach**2 + s**2 - l**2) / (2 * reach * s))
turns = np.round((rocker_angle - theory) / (2 * math.pi))
expect(np.max(np.abs(rocker_angle - theory - 2 * math.pi * turns)) < 1e-9, "the rocker is where the law of cosines says")
expect(np.ptp(crank_angle) > 1 and np.array_equal(results["between"], crank_angle - rocker_angle), "while the crank moves")
with tempfile.TemporaryDirectory() as folder:
    (Path(folder) / "four_bar.plm").write_text(m.text())
    words = [sys.executable, "-m", "plm", "fmt", "--check", f"{folder}/four_bar.plm"]
    done = subprocess.run(words, capture_output=True, text=True)
    expect(done.returncode == 0, f"what is written has the layout of plm fmt {done.stdout}{done.stderr}")
expect(set(plm.parts()) <= set(dir(m)) and len(plm.parts()) > 60, f"{len(plm.parts())} parts of the library are methods")
expect("lower_limit" in m.revolute.__doc__ and "Rotary spring" in m.revolute.__doc__, "with their documentation")
refused(AttributeError, "did you mean 'revolute'", lambda: m.revolut)
m.revolute("wrong", ground.a, crank.a, frction=0.1)
error = refused(plm.DeclarationError, "frction", m.compile)
expect("FourBar.plm" in str(error) and "^^^^^^^" in str(error), "mistakes are shown in what was written")

# Everything that a part can set: a function, a choice, points. A knife on a cam, and a ball on a polyline.
m = plm.Builder("follower", gravity=9.81)
ground = m.ground(o=(0, 0), up=(0, 0, "90 deg"))
cam = m.body("disc", ports={"o": (0, 0)})
m.revolute("hub", ground.o, cam.o)
m.item("constraint turn: disc.angle = 2 rad/s*t;")
follower = m.body("follower", mass=1.0, inertia=1.0, ports={"o": (0, 0, math.pi / 2)}, start={"y": 0.1})
m.prismatic("guide", ground.up, follower.o)
m.cam("push", cam.o, follower.o, face="knife", lift=("a", "0.02 m*(1 + cos(a))"), base_radius=0.08)
ball = m.body("ball", mass=1.0, inertia=1.0, ports={"o": (0, 0)}, start={"x": 3, "y": 1})
m.point_on_polyline("floor", ground.o, ball.o, vertices=[(2, 0), (4, 0)], thickness=0.1, restitution=0.5)
m.output(follower.y)
m.output(ball.y)
two = m.compile().run(0.8, 0.1)
theory = 0.08 + 0.02 * (1 + np.cos(2 * two["time"] - math.pi / 2))
expect(np.max(np.abs(two["follower.y"] - theory)) < 1e-9, "a function and a choice are handed over")
fall = math.sqrt(2 / 9.81)
t = two["time"] - fall
y = np.where(t < 0, 1 - 9.81 * two["time"] ** 2 / 2, 0.5 * 9.81 * fall * t - 9.81 * t**2 / 2)
expect(np.max(np.abs(two["ball.y"] - y)) < 1e-9, "and points")
a, b = plm.Expression("a"), plm.Expression("b")
said = [str(of) for of in ((a + b) * 2, a - (b - a), a / (b * a), -(a + b), (a * b) ** 2, 2 * a + "3 m", a - "1 m + b")]
expect(said == ["(a + b)*2", "a - (b - a)", "a/(b*a)", "-(a + b)", "(a*b)^2", "2*a + 3 m", "a - (1 m + b)"], f"{said}")

# Gradients, beside the closed form of an oscillator: y = a cos(w t), w = sqrt(c/m).
oscillator = plm.Mechanism(
    """pub Oscillator {
        param stiffness: N/m = 40 N/m;
        param load: kg = 2 kg;
        input push: N = 0;
        ground { port o: (0, 0) m; }
        body block { mass: load; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.3 m, locked; }
        prismatic rail(ground.o, block.o) { stiffness: stiffness; drive: push; }
        output block.x in mm, energy = 0.5*stiffness*block.x^2;
    }"""
)
g = oscillator.gradient(["stiffness", "load", "block.x", "push"], 2.0, 0.1, tolerance=1e-11)
t, w = g.results["time"], math.sqrt(20.0)
x, by_w = 0.3 * np.cos(w * t), -0.3 * t * np.sin(w * t)
for name, closed in (
    ("stiffness", by_w * w / 80.0),
    ("load", -by_w * w / 4.0),
    ("block.x", np.cos(w * t)),
    ("push", (1 - np.cos(w * t)) / 40.0),
):
    expect(np.max(np.abs(g["block.x"][name] - closed)) < 1e-8, f"the derivative by {name} is that of the closed form")
expect(np.max(np.abs(g["energy"]["stiffness"] - 0.5 * x**2 - 40 * x * by_w * w / 80)) < 1e-7, "of whatever is an output")
plain = oscillator.run(2.0, 0.1, tolerance=1e-11)
expect(all(np.array_equal(plain[name], g.results[name]) for name in plain), "beside them stand the bits of a run")
refused(KeyError, "did you mean 'push'", lambda: oscillator.gradient(["pusch"], 1.0))

# What was measured tells parameters and starts: of an oscillation without and with noise, in SI, from a file, of two experiments.
t = np.linspace(0.0, 2.0, 41)
measured = 0.3 * np.cos(math.sqrt(18.0 / 4.0) * t)
start = {"block.x": 0.3}
fit = oscillator.identify({"stiffness": "25 N/m"}, plm.Experiment(t, {"block.x": measured}, start=start), parameters={"load": "4 kg"})
expect(abs(fit["stiffness"] - 18.0) < 1e-7, "readings without noise give the stiffness")
expect(fit.parameters == {"stiffness": fit["stiffness"]} and fit.start == {} and len(fit) == 1, "as values for another run")
expect("18.0 N/m" in fit.text.replace(repr(fit["stiffness"]), "18.0") and "stiffness" in str(fit), "and as a declaration")
expect("<svg" in fit._repr_svg_() and len(fit.show().html) > 50_000, "with a picture and a page")
noise = np.random.default_rng(7).normal(0.0, 1e-3, t.size)
known = dict(parameters={"load": 4.0, "stiffness": 18.0})
both = plm.Experiment(t, {"block.x": measured + noise}, deviations={"block.x": "1 mm"}, find={"block.x": 0.2, "block.vx": plm.Unknown(0.1, size=1.0)})
fit = oscillator.identify([], both, **known)
# The outputs are linear in both starts: the estimates are those of linear least squares.
w = math.sqrt(18.0 / 4.0)
by = np.column_stack([np.cos(w * t), np.sin(w * t) / w])
closed = np.linalg.lstsq(by, measured + noise, rcond=None)[0]
expect(np.allclose([own.value for own in fit.estimates], closed, atol=1e-9), "starts of an experiment are those of linear least squares")
expect(np.allclose(fit.covariance, 1e-6 * np.linalg.inv(by.T @ by), rtol=1e-6), "their covariance is that of the closed form")
expect([own.experiment for own in fit.estimates] == [0, 0] and fit.freedoms == 39, "and belongs to it")
expect(np.allclose(fit.residuals[0].model - fit.residuals[0].readings, by @ closed - measured - noise, atol=1e-9), "residuals too")
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "readings.csv"
    rows = "".join(f"{float(a)!r},{100 * float(b)!r},300\n" for a, b in zip(t, measured))
    path.write_text("time (s),block.x (cm),temperature (K)\n" + rows)
    table = plm.Experiment.from_csv(path, only=["block.x"], start=start, deviations={"block.x": "1 mm"})
    arrays = plm.Experiment(t, {"block.x": measured}, start=start, deviations={"block.x": 1e-3})
    pair = oscillator.identify({"load": plm.Unknown(3.0, least=0.1)}, [table, arrays], parameters={"stiffness": 18.0})
    expect(abs(pair["load"] - 4.0) < 1e-7 and pair.residuals[0].unit == "cm", "a file has its own units")
    spread = abs(pair.residuals[0].readings[0] - 30.0)
    expect(spread < 1e-9 and pair.residuals[1].readings[0] == 0.3, "and an array is in SI")
    named = plm.Experiment.from_csv(path, only="block.z", start=start)
    refused(ValueError, "has no column 'block.z'; there are block.x, temperature", lambda: oscillator.identify(["load"], named, **known))
alone = oscillator.identify({"load": 4.0, "stiffness": 18.0}, plm.Experiment(t, {"block.x": measured}, start=start))
expect(len(alone.undetermined) == 1 and math.isinf(alone.estimate("load").standard_error), "what readings do not tell is said")
refused(KeyError, "did you mean 'stiffness'", lambda: oscillator.identify(["stifness"], both))
refused(KeyError, "did you mean 'block.x'", lambda: oscillator.identify(["load"], plm.Experiment(t, {"block.xx": measured})))
refused(ValueError, "1 reading", lambda: oscillator.identify(["load", "stiffness"], plm.Experiment([1.0], {"block.x": [0.0]})))
refused(ValueError, "and a mass (kg) is wanted", lambda: oscillator.identify({"load": "4 m"}, both))
refused(plm.Fault, "experiment 0 does not run with the guesses", lambda: oscillator.identify({"load": -1.0}, both))
try:
    oscillator.identify({"stiffness": 400.0}, plm.Experiment(t, {"block.x": measured}, start=start), parameters={"load": 4.0}, iterations=1)
    expect(False, "a search that has not ended is an exception")
except plm.NotConverged as error:
    expect("1 iteration" in str(error) and set(error.best) == {"stiffness"}, "a search that has not ended tells where it stands")

long = np.linspace(0.0, 2000.0, 20001)
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    oscillator.identify(["stiffness"], plm.Experiment(long, {"block.x": np.cos(long)}), tolerance=1e-13)
    expect(False, "the search went on")
except KeyboardInterrupt:
    expect(True, "Ctrl+C ends a search")

# Rollouts are single runs, to the bit, whatever the number of threads.
lengths = np.linspace(0.3, 1.8, 17)
drives = np.linspace(-1, 1, 17)
common = dict(until=2.0, every=0.02, tolerance=1e-8, start={"bob.angle": "40 deg"})
varied = dict(parameters={"length": lengths, "mass": 1.0}, inputs={"drive": drives})
rolled = pendulum.rollouts(**varied, poses=True, threads=3, **common)
expect(rolled["bob.angle"].shape == (17, 101) and rolled.poses["bob"].shape == (17, 101, 6) and rolled.faults == {}, "rollouts are arrays")
same = True
for k in range(17):
    alone = dict(parameters={"length": lengths[k], "mass": 1.0}, inputs={"drive": drives[k]})
    one = pendulum.run(**alone, poses=True, **common)
    same &= all(np.array_equal(rolled[name][k], one[name]) for name in one if name != "time")
    same &= np.array_equal(rolled.poses["bob"][k], one.poses["bob"])
expect(same, "each of 17 rows is that run alone, to the bit")
refused(ValueError, "at least 1", lambda: pendulum.rollouts(**varied, threads=-1, **common))
refused(TypeError, "whole number", lambda: pendulum.rollouts(**varied, threads=1.5, **common))
refused(ValueError, "length must have a value", lambda: pendulum.rollouts(parameters={"length": [], "mass": 1.0}, **common))
for threads in (1, 2, None):
    other = pendulum.rollouts(**varied, threads=threads, **common)
    expect(all(np.array_equal(other[name], rolled[name]) for name in other), f"{threads} threads give the same bits")
matrix = np.column_stack([lengths, np.full(17, 1.0)])
by_matrix = pendulum.rollouts(matrix, inputs={"drive": drives}, **common)
expect(np.array_equal(by_matrix["bob.angle"], rolled["bob.angle"]), "parameters can be a matrix")
broken = pendulum.rollouts({"mass": [1.0, -1.0, 1.0]}, inputs={"drive": [0.0, 0.0, 30.0]}, until=5.0, every=0.01)
expect(sorted(broken.faults) == [1, 2] and broken.faults[2].part == "below", "runs that fail are told")
is_there = np.isfinite(broken["bob.angle"])
expect(is_there[0].all() and not is_there[1].any() and 10 < is_there[2].sum() < 500, "and end in what is no number")
expect(np.all(broken["time"][is_there[2]] <= broken.faults[2].time), "from their ends on")
refused(ValueError, "several lengths", lambda: pendulum.rollouts({"mass": [1.0, 2.0], "length": [1.0, 2.0, 3.0]}))

# Other threads of Python run meanwhile.
busy = pendulum.start(parameters={"mass": 1})
stopped, counted = threading.Event(), 0


def until_stopped(time):
    if stopped.is_set():
        raise StopIteration


def run():
    refused(StopIteration, "", lambda: busy.run(1e6, 1.0, progress=until_stopped))


thread = threading.Thread(target=run)
thread.start()
end = time.perf_counter() + 0.3
while time.perf_counter() < end:
    counted += 1
refused(RuntimeError, "runs, in another thread", lambda: busy.time)
stopped.set()
thread.join()
# With the lock held all along there would be a turn every 50 ms, at which the run asks.
expect(counted > 1000 and busy.time > 1.0, f"a run of {busy.time:.0f} s went on while this thread counted to {counted}")

# C source, and an FMU with it: what the command line writes, with values in place of those declared.
with tempfile.TemporaryDirectory() as folder:
    written = pendulum.c_source(Path(folder) / "c", single=True, parameters={"mass": 1.0, "length": "50 cm"})
    names = sorted(path.name for path in written)
    expect(names == ["pendulum.c", "pendulum.h", "plm_math.h"], f"C source is three files: {names}")
    expect("float" in written[0].read_text() and all(path.is_file() for path in written), "of the numbers that are asked for")
    for version, listed in (2, False), (3, True):
        file = pendulum.fmu_source(Path(folder) / "p.fmu", version=version, parameters={"mass": 1.0})
        entries = zipfile.ZipFile(file).namelist()
        has = "modelDescription.xml" in entries and "sources/pendulum_fmi.c" in entries
        expect(has and ("sources/buildDescription.xml" in entries) == listed, f"an FMU of version {version} has its files: {entries}")
    refused(ValueError, "version is 2 or 3", lambda: pendulum.fmu_source("none.fmu", version=1, parameters={"mass": 1.0}))
    refused(ValueError, "interface is", lambda: pendulum.fmu_source("none.fmu", interface="both", parameters={"mass": 1.0}))
    refused(KeyError, "", lambda: pendulum.c_source("none", parameters={"weight": 1.0}))

# Contact and events, beside the flights of a ball that bounces.
ball = plm.Mechanism(
    """pub Ball {
        gravity: 9.81 m/s^2;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        unilateral floor: ball.y >= 0 m { restitution: 0.5; }
        output ball.y;
    }"""
)
fall = math.sqrt(2 / 9.81)
results = ball.run(2.25 * fall, fall / 4, tolerance=1e-10)
expect(ball.contacts == ("floor",) and results.events and abs(results.events[0].time - fall) < 1e-9, "events have their times")
expect(abs(results["ball.y"][-1] - 0.0625) < 1e-8, "the second flight is a sixteenth as high")
sim = ball.start()
sim.step(3 * fall + 0.1)
expect(sim.contacts == {"floor": "closed"}, "and bouncing ends")

# Loops: state, names and linear system of a four-bar.
sim = four_bar.start()
sim.step(1.0)
names, before = sim.state_names, sim.state
expect(len(names) == 2 == before.size and names[1] == names[0].replace("angle", "omega"), f"a loop has one freedom: {names}")
poses = [sim.pose(body) for body in four_bar.bodies]
sim.state = before
after = [sim.pose(body) for body in four_bar.bodies]
expect(np.max(np.abs(np.array(poses) - np.array(after))) < 1e-9, "a state is set")
expect(abs(sim.rates()[0] - before[1]) < 1e-9 and sim.linearise().A.shape == (2, 2), "and has its rates")
# No link of this one goes round, so that each coordinate comes to where it is none: Rocker of tests/python_run.rs.
rocker = plm.Mechanism(
    """pub Rocker {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.4, 0) m; port a: (0.4, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s; }
        body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.3, 0) m; port b: (0.3, 0) m; start angle: -10 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.35, 0) m; port b: (0.35, 0) m; start angle: 95 deg; }
        revolute a0(ground.o, crank.o);
        revolute a(crank.a, coupler.a);
        revolute b(coupler.b, rocker.b);
        revolute b0(ground.p, rocker.p) { damping: 0.1 N*m*s/rad; }
    }"""
)
sim, seen = rocker.start(), set()
for _ in range(200):
    sim.step(0.01)
    (name, rate), x = sim.state_names, sim.state
    of = sim.pose(name.rpartition(".")[0])
    off = (x[0] - of.angle) / (2 * math.pi)
    if abs(off - round(off)) > 1e-9 or abs(x[1] - of.omega) > 1e-9 or rate != f"{name.rpartition('.')[0]}.omega":
        expect(False, f"{name} is what its name says")
    seen.add(name)
expect(len(seen) > 1, f"coordinates have the names of their chart: {sorted(seen)}")

# The programs of the page of the book.
blocks = (root / "docs/src/running/python-text.md").read_text().split("```python\n")[1:]
names = {}
for block in blocks:
    exec(block.partition("```")[0], names)
expect(len(blocks) == 7 and names["four_bar"].bodies == ("crank", "rod", "rocker"), "the programs of the book run")

print("everything holds")
