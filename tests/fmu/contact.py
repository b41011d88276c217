"""A box that is thrown on a rough floor, bounces, slides and sticks, by FMPy's solvers in model exchange: contact.py FMU. CVode finds events
by its dense output, Euler's steps look at indicators at their ends. Beside the closed form: few events, and the place where it stops."""

import sys

from fmpy import simulate_fmu

G, HEIGHT, SPEED, FRICTION = 10.0, 1.0, 3.0, 0.2


def stops(restitution):
    """Where the box stops, m: friction takes its part of the speed at each impact, at most all of it."""
    x, vx, fall = 0.0, SPEED, (2 * HEIGHT / G) ** 0.5
    speed, flight = G * fall, fall
    while speed > 1e-9:
        x += vx * flight
        vx -= min(vx, FRICTION * (1 + restitution) * speed)
        speed *= restitution
        flight = 2 * speed / G
    return x + vx * vx / (2 * FRICTION * G)


def expect(holds, what):
    if not holds:
        print("DOES NOT HOLD: " + what)
        sys.exit(1)


def run(solver, restitution, options):
    """The last row, the number of events, and what is told of a run."""
    rows = simulate_fmu(
        sys.argv[1],
        fmi_type="ModelExchange",
        solver=solver,
        stop_time=5.0,
        record_events=True,
        start_values={"e": restitution},
        **options,
    )
    last = {name: float(rows[name][-1]) for name in rows.dtype.names}
    # An event has two rows more than were asked for.
    events = (len(rows) - 5.0 / options["output_interval"]) / 2
    return last, events, f"{solver}, {options}, e = {restitution}: {events:g} events, {last}"


for restitution in (0.0, 0.5, 0.8):
    place = stops(restitution)
    for tolerance in (1e-4, 1e-5, 1e-6, 1e-8, 1e-10):
        last, events, said = run("CVode", restitution, {"relative_tolerance": tolerance, "output_interval": 0.1})
        expect(events < 60, said)
        expect(last["ball.o.velocity.x"] == 0 and last["ball.o.velocity.y"] == 0, said)
        expect(abs(last["ball.o.position.y"]) < 1e-9, said)
        expect(abs(last["ball.o.position.x"] - place) < 30 * tolerance, f"{said}, expected {place}")
    # Each of Euler's steps lifts a flight by g h^2/2: it ends with the lowest that they can follow, or goes on with that for ever.
    for step in (1e-2, 5e-3, 2e-3, 1e-3, 5e-4):
        last, events, said = run("Euler", restitution, {"step_size": step, "output_interval": step})
        expect(events < 2 / step, said)
        expect(last["ball.o.velocity.x"] == 0 and abs(last["ball.o.velocity.y"]) < 100 * step, said)
        expect(abs(last["ball.o.position.y"]) < 2 * step, said)
        expect(abs(last["ball.o.position.x"] - place) < 20 * step, f"{said}, expected {place}")
print("holds: a box bounces, slides and sticks by CVode and by Euler's steps, whatever the tolerance")
