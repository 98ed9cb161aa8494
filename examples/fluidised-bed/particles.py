# SPDX-License-Identifier: BSD-3-Clause
"""Reads what the particles of one finished case of the fluidised bed do: mixing, movement, plugs, and what carries
them. Lengths in m, velocities in m/s, forces in N."""

from pathlib import Path

import numpy as np

import analyse
from analyse import START_UP, read_columns, read_schedule, read_traces

MOVEMENT_AT = 0.77  # m/s: where the thesis compares the movement of the particles
MIXING_OVER = 0.4  # s: some four bubbles, of 0.1 s each; mixing is not read of less
BUBBLING = 0.9  # m/s: with as much gas the bed without cohesion bubbles
# Void fraction of a row of cells: a row of the bed has less than DENSE; one with more than EMPTY holds less than a
# tenth of the particles of a packed row.
DENSE, EMPTY = 0.75, 0.95


def slowest_step(case):
    """(start, end, velocity) of the step with the slowest gas, at which the falling branch ends."""
    return min(read_schedule(case), key=lambda step: step[2])


def mixing(case):
    """(how fast the particles mix in the first step of the gas velocity, the start-up left out [1/s], how mixed they
    are in the slowest [1]): slope of the straight line through Lacey's index over time, nan when that step has less
    than MIXING_OVER; and its mean."""
    time, index = read_columns(Path(case) / "postProcessing/mixing/0/mixingIndex.dat")[:, :2].T
    _, end, _ = read_schedule(case)[0]
    begin, rest, _ = slowest_step(case)
    first = (time >= START_UP) & (time <= end)
    rate = np.polyfit(time[first], index[first], 1)[0] if end - START_UP >= MIXING_OVER else np.nan
    return float(rate), float(index[(time > begin) & (time <= rest)].mean())


def movement(case):
    """(mean movement of the particles [m], mean gas velocity [m/s]) of that interval on the falling branch whose
    velocity is nearest to MOVEMENT_AT; nan when the branch holds none."""
    traces = read_traces(case)
    rest, _, _ = slowest_step(case)
    found = [(mean, traces.velocity[(traces.time > end - over) & (traces.time <= end)].mean())
             for end, over, mean, *_ in read_columns(Path(case) / "postProcessing/movement/0/particleMovement.dat")
             if end <= rest]
    nearest = min(found, key=lambda pair: abs(pair[1] - MOVEMENT_AT), default=(np.nan, np.nan))
    return float(nearest[0]), float(nearest[1])


def plugging(case):
    """Share of the written times at which a plug rises [1]: with at least BUBBLING of gas, the start-up left out, a row
    of cells that is EMPTY all across lies below a row of the bed."""
    traces = read_traces(case)
    split = []
    for time, folder in analyse.written_times(case).items():
        if time > START_UP and np.interp(time, traces.time, traces.velocity) >= BUBBLING - 1e-3:
            rows = analyse.void_fraction(case, folder).mean(axis=1)
            bed = np.flatnonzero(rows < DENSE)
            split.append(bool(len(bed)) and bool((rows[:bed[-1]] > EMPTY).any()))
    return float(np.mean(split)) if split else float("nan")


def forces(case, step):
    """Mean vertical forces on all particles in a Step, the share of it that its averages leave out left out too, over
    their weight [1]: "gas" (drag and pressure), "sides", "plate" (contact and attraction together), "plate_pull" (of it,
    the attraction; nan with LIGGGHTS, which does not tell), and "gain", of momentum per time; nan without a step.
    Upwards is positive; gas + sides + plate = 1 + gain while no particle hits the screen over the outlet."""
    unknown = dict.fromkeys(("gas", "sides", "plate", "plate_pull", "gain"), float("nan"))
    if step is None:
        return unknown
    begin = step.start + analyse.SETTLING * (step.end - step.start)
    rows = read_columns(Path(case) / "postProcessing/forces/0/forceBudget.dat")
    inside = (rows[:, 0] - rows[:, 1] >= begin - 1e-9) & (rows[:, 0] <= step.end + 1e-9)
    if not inside.any():
        return unknown
    # Time, over, and x, y, z each of gravity, drag, pressure, others, gain.
    gravity, drag, pressure, _, gain = np.average(rows[inside][:, 3::3], axis=0, weights=rows[inside, 1])
    traces = read_traces(case)
    within = (traces.time > begin) & (traces.time <= step.end)
    sides, carried, pull = (trace[within].mean() for trace in (traces.sides, traces.carried, traces.plate_pull))
    found = {"gas": drag + pressure, "sides": sides, "plate": carried - sides, "plate_pull": pull, "gain": gain}
    return {name: float(force / -gravity) for name, force in found.items()}
