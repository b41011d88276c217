"""What the programs of this folder have in common: steps, the clock, a row, peaks."""

import math
import statistics
import time

GRAVITY = 9.81

# Steps, s; they divide the times at which errors are taken.
STEPS = [1e-2, 4e-3, 1e-3, 4e-4, 1e-4]


def seconds(run):
    """CPU time of this process for a run: the median of three, or of one that takes longer than 3 s."""
    times = []
    for _ in range(3):
        begin = time.process_time()
        run()
        times.append(time.process_time() - begin)
        if times[0] > 3.0:
            break
    return statistics.median(times)


def row(scene, program, settings, step, error, run, until, creep=None, gain=None):
    """Prints a row of runs.csv: an error that is no number is left out."""
    number = lambda value: "" if value is None or math.isnan(value) else f"{value:.3e}"
    spent = seconds(run)
    print(f"{scene},{program},{settings},{step:.0e},{number(error)},{spent:.3e},{round(until / step)},{number(creep)},{number(gain)}", flush=True)


def creep(begin, end, time):
    """Speed in um/s."""
    return 1e6 * abs(end - begin) / time


def peaks(values):
    """Maxima after the start. What rises or falls by less than 2 % of the start is noise."""
    found, noise = [], 0.02 * values[0]
    falls, extreme = True, values[0]
    for value in values:
        if falls == (value < extreme):
            extreme = value
        elif abs(value - extreme) > noise:
            if not falls:
                found.append(extreme)
            falls, extreme = not falls, value
    return found


def worst_gain(energies, ratio):
    """The deviation that is largest by its amount of an energy from `ratio` times the one before it, as a fraction."""
    gains = [after / (ratio * before) - 1.0 for before, after in zip(energies, energies[1:])]
    return max(gains, key=abs) if gains else None
