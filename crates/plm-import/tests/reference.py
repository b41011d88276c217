"""Coordinates of the joints of tests/models after a time, by MuJoCo.

    python3 -m pip install mujoco==4.0.0 numpy
    python3 crates/plm-import/tests/reference.py

prints the numbers of crates/plm-cli/tests/cli/import.rs. Trees are run by MuJoCo's own RK4 at 10 us. MuJoCo's equality constraints
give way, so that loops and coupled joints are run by RK4 at 1 ms of the accelerations of

    M a + J^T lambda = tau,   J a = -dJ/dt v

with M, tau, J and dJ/dt of MuJoCo. With files as arguments,

    python3 crates/plm-import/tests/reference.py --peers target/debug/plm cartpole.xml …

compares `plm import` and `plm run` with MuJoCo for each of them, and

    python3 crates/plm-import/tests/reference.py --exports target/debug/plm

prints what MuJoCo makes of `plm export --mjcf` of machine.plm and servo.plm in tests/models, and the difference of `plm run`; both are
in crates/plm-cli/tests/cli/export_models.rs.
"""

import csv
import io
import os
import re
import subprocess
import sys
import tempfile

import mujoco
import numpy as np

MODELS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "models")
STEP = 1e-5


def model(path):
    """A model without limits, contacts and dry friction, as `--without` imports it."""
    model = mujoco.MjModel.from_xml_path(path)
    flags = mujoco.mjtDisableBit
    model.opt.disableflags |= flags.mjDSBL_LIMIT | flags.mjDSBL_CONTACT | flags.mjDSBL_FRICTIONLOSS
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.timestep = STEP
    return model


def closed_acceleration(model, data):
    """Acceleration with rigid `connect` and `joint` constraints, of the state in data."""
    mujoco.mj_forward(model, data)
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    force = data.qfrc_passive + data.qfrc_actuator - data.qfrc_bias
    rows, right = [], []
    for k in range(model.neq):
        if model.eq_type[k] == mujoco.mjtEq.mjEQ_JOINT:
            own, other = model.eq_obj1id[k], model.eq_obj2id[k]
            polynomial = np.polynomial.Polynomial(model.eq_data[k, :5])
            x, v = data.qpos[model.jnt_qposadr[other]], data.qvel[model.jnt_dofadr[other]]
            row = np.zeros((1, model.nv))
            row[0, model.jnt_dofadr[own]] = 1
            # A joint without another one is held.
            if other >= 0:
                row[0, model.jnt_dofadr[other]] = -polynomial.deriv()(x)
            rows.append(row)
            right.append([polynomial.deriv(2)(x) * v**2])
            continue
        bodies = [model.eq_obj1id[k], model.eq_obj2id[k]]
        anchors = [model.eq_data[k, 0:3], model.eq_data[k, 3:6]]
        row, rate = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        for sign, body, anchor in zip([1, -1], bodies, anchors):
            point = data.xpos[body] + data.xmat[body].reshape(3, 3) @ anchor
            jacobian, derivative = np.zeros((3, model.nv)), np.zeros((3, model.nv))
            mujoco.mj_jac(model, data, jacobian, None, point, body)
            mujoco.mj_jacDot(model, data, derivative, None, point, body)
            row += sign * jacobian
            rate += sign * derivative
        rows.append(row)
        right.append(-rate @ data.qvel)
    rows, right = np.vstack(rows), np.concatenate(right)
    # Across the plane the rows are zero: least squares.
    system = np.block([[mass, rows.T], [rows, np.zeros((len(rows), len(rows)))]])
    return np.linalg.lstsq(system, np.concatenate([force, right]), rcond=1e-12)[0][: model.nv]


def closed_run(model, data, until, h):
    def rate(q, v):
        data.qpos[:], data.qvel[:] = q, v
        return v, closed_acceleration(model, data)

    q, v = data.qpos.copy(), data.qvel.copy()
    for _ in range(round(until / h)):
        a = rate(q, v)
        b = rate(q + h / 2 * a[0], v + h / 2 * a[1])
        c = rate(q + h / 2 * b[0], v + h / 2 * b[1])
        d = rate(q + h * c[0], v + h * c[1])
        q = q + h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
        v = v + h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
    data.qpos[:], data.qvel[:] = q, v


def final(path, until, controls, h=100 * STEP):
    """Names and coordinates of the joints at the end; of closed loops by steps of h."""
    run = model(path)
    data = mujoco.MjData(run)
    data.ctrl[:] = controls
    if run.neq:
        closed_run(run, data, until, h)
    else:
        for _ in range(round(until / STEP)):
            mujoco.mj_step(run, data)
    free = int(mujoco.mjtJoint.mjJNT_FREE)
    numbers = [k for k in range(run.njnt) if run.jnt_type[k] != free]
    return {run.joint(k).name: float(data.qpos[run.jnt_qposadr[k]]) for k in numbers}


def peers(plm, paths):
    for path in paths:
        made = subprocess.run([plm, "import", path, "--without", "limits", "--without", "friction"], capture_output=True, text=True)
        if made.returncode:
            print(path, made.stderr, sep="\n")
            continue
        inputs = re.findall(r"^    input (\w+):", made.stdout, re.MULTILINE)
        with tempfile.NamedTemporaryFile("w", suffix=".plm") as file:
            file.write(made.stdout)
            file.flush()
            words = [plm, "run", file.name, "--until", "0.3", "--every", "0.3", "--csv", "-", "--method", "Dop853:1e-12"]
            words += [word for name in inputs for word in ("--input", f"{name}=0.3")]
            rows = list(csv.reader(io.StringIO(subprocess.run(words, capture_output=True, text=True, check=True).stdout)))
        found = {head.split(".")[0]: float(number) for head, number in zip(rows[0], rows[-1]) if "." in head}
        expected = final(path, 0.3, 0.3)
        of = {name: found.get(name, found.get(f"{name}_joint")) for name in expected}
        known = {name: abs(of[name] - number) for name, number in expected.items() if of[name] is not None}
        print(f"{path}: {len(known)} joints, {max(known.values()):.1e}")


def exports(plm, name, controls):
    path = os.path.join(MODELS, f"{name}.plm")
    with tempfile.TemporaryDirectory() as folder:
        made = os.path.join(folder, f"{name}.xml")
        subprocess.run([plm, "export", path, "--mjcf", made], check=True, capture_output=True)
        expected = final(made, 0.4, list(controls.values()), 10 * STEP)
    words = [plm, "run", path, "--until", "0.4", "--every", "0.4", "--csv", "-", "--method", "Dop853:1e-12"]
    words += [word for name, value in controls.items() for word in ("--input", f"{name}={value}")]
    rows = list(csv.reader(io.StringIO(subprocess.run(words, capture_output=True, text=True, check=True).stdout)))
    found = {head.split(" ")[0]: float(number) for head, number in zip(rows[0], rows[-1])}
    for joint, number in expected.items():
        ours = found.get(f"{joint}.angle", found.get(f"{joint}.displacement"))
        print(f"{name} {joint} {number:.15f}", "" if ours is None else f"{abs(ours - number):.1e}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--peers"]:
        peers(sys.argv[2], sys.argv[3:])
    elif sys.argv[1:2] == ["--exports"]:
        exports(sys.argv[2], "machine", {"torque": 0.3, "pull": 0.5})
        exports(sys.argv[2], "servo", {"aim": 0.9, "push": 0.5})
    else:
        for name, controls in [("cart.xml", [0.6, 0.2]), ("oblique.xml", []), ("four_bar.xml", [0.5]), ("follow.xml", []), ("puck.xml", [0.7, 3.0]), ("arm.urdf", [])]:
            for joint, number in final(os.path.join(MODELS, name), 0.4, controls).items():
                print(f"{name} {joint} {number:.15f}")
