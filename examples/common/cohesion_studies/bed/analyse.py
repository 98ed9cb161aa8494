# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished case of the fluidised bed: fluidisation curve, characteristic velocities,
plateau and void fraction. Lengths in m, velocities in m/s, pressures in Pa."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cohesion_studies import ergun
from cohesion_studies.case_entries import EntryError, entries, gravity, in_text, particle_step, particle_variables
from cohesion_studies.foam_results import function_table, mesh_size, read_cells, written_times

PACKED_RANGE = (0.1, 0.7)  # of the weight: points on the packed-bed curve; above it a falling bed may still expand
OTHER_RANGES = (0.6, 0.8, 0.9)  # where that range might end as well: what it would change is an error of the velocity
OPEN = 0.9  # of the packed-bed curve: with less pressure the bed has opened
START_UP = 0.3  # s until the bed that was at rest bubbles
PLATEAU = 1.1  # x the packed-bed velocities: the bed is fluidised
SETTLING = 0.2  # share of each step left out


@dataclass(frozen=True)
class Bed:
    """What a case is of: its gas, particles and cells, from its dictionaries, its mesh and its particles' script. Up
    is y."""

    gas_density: float
    gas_viscosity: float  # [Pa s]
    gravity: float  # [m/s2]
    diameter: float
    density: float  # of the particles
    width: float
    height: float  # of the mesh
    depth: float  # from front to back
    across: int  # cells
    up: int
    jet_share: float  # of the plate

    @staticmethod
    def read(case):
        gas, cells = (entries(Path(case) / file) for file in ("constant/transportProperties", "constant/bed"))
        particle = particle_variables(case)
        return Bed(gas["rho"], gas["rho"] * gas["nu"], gravity(case), particle["d"], particle["density"],
                   *mesh_size(case), int(cells["across"]), int(cells["up"]), cells["jetShare"])

    @property
    def node(self):
        """Height of the lowest pressure node, the centres of the lowest cells."""
        return self.height / self.up / 2

    def minimum_fluidisation(self, void_fraction):
        """By Ergun's equation."""
        return ergun.minimum_fluidisation(void_fraction, self.diameter, self.density, self.gas_density,
                                          self.gas_viscosity, self.gravity)


@dataclass
class Step:
    """Averages over one step of the gas velocity, its first fifth left out."""

    velocity: float
    start: float
    end: float
    ratio: float  # pressure drop x area / weight above the lowest pressure node [1]
    ratio_error: float  # standard deviation of its mean over five blocks [1]; of bubbles, slower than that, too small
    rising: bool


@dataclass
class Velocities:
    """The three characteristic velocities and the overshoot [1], each with its standard error."""

    falling: tuple
    rising: tuple
    opening: tuple
    overshoot: tuple
    opens: Step | None  # the step with the pressure maximum at which the bed opens


def read_columns(file):
    return np.loadtxt(file, comments="#", ndmin=2)


@dataclass
class Traces:
    """One array per quantity, over the time steps."""

    time: np.ndarray
    velocity: np.ndarray  # superficial
    drop: np.ndarray  # what the particles cause of the pressure at the lowest node
    weight: np.ndarray  # of the particles above the lowest node [N]
    height: np.ndarray  # twice the mean height of the particles
    carried: np.ndarray  # vertical force of plate and side walls on the particles [N]
    sides: np.ndarray  # that of the side walls alone
    plate_pull: np.ndarray  # that of the plate's attraction alone; nan: the engine does not tell
    area: float  # of the plate [m2]

    @property
    def ratio(self):
        return self.drop * self.area / self.weight


def read_traces(case):
    case = Path(case)
    pressure = read_columns(function_table(case, "lowestPressure", "volFieldValue.dat"))
    jets = read_vectors(function_table(case, "jetVelocity", "surfaceFieldValue.dat"))
    bed, walls = (read_columns(case / file) for file in ("bed.dat", "walls.dat"))
    step, of = particle_step(case), Bed.read(case)
    time = pressure[:, 0]
    # p is that of the gas with its own weight; the pressure drop is what the particles cause.
    drop = of.gas_density * (pressure[:, 1] - of.gravity * (of.height - of.node))
    weight, height, *_ = (np.interp(time, bed[:, 0] * step, column) for column in bed[:, 1:].T)
    carried, sides, *pull = (np.interp(time, walls[:, 0] * step, column) for column in walls[:, 1:].T)
    return Traces(time, jets[:, 2] * of.jet_share, drop, weight, height, carried, sides,
                  pull[0] if pull else np.full(len(time), np.nan), of.width * of.depth)


def read_vectors(file):
    lines = [line for line in Path(file).read_text().splitlines() if not line.startswith("#")]
    return np.array([[float(x) for x in re.sub(r"[()]", " ", line).split()] for line in lines])


def read_schedule(case):
    """(start, end, velocity) of the steps in constant/schedule. Raises EntryError without any."""
    file = Path(case) / "constant/schedule"
    text = file.read_text()
    rows = re.findall(r"\(\s*([\d.e+-]+)\s+\(\s*\S+\s+([\d.e+-]+)\s+\S+\)\s*\)", text)
    points = [(float(t), float(v)) for t, v in rows]
    steps = [(t0, t1, v0) for (t0, v0), (t1, v1) in zip(points, points[1:]) if v0 == v1]
    if not steps:
        raise EntryError(f"{file}: no step of the gas velocity: two points '(time (0 velocity 0))' with the same "
                         "velocity, one after the other")
    return steps


def curve(case):
    """The fluidisation curve: a list of Step."""
    traces = read_traces(case)
    schedule = read_schedule(case)
    lowest = min(range(len(schedule)), key=lambda i: schedule[i][2])
    steps = []
    for i, (start, end, velocity) in enumerate(schedule):
        inside = ((traces.time > start + SETTLING * (end - start)) & (traces.time <= end))
        blocks = [block.mean() for block in np.array_split(traces.ratio[inside], 5)]
        steps.append(Step(velocity, start, end, float(np.mean(blocks)),
                          float(np.std(blocks, ddof=1) / np.sqrt(5)), i > lowest))
    return steps


def packed_points(steps, upto):
    """Those of one branch on the packed-bed curve, from the slowest up to the first that leaves PACKED_RANGE, here up
    to `upto`, or has no more pressure than the one before; beyond it the bed moves."""
    packed = []
    for step in sorted(steps, key=lambda s: s.velocity):
        if step.ratio >= upto or packed and step.ratio <= packed[-1].ratio:
            break
        if step.ratio > PACKED_RANGE[0]:
            packed.append(step)
    return packed


@dataclass
class PackedCurve:
    """a U + b U^2 (Ergun's form, viscous and inertial) through packed_points(); nan of fewer than four."""

    coefficients: np.ndarray
    covariance: np.ndarray

    @classmethod
    def through(cls, packed):
        if len(packed) < 4:
            return cls(np.full(2, np.nan), np.full((2, 2), np.nan))
        u, y = np.array([(s.velocity, s.ratio) for s in packed]).T
        terms = np.stack([u, u**2], axis=1)
        found, *_ = np.linalg.lstsq(terms, y, rcond=None)
        spread = np.sqrt(((y - terms @ found) ** 2).sum() / (len(u) - 2))
        return cls(found, spread**2 * np.linalg.inv(terms.T @ terms))

    def at(self, velocity):
        return float(self.coefficients @ (velocity, velocity**2))

    def meets_weight(self):
        """(velocity, standard error): the error of the curve there, divided by its slope."""
        a, b = self.coefficients
        if not a**2 + 4 * b > 0:
            return np.nan, np.nan
        velocity = (-a + np.sqrt(a**2 + 4 * b)) / (2 * b)
        at = np.array([velocity, velocity**2])
        return float(velocity), float(np.sqrt(at @ self.covariance @ at) / (a + 2 * b * velocity))


def packed_curve_meets_weight(steps):
    """Where the packed-bed curve of one branch reaches the weight: (velocity, error). The error is that of the fit and,
    added in squares, the largest change of the velocity when the points end at another of OTHER_RANGES."""
    velocity, error = PackedCurve.through(packed_points(steps, PACKED_RANGE[1])).meets_weight()
    others = [PackedCurve.through(packed_points(steps, end)).meets_weight()[0] for end in OTHER_RANGES]
    changes = [abs(other - velocity) for other in others if np.isfinite(other)]
    return velocity, float(np.hypot(error, max(changes, default=0.0)))


def opening(steps):
    """Where the bed opens: the pressure maximum of the rising branch up to its first step that has less than OPEN of
    the packed-bed curve and more than PACKED_RANGE[1] of the weight; later maxima are the bubbles'. At the vertex of
    the parabola through its step and the two beside it when it is the highest of these, else at the step. (its Step,
    (velocity, standard error), (what it has above the weight [1], standard error)), the errors from those of the three
    steps; None and nan when the branch ends before the bed opens, or has no packed-bed curve."""
    rising = sorted((s for s in steps if s.rising), key=lambda s: s.velocity)
    packed = PackedCurve.through(packed_points(rising, PACKED_RANGE[1]))
    opened = next((k for k, s in enumerate(rising)
                   if PACKED_RANGE[1] < s.ratio < OPEN * packed.at(s.velocity)), None)
    if opened is None:
        return None, (np.nan, np.nan), (np.nan, np.nan)
    # Not the slowest step: that has less than PACKED_RANGE[1], else there is no packed-bed curve; `opened` has more.
    highest = max(range(opened + 1), key=lambda k: rising[k].ratio)
    three = rising[highest - 1:highest + 2]
    if len(three) < 3 or three[2].ratio > three[1].ratio:
        at = rising[highest]
        return (at, (at.velocity, (at.velocity - rising[highest - 1].velocity) / 2), (at.ratio - 1, at.ratio_error))
    fit = np.linalg.inv(np.vander([s.velocity - three[1].velocity for s in three], 3))
    curvature, slope, ratio = fit @ [s.ratio for s in three]
    errors = [s.ratio_error for s in three]
    place = -slope / (2 * curvature)
    # The vertex is level: where it lies adds nothing to the error of its height.
    height_error = np.linalg.norm(np.array([place**2, place, 1]) @ fit * errors)
    place_error = np.linalg.norm(np.array([2 * place, 1, 0]) @ fit * errors) / abs(2 * curvature)
    return (three[1], (float(three[1].velocity + place), float(place_error)),
            (float(ratio + slope * place / 2 - 1), float(height_error)))


def velocities(steps):
    falling, rising = (packed_curve_meets_weight([s for s in steps if s.rising == branch]) for branch in (False, True))
    opens, velocity, overshoot = opening(steps)
    return Velocities(falling, rising, velocity, overshoot, opens)


def plateau(case, found):
    """Fluidised state: mean of pressure drop x area / weight, and of the same with the force of plate and side walls
    added, each with its standard error. All times with a gas velocity above PLATEAU x both packed-bed velocities, or
    the one that is known, the start-up left out; the errors from means over blocks of 0.2 s, about a period of the
    bubbles. nan when there are no two such times, or no such velocity."""
    traces = read_traces(case)
    known = [velocity for velocity, _ in (found.falling, found.rising) if not np.isnan(velocity)]
    fluidised = (traces.time > START_UP) & (traces.velocity > PLATEAU * max(known, default=np.inf))
    duration = np.count_nonzero(fluidised) * (traces.time[1] - traces.time[0])
    if np.count_nonzero(fluidised) < 2:
        return (np.nan, np.nan), (np.nan, np.nan)

    def mean_and_error(values):
        blocks = [b.mean() for b in np.array_split(values[fluidised], max(2, round(duration / 0.2)))]
        return float(np.mean(blocks)), float(np.std(blocks, ddof=1) / np.sqrt(len(blocks)))

    return (mean_and_error(traces.ratio),
            mean_and_error(traces.ratio + traces.carried / traces.weight))


def loop_times(case, *parts):
    """Wall clock times [s] of parts of the solver's time loop, and its number of steps, from its log: a list. Raises
    EntryError for the log of a solver that was killed, or of another one."""
    file = Path(case) / "log.cohesiveBedFoam"
    log = file.read_text()
    what = "summary '{} ... s, ... %', with which cohesiveBedFoam ends: figures are of a case that has run to its end"
    seconds = [float(in_text(rf"^\s*{part}\s+(\S+) s,", file, log, what.format(part))) for part in parts]
    in_text(r"^(Time) = ", file, log, "line 'Time = ...'")
    return [*seconds, len(re.findall(r"^Time = ", log, re.M))]


def solver_seconds(case):
    """Wall clock time of the solver's time loop, and of the particle engine in it, from its log."""
    return tuple(loop_times(case, "all", "particles")[:2])


def exchange_milliseconds(case):
    """Of the exchange of gas and particles per gas step, by the clock [ms]."""
    seconds, steps = loop_times(case, "exchange")
    return 1e3 * seconds / steps


def pressure_noise(case):
    """How much the pressure at the lowest node jumps in the bubbling bed at the start [1]: root mean square
    of what a value differs by from the mean of the one before and the one after, over the mean pressure drop.
    Pressure is written every second gas step, so that bubbles, of 0.2 to 0.3 s, leave little of it."""
    traces = read_traces(case)
    _, end, _ = read_schedule(case)[0]
    drop = traces.drop[(traces.time > START_UP) & (traces.time <= end)]
    jumps = drop[1:-1] - 0.5 * (drop[:-2] + drop[2:])
    return float(np.sqrt((jumps**2).mean()) / drop.mean())


def packed_void_fraction(case):
    """Mean, standard deviation and standard error of the mean over the cells inside the resting bed: those between the
    lowest row and the last full row below the surface, at the last written time without gas flow. The error is that of
    cells that are independent; what one has too much its neighbours lack, so that it is rather too large."""
    rest = [s for s in read_schedule(case) if s[2] == 0]
    folders = written_times(case)
    written = [t for t in folders if rest and rest[0][0] < t <= rest[0][1] + 1e-3]
    if not written:
        return float("nan"), float("nan"), float("nan")
    traces, of = read_traces(case), Bed.read(case)
    rows = int(np.interp(max(written), traces.time, traces.height) / (of.height / of.up))
    inside = void_fraction(case, folders[max(written)])[1:rows - 1, 1:-1]
    deviation = inside.std(ddof=1)
    return float(inside.mean()), float(deviation), float(deviation / np.sqrt(inside.size))


def void_fraction(case, folder):
    """Of the cells at one of written_times(), an array: rows from the plate up, and in a row from left to right."""
    of = Bed.read(case)
    return read_cells(folder / "voidFraction", of.up * of.across).reshape(of.up, of.across)
