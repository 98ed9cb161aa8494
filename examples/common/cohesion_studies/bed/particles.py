# SPDX-License-Identifier: BSD-3-Clause
"""Reads what the particles of one finished case of the fluidised bed do: mixing, movement, plugs, and what carries
them. Lengths in m, velocities in m/s, forces in N."""

from pathlib import Path

import numpy as np

from cohesion_studies.bed import analyse
from cohesion_studies.bed.analyse import START_UP, read_columns, read_schedule, read_traces
from cohesion_studies.cavities import cavities, width_of
from cohesion_studies.foam_results import function_table

MOVEMENT_AT = 0.77  # m/s: where the thesis compares the movement of the particles
MIXING_OVER = 0.4  # s: some two bubbles, of 0.2 to 0.3 s each; mixing is not read of less
BUBBLING = 0.9  # m/s: with as much gas the bed without cohesion bubbles
# Void fraction of a row of cells: a row of the bed has less than DENSE; one with more than EMPTY holds less than a
# tenth of the particles of a packed row.
DENSE, EMPTY = 0.75, 0.95
CAVITY = 0.8  # void fraction above which a cell belongs to a bubble or a gap


def slowest_step(case):
    """(start, end, velocity) of the step with the slowest gas, at which the falling branch ends."""
    return min(read_schedule(case), key=lambda step: step[2])


def mixing(case):
    """(how fast the particles mix in the first step of the gas velocity, the start-up left out [1/s], how mixed they
    are in the slowest [1]): slope of the straight line through Lacey's index over time, nan when that step has less
    than MIXING_OVER; and its mean. The index is 0 at the start and 1 when mixed: cells that hold two layers give it
    a little before, which is taken off."""
    time, index = read_columns(function_table(case, "mixing", "mixingIndex.dat"))[:, :2].T
    index = (index - index[0]) / (1 - index[0])
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
             for end, over, mean, *_ in read_columns(function_table(case, "movement", "particleMovement.dat"))
             if end <= rest]
    nearest = min(found, key=lambda pair: abs(pair[1] - MOVEMENT_AT), default=(np.nan, np.nan))
    return float(nearest[0]), float(nearest[1])


def bubbling_times(case):
    """Void fractions of the written times, the start-up left out, with at least BUBBLING of gas."""
    traces = read_traces(case)
    return [analyse.void_fraction(case, folder) for time, folder in analyse.written_times(case).items()
            if time > START_UP and np.interp(time, traces.time, traces.velocity) >= BUBBLING - 1e-3]


def plugging(case):
    """Share of bubbling_times() at which a plug rises [1]: a row of cells that is EMPTY all across lies below a row of
    the bed."""
    split = []
    for cells in bubbling_times(case):
        rows = cells.mean(axis=1)
        bed = np.flatnonzero(rows < DENSE)
        split.append(bool(len(bed)) and bool((rows[:bed[-1]] > EMPTY).any()))
    return float(np.mean(split)) if split else float("nan")


def widest_cavity(case):
    """Mean over bubbling_times() of the width of the widest cavity in the bed, over the bed's [1]: 1 is a gap from wall
    to wall, through which particles may rain."""
    widths = [max((width_of(members, cells.shape[1]) for members in cavities(cells > CAVITY)), default=0.0)
              for cells in bubbling_times(case)]
    return float(np.mean(widths)) if widths else float("nan")


def forces(case, step):
    """Mean vertical forces on all particles in a Step, the share of it that its averages leave out left out too, over
    their weight [1]: "drag", "pressure", "sides" (friction), "plate" (contact and attraction together), "plate_pull"
    (of it, the attraction; nan with LIGGGHTS, which does not tell); "gain", of momentum per time; "unclosed", what is
    left of drag + pressure + sides + plate - 1 - gain: the screen over the outlet, and a particle step at the ends. All
    are of the same times, those of the function object's averages that lie within. Upwards is positive. nan without a
    step."""
    unknown = dict.fromkeys(("drag", "pressure", "sides", "plate", "plate_pull", "gain", "unclosed"), float("nan"))
    if step is None:
        return unknown
    begin = step.start + analyse.SETTLING * (step.end - step.start)
    rows = read_columns(function_table(case, "forces", "forceBudget.dat"))
    inside = (rows[:, 0] - rows[:, 1] >= begin - 1e-9) & (rows[:, 0] <= step.end + 1e-9)
    if not inside.any():
        return unknown
    # Time, over, and x, y, z each of gravity, drag, pressure, others, gain.
    gravity, drag, pressure, _, gain = np.average(rows[inside][:, 3::3], axis=0, weights=rows[inside, 1])
    first, last = (rows[inside, 0] - rows[inside, 1])[0], rows[inside, 0][-1]
    walls = read_columns(Path(case) / "walls.dat")  # a row: mean over the particle steps since the row before
    time = walls[:, 0] * analyse.particle_step(case)
    within = (time > first + 1e-9) & (time <= last + 1e-9)
    carried, sides, *pull = walls[within, 1:].mean(axis=0)
    pull = pull[0] if pull else float("nan")
    found = {"drag": drag, "pressure": pressure, "sides": sides, "plate": carried - sides, "plate_pull": pull,
             "gain": gain, "unclosed": drag + pressure + carried + gravity - gain}
    return {name: float(force / -gravity) for name, force in found.items()}
