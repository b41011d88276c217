"""Box2D on the scenes with contact, for docs/src/running/contact-peers.md.

    target/tools/contact/bin/pip install box2d==2.3.10
    target/tools/contact/bin/python benches/peers/contact/by_box2d.py > target/plm/contact-box2d.csv

Single precision. Two sets of settings. `usual`: 8 iterations for velocities and 3 for places, as its manual has them. `tight`: 50 of
each. No body sleeps. The dry friction of oscillator and slider-crank is a motor of the guide, with no speed and a largest force. The calls
from Python are part of its time.
"""

import math

from Box2D import b2

from shared import GRAVITY, STEPS, creep, peaks, row, worst_gain

ITERATIONS = {"usual": (8, 3), "tight": (50, 50)}


class World:
    def __init__(self, step, settings, gravity):
        self.step_size, self.iterations, self.steps = step, ITERATIONS[settings], 0
        self.world = b2.world(gravity=(0, -gravity), doSleep=False)
        self.ground = self.world.CreateStaticBody()

    def body(self, mass, inertia, place, angle=0.0):
        body = self.world.CreateDynamicBody(position=place, angle=angle, allowSleep=False)
        return body, (mass, inertia)

    def weigh(self, made):
        body, (mass, inertia) = made
        body.massData = b2.massData(mass=mass, center=(0, 0), I=inertia)
        return body

    def floor(self, friction, restitution=0.0):
        shape = b2.polygonShape(box=(500, 1, (0, -1), 0))
        self.ground.CreateFixture(shape=shape, friction=friction, restitution=restitution)

    def guide(self, body, friction):
        self.world.CreatePrismaticJoint(bodyA=self.ground, bodyB=body, anchor=body.position, axis=(1, 0),
                                        enableMotor=True, motorSpeed=0.0, maxMotorForce=friction)

    def step(self):
        self.world.Step(self.step_size, *self.iterations)
        self.steps += 1

    def step_to(self, until):
        for _ in range(round(until / self.step_size) - self.steps):
            self.step()


def block(step, settings, half, friction, tilt=0.0):
    (b, h), s, c = half, math.sin(tilt), math.cos(tilt)
    world = World(step, settings, GRAVITY)
    world.floor(friction)
    made = world.body(1.0, (b * b + h * h) / 3.0, (-b * c + h * s, b * s + h * c), -tilt)
    made[0].CreateFixture(shape=b2.polygonShape(box=half), friction=friction, density=1.0)
    return world, world.weigh(made)


def pushed(step, settings, time):
    def run(until):
        world, body = block(step, settings, (0.1, 0.1), 0.3)
        force = (0.99 * 0.3 * GRAVITY, 0.0)
        half = 0.0
        for k in range(round(until / step)):
            body.ApplyForceToCenter(force, True)
            world.step()
            if k == round(0.5 * until / step):
                half = body.position.x
        return half, body.position.x

    half, end = run(time)
    row("block", "Box2D", settings, step, abs(end + 0.1), lambda: run(time), time, creep=creep(half, end, 0.5 * time))


def oscillator(step, settings):
    def start():
        world = World(step, settings, 0.0)
        made = world.body(1.0, 1.0, (0.1, 0.0))
        body = world.weigh(made)
        world.guide(body, 0.981)
        # The joint's reference is the place at the start.
        return world, body

    def run(world, body, until):
        while world.steps < round(until / step):
            body.ApplyForceToCenter((-100.0 * body.position.x, 0.0), True)
            world.step()
        return body.position.x

    world, body = start()
    rest = run(world, body, 2.0)
    later = run(world, body, 12.0)
    row("oscillator", "Box2D", settings, step, abs(rest + 0.0019), lambda: run(*start(), 2.0), 2.0, creep=creep(rest, later, 10.0))


def ball(step, settings):
    def start():
        world = World(step, settings, GRAVITY)
        world.floor(0.0, 0.8)
        made = world.body(1.0, 0.004, (0.0, 1.1))
        made[0].CreateFixture(shape=b2.circleShape(radius=0.1), friction=0.0, restitution=0.8, density=1.0)
        return world, world.weigh(made)

    world, body = start()
    heights = [1.0]
    for _ in range(round(3.0 / step)):
        world.step()
        heights.append(body.position.y - 0.1)
    gain = worst_gain([1.0] + peaks(heights)[:5], 0.64)
    row("ball", "Box2D", settings, step, abs(heights[-1] - 0.068707460965765722), lambda: start()[0].step_to(3.0), 3.0, gain=gain)


def rocking(step, settings):
    alpha = math.atan(0.2)
    start = lambda: block(step, settings, (0.1, 0.5), 1.0, 0.5 * alpha)
    world, body = start()
    angles = [0.5 * alpha]
    for _ in range(round(2.2 / step)):
        world.step()
        angles.append(abs(body.angle))
    rise = lambda angle: math.cos(alpha - angle) - math.cos(alpha)
    gain = worst_gain([rise(angle) for angle in [0.5 * alpha] + peaks(angles)[:3]], 0.88794378698224852)
    error = abs(angles[round(1.2 / step)] - 0.070910634436800123)
    row("rocking", "Box2D", settings, step, error, lambda: start()[0].step_to(1.2), 1.2, gain=gain)


def crank(step, settings):
    phi, omega = 1.0, 20.0
    rod = -math.asin(math.sin(phi) / 3.0)
    turn = -math.cos(phi) / (3.0 * math.cos(rod)) * omega
    pin = (0.1 * math.cos(phi), 0.1 * math.sin(phi))
    pin_rate = (-0.1 * omega * math.sin(phi), 0.1 * omega * math.cos(phi))
    wrist = (pin[0] + 0.3 * math.cos(rod), 0.0)

    def start():
        world = World(step, settings, 0.0)
        crank = world.weigh(world.body(1.0, 0.02, (0.0, 0.0), phi))
        coupler = world.weigh(world.body(0.5, 0.5 * 0.09 / 12.0, (pin[0] + 0.15 * math.cos(rod), 0.5 * pin[1]), rod))
        slider = world.weigh(world.body(2.0, 0.01, wrist))
        for a, b, at in ((world.ground, crank, (0.0, 0.0)), (crank, coupler, pin), (coupler, slider, wrist)):
            world.world.CreateRevoluteJoint(bodyA=a, bodyB=b, anchor=at)
        world.guide(slider, 3.0)
        crank.angularVelocity, coupler.angularVelocity = omega, turn
        coupler.linearVelocity = (pin_rate[0] - 0.15 * turn * math.sin(rod), 0.5 * pin_rate[1])
        slider.linearVelocity = (pin_rate[0] - 0.3 * turn * math.sin(rod), 0.0)
        return world, crank

    world, body = start()
    world.step_to(1.0)
    row("slider-crank", "Box2D", settings, step, abs(body.angle - 21.211124593021117), lambda: start()[0].step_to(1.0), 1.0)


for settings in ITERATIONS:
    for step in STEPS:
        pushed(step, settings, 60.0)
        oscillator(step, settings)
        ball(step, settings)
        rocking(step, settings)
        crank(step, settings)
    pushed(1e-2, settings, 3600.0)
