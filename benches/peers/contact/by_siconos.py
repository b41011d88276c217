"""Siconos on the scenes with contact, for docs/src/running/contact-peers.md.

    apt-get install python3-siconos      # Debian 12: 4.4.0
    /usr/bin/python3 benches/peers/contact/by_siconos.py > target/plm/contact-siconos.csv

Moreau-Jean's time stepping with theta 0.5, contact at velocity level, the friction problem to 1e-12 (nonsmooth Gauss-Seidel). Block (as a
point), oscillator and ball have constant matrices and run in its C++; a loop in Python calls each step, and is part of its time. Rocking
block and slider-crank have matrices that change: in Python they would be callbacks, whose time says nothing; they are left out.
"""

import numpy as np
import siconos.kernel as sk
import siconos.numerics as sn

from shared import GRAVITY, STEPS, creep, peaks, row, worst_gain


class Point:
    """1 kg at x, y over a floor at y = 0: spring along x, force, friction, restitution."""

    def __init__(self, step, start, spring=0.0, force=0.0, friction=None, restitution=0.0):
        stiffness = np.diag([spring, 0.0])
        self.body = sk.LagrangianLinearTIDS(start, [0.0, 0.0], np.eye(2), stiffness, np.zeros((2, 2)))
        self.body.setFExtPtr(np.array([force, -GRAVITY]))
        if friction is None:
            law, relation = sk.NewtonImpactNSL(restitution), sk.LagrangianLinearTIR([[0.0, 1.0]])
            problem = sk.LCP()
        else:
            law = sk.NewtonImpactFrictionNSL(restitution, 0.0, friction, 2)
            relation = sk.LagrangianLinearTIR([[0.0, 1.0], [1.0, 0.0]])
            problem = sk.FrictionContact(2)
            problem.numericsSolverOptions().dparam[sn.SICONOS_DPARAM_TOL] = 1e-12
        self.contact = sk.Interaction(law, relation)
        self.model = sk.NonSmoothDynamicalSystem(0.0, 1e9)
        self.model.insertDynamicalSystem(self.body)
        self.model.link(self.contact, self.body)
        self.clock = sk.TimeDiscretisation(0.0, step)
        self.simulation = sk.TimeStepping(self.model, self.clock, sk.MoreauJeanOSI(0.5), problem)
        self.step, self.steps = step, 0

    def step_to(self, until, heights=None):
        compute, advance, q = self.simulation.computeOneStep, self.simulation.nextStep, self.body.q
        for _ in range(round(until / self.step) - self.steps):
            compute()
            advance()
            if heights is not None:
                heights.append(q()[1])
        self.steps = round(until / self.step)
        return self.body.q()


def block(step, time):
    start = lambda: Point(step, [0.0, 0.0], force=0.99 * 0.3 * GRAVITY, friction=0.3)
    point = start()
    half = point.step_to(0.5 * time)[0]
    end = point.step_to(time)[0]
    row("block", "Siconos", "Moreau-Jean", step, abs(end), lambda: start().step_to(time), time, creep=creep(half, end, 0.5 * time))


def oscillator(step):
    start = lambda: Point(step, [0.1, 0.0], spring=100.0, friction=0.1)
    point = start()
    rest = point.step_to(2.0)[0]
    later = point.step_to(12.0)[0]
    row("oscillator", "Siconos", "Moreau-Jean", step, abs(rest + 0.0019), lambda: start().step_to(2.0), 2.0, creep=creep(rest, later, 10.0))


def ball(step):
    start = lambda: Point(step, [0.0, 1.0], restitution=0.8)
    heights = [1.0]
    end = start().step_to(3.0, heights)[1]
    gain = worst_gain([1.0] + peaks(heights)[:5], 0.64)
    row("ball", "Siconos", "Moreau-Jean", step, abs(end - 0.068707460965765722), lambda: start().step_to(3.0), 3.0, gain=gain)


for step in STEPS:
    # A step takes much longer than in the other programs.
    block(step, 60.0 if step >= 1e-3 else 6.0)
    oscillator(step)
    ball(step)
