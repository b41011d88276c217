"""MuJoCo on the scenes with contact, for docs/src/running/contact-peers.md.

    python3 -m venv target/tools/contact && target/tools/contact/bin/pip install mujoco==4.0.0
    target/tools/contact/bin/python benches/peers/contact/by_mujoco.py > target/plm/contact-mujoco.csv

Three sets of settings. `defaults`: its defaults but for the step and the material. `stiff`: elliptic cones, impratio 100, 50 iterations
without slip, solref of two steps (the stiffest that it allows), solimp 0.999, Newton's solver to 1e-12. `RK4`: the same by its Runge-Kutta
method of order 4. It has no coefficient of restitution: the ball bounces on a spring and damper, whose damping is fitted to 0.8 in all sets.
"""

import math

import mujoco

from shared import GRAVITY, STEPS, creep, peaks, row, worst_gain

STIFF = 'cone="elliptic" impratio="100" noslip_iterations="50" tolerance="1e-12" iterations="200"'
SETTINGS = {"defaults": "", "stiff": STIFF, "RK4": f'{STIFF} integrator="RK4"'}


def model(step, settings, world, equality=""):
    solref = "0.02 1" if settings == "defaults" else f"{2 * step} 1"
    solimp = "0.9 0.95 0.001" if settings == "defaults" else "0.999 0.999 0.001"
    world = world.replace("STIFF", f'solreffriction="{solref}" solimpfriction="{solimp}"')
    return mujoco.MjModel.from_xml_string(f"""
      <mujoco><option timestep="{step}" gravity="0 0 {-GRAVITY}" {SETTINGS[settings]}/>
        <default><geom solref="{solref}" solimp="{solimp}"/><equality solref="{solref}" solimp="{solimp}"/></default>
        <worldbody>{world}</worldbody>{equality}</mujoco>""")


PLANAR = """<joint name="x" type="slide" axis="1 0 0"/><joint name="z" type="slide" axis="0 0 1"/>
            <joint name="turn" type="hinge" axis="0 -1 0"/>"""


def floor(friction, more=""):
    return f'<geom type="plane" size="50 50 1" friction="{friction} 0 0" {more}/>'


def steps_to(model, data, time):
    mujoco.mj_step(model, data, nstep=round(time / model.opt.timestep) - round(data.time / model.opt.timestep))


def block(step, settings, time):
    world = floor(0.3) + f"""<body pos="0 0 0.1">{PLANAR}
        <geom type="box" size="0.1 0.1 0.1" mass="1" friction="0.3 0 0"/></body>"""
    m = model(step, settings, world)

    def start():
        data = mujoco.MjData(m)
        data.qfrc_applied[0] = 0.99 * 0.3 * GRAVITY
        return data

    data = start()
    steps_to(m, data, 0.5 * time)
    half = data.qpos[0]
    steps_to(m, data, time)
    drift = creep(half, data.qpos[0], 0.5 * time)
    run = lambda: steps_to(m, start(), time)
    row("block", "MuJoCo", settings, step, abs(data.qpos[0]), run, time, creep=drift)


def oscillator(step, settings):
    m = model(step, settings, """<body><joint type="slide" axis="1 0 0" stiffness="100" frictionloss="0.981" STIFF/>
        <geom type="sphere" size="0.1" mass="1" contype="0"/></body>""")

    def start():
        data = mujoco.MjData(m)
        data.qpos[0] = 0.1
        return data

    data = start()
    steps_to(m, data, 2.0)
    rest = data.qpos[0]
    steps_to(m, data, 12.0)
    run = lambda: steps_to(m, start(), 2.0)
    row("oscillator", "MuJoCo", settings, step, abs(rest + 0.0019), run, 2.0, creep=creep(rest, data.qpos[0], 10.0))


def rebound(zeta):
    """Speed after over speed before, of a contact that only pushes: a'' = -2 zeta a' - a until it pulls."""
    root = math.sqrt(1 - zeta * zeta)
    end = math.atan2(2 * zeta * root, 2 * zeta * zeta - 1) / root
    return abs(math.exp(-zeta * end) * (math.cos(root * end) - zeta / root * math.sin(root * end)))


def damping(restitution):
    low, high = 1e-6, 0.5
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if rebound(middle) > restitution else (low, middle)
    return low


def ball(step, settings):
    # Twenty to forty steps of contact: fewer miss the rebound, more take time from the flight.
    frequency = math.pi / ((40 if step < 2e-3 else 20) * step)
    stiffness, damper = frequency**2, 2 * damping(0.8) * frequency
    solref = f'solref="{-stiffness} {-damper}" solimp="0.9999 0.9999 0.001"'
    m = model(step, settings, f"""<geom type="plane" size="9 9 1" condim="1" {solref}/><body pos="0 0 0.1">
        <joint type="slide" axis="0 0 1"/><geom type="sphere" size="0.1" mass="1" condim="1" {solref}/></body>""")

    def start():
        data = mujoco.MjData(m)
        data.qpos[0] = 1.0
        return data

    data, heights = start(), [1.0]
    while data.time < 3.0 - 0.5 * step:
        mujoco.mj_step(m, data)
        heights.append(data.qpos[0])
    gain = worst_gain([1.0] + peaks(heights)[:5], 0.64)
    run = lambda: steps_to(m, start(), 3.0)
    row("ball", "MuJoCo", settings, step, abs(data.qpos[0] - 0.068707460965765722), run, 3.0, gain=gain)


def rocking(step, settings):
    world = floor(1.0) + f"""<body pos="0 0 0.5">{PLANAR}
        <geom type="box" size="0.1 0.1 0.5" mass="1" friction="1 0 0"/></body>"""
    m = model(step, settings, world)
    tilt = 0.5 * math.atan(0.2)

    def start():
        data = mujoco.MjData(m)
        s, c = math.sin(tilt), math.cos(tilt)
        data.qpos[:] = [-0.1 * c + 0.5 * s, 0.1 * s + 0.5 * c - 0.5, -tilt]
        return data

    data, angles = start(), [tilt]
    while data.time < 2.2:
        mujoco.mj_step(m, data)
        angles.append(abs(data.qpos[2]))
        if abs(data.time - 1.2) < 0.5 * step:
            at = angles[-1]
    rise = lambda angle: math.cos(math.atan(0.2) - angle) - math.cos(math.atan(0.2))
    gain = worst_gain([rise(tilt)] + [rise(angle) for angle in peaks(angles)[:3]], 0.88794378698224852)
    run = lambda: steps_to(m, start(), 1.2)
    row("rocking", "MuJoCo", settings, step, abs(at - 0.070910634436800123), run, 1.2, gain=gain)


def crank(step, settings):
    # The rod hangs on the crank pin and is held at the wrist; the slider has its own guide. Gravity is across the plane.
    m = model(step, settings, """
      <body name="crank"><joint name="crank" type="hinge" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="1" diaginertia="0.02 0.02 0.02"/>
        <body name="rod" pos="0.1 0 0"><joint name="rod" type="hinge" axis="0 0 1"/>
          <inertial pos="0.15 0 0" mass="0.5" diaginertia="0.00375 0.00375 0.00375"/></body></body>
      <body name="slider"><joint name="slider" type="slide" axis="1 0 0" frictionloss="3" STIFF/>
        <inertial pos="0 0 0" mass="2" diaginertia="0.01 0.01 0.01"/></body>""",
      '<equality><connect body1="slider" body2="rod" anchor="0 0 0"/></equality>')
    phi, omega = 1.0, 20.0
    sin = math.sin(phi) / 3.0
    rod = -math.asin(sin)
    turn = -math.cos(phi) / (3.0 * math.cos(rod))
    # The anchor in both bodies is that of the reference pose, with the slider at 0: the wrist in the rod.
    m.eq_data[0, 3:6] = [0.3, 0.0, 0.0]

    def start():
        data = mujoco.MjData(m)
        x = 0.1 * math.cos(phi) + 0.3 * math.cos(rod)
        speed = omega * (-0.1 * math.sin(phi) - 0.3 * math.sin(rod) * turn)
        data.qpos[:], data.qvel[:] = [phi, rod - phi, x], [omega, omega * (turn - 1.0), speed]
        return data

    data = start()
    steps_to(m, data, 1.0)
    run = lambda: steps_to(m, start(), 1.0)
    row("slider-crank", "MuJoCo", settings, step, abs(data.qpos[0] - 21.211124593021117), run, 1.0)


for settings in SETTINGS:
    for step in STEPS:
        block(step, settings, 60.0)
        oscillator(step, settings)
        ball(step, settings)
        rocking(step, settings)
        crank(step, settings)
    block(2e-3, settings, 3600.0)
